#!/usr/bin/env python3
"""The rules of the house, checked on the sources: who may include whom, sizes, words, names at the top level.

usage: check_house.py ROOT     prints file:line: what, and returns 1 if anything is wrong.
"""
import re
import subprocess
import sys
from pathlib import Path

SIMULATION = ["engine/core", "engine/math", "engine/effects", "engine/geometry", "engine/fracture", "engine/physics"]
# A folder may include itself and these.
MAY_INCLUDE = {
    "engine/core": [],
    "engine/math": ["engine/core"],
    "engine/effects": ["engine/core"],
    "engine/geometry": ["engine/core", "engine/math"],
    "engine/fracture": ["engine/core", "engine/math", "engine/geometry", "engine/effects"],
    "engine/physics": ["engine/core", "engine/math", "engine/geometry", "engine/effects", "engine/fracture"],
    "engine/render": ["engine/core", "engine/math", "engine/effects", "engine/geometry"],
    "engine/audio": ["engine/core", "engine/math", "engine/effects"],
    "engine/script": ["engine/core", "engine/math"],
    "engine/replay": ["engine/core"],
    "engine/runtime": ["engine/core", "engine/replay"],
    "game/content": ["engine/core", "engine/math", "engine/effects", "engine/script"],
    "game/sim": SIMULATION + ["engine/script", "engine/replay", "game/content"],
    "game/view": SIMULATION + ["engine/render", "engine/audio", "game/content", "game/sim"],
    "platform": ["engine/core", "engine/math", "engine/audio", "engine/replay", "engine/runtime", "engine/render"],
}
TOP_LEVEL = {"CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "assets", "engine", "game", "platform", "tests", "tools"}
LONGEST_FILE = 600
CODE = {".h", ".cpp", ".c", ".py", ".lua", ".frag", ".vert", ".glsl", ".sh", ".js", ".java"}
# Spelled in halves so that this file passes its own rule.
UNFINISHED = re.compile(r"\b(" + "|".join(["TO" + "DO", "FIX" + "ME", "XX" + "X", "not " + "implemented", "place" + "holder"]) + r")\b")
# Eigen's only doors: our type file and the precompiled list.
EIGEN = re.compile(r"#\s*include\s*<Eigen|<unsupported/Eigen")
EIGEN_DOORS = {"engine/math/types.h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"')
# libm beside sqrt gives different bits per C library; engine/math/trig.h has the rest.
LIBM = re.compile(r"\bstd::(sin|cos|tan|asin|acos|atan|atan2|exp|exp2|log|log2|log10|pow|cbrt|hypot|fma|sinh|cosh|tanh)\s*\(")
UNSTABLE = re.compile(r"\bstd::(unordered_map|unordered_set|normal_distribution|uniform_real_distribution)\b")


def tracked(root):
    """Files git knows or would add; every file where there is no git."""
    try:
        out = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True, check=True)
        names = [name for name in out.stdout.splitlines() if (root / name).is_file()]
    except (OSError, subprocess.CalledProcessError):
        names = [str(p.relative_to(root)) for p in root.rglob("*") if p.is_file() and not str(p.relative_to(root)).startswith("build")]
    return sorted(set(names))


def folder_of(name):
    parts = name.split("/")
    if parts[0] == "platform":
        return "platform"
    return "/".join(parts[:2]) if parts[0] in ("engine", "game") else parts[0]


def check_includes(name, lines):
    """Arrows point one way: each folder uses only what stands above it."""
    folder = folder_of(name)
    if folder not in MAY_INCLUDE:
        if folder.startswith(("engine/", "game/")):
            yield 1, f"folder {folder} is not in the design; its place among the folders belongs in tests/house/check_house.py"
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        target = folder_of(match.group(1))
        if "/" not in match.group(1):
            yield number, f'include "{match.group(1)}": expected a path from the root, like "{folder}/{match.group(1)}"'
        elif target != folder and target not in MAY_INCLUDE[folder]:
            yield number, f"{folder} includes {target}; it may include {', '.join(MAY_INCLUDE[folder]) or 'nothing'}"


def check_text(name, lines):
    folder = folder_of(name)
    if len(lines) > LONGEST_FILE:
        yield len(lines), f"{len(lines)} lines, at most {LONGEST_FILE}"
    if Path(name).suffix == ".h" and "#pragma once" not in lines:
        yield 1, "header without #pragma once"
    for number, line in enumerate(lines, 1):
        if UNFINISHED.search(line):
            yield number, f"unfinished: {line.strip()[:80]}"
        if EIGEN.search(line) and name not in EIGEN_DOORS and Path(name).suffix in (".h", ".cpp"):
            yield number, "only engine/math/types.h includes Eigen"
        if re.search(r"\bSDL", line) and (folder.startswith("engine/") or folder == "game/sim"):
            yield number, "SDL stays in platform/"
        if LIBM.search(line) and folder in SIMULATION + ["game/sim", "engine/replay"]:
            yield number, "libm differs between machines: use engine/math/trig.h"
        if UNSTABLE.search(line) and folder in SIMULATION + ["game/sim", "engine/replay"]:
            yield number, "its order or its values differ between libraries"


def includes_of(root, names):
    graph = {}
    for name in names:
        text = (root / name).read_text(errors="replace").splitlines()
        graph[name] = [m.group(1) for m in map(INCLUDE.match, text) if m]
    return graph


def find_cycle(graph):
    """One include cycle as a list of files, or None. Iterative: include chains may be long."""
    state = {}
    for start in sorted(graph):
        if start in state:
            continue
        path, stack = [start], [iter(graph[start])]
        state[start] = "open"
        while stack:
            following = next((n for n in stack[-1] if n in graph), None)
            if following is None:
                state[path.pop()] = "done"
                stack.pop()
            elif state.get(following) == "open":
                return path[path.index(following):] + [following]
            elif following not in state:
                state[following] = "open"
                path.append(following)
                stack.append(iter(graph[following]))
    return None


def check_tree(root):
    names = tracked(root)
    for entry in sorted({name.split("/")[0] for name in names}):
        if entry not in TOP_LEVEL and not entry.startswith("."):
            yield f"{entry}: at the top level stand only {', '.join(sorted(TOP_LEVEL))} and dotfiles"
    for name in names:
        path = root / name
        script = name.startswith("tools/") and path.read_bytes()[:2] == b"#!"
        if Path(name).suffix not in CODE and not script:
            continue
        lines = path.read_text(errors="replace").splitlines()
        for number, what in check_text(name, lines):
            yield f"{name}:{number}: {what}"
        for number, what in check_includes(name, lines):
            yield f"{name}:{number}: {what}"
    headers = [name for name in names if name.endswith(".h")]
    cycle = find_cycle(includes_of(root, headers))
    if cycle:
        yield "include cycle: " + " -> ".join(cycle)


def main():
    problems = list(check_tree(Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()))
    print("\n".join(problems) or "the house is in order")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
