#!/usr/bin/env python3
"""Every header compiles alone, so the order of includes never matters.

usage: check_headers.py ROOT BUILD
Headers that reach engine/math/types.h get Eigen (and nothing else) from a precompiled header made here: they include it
themselves, so nothing is hidden by it, and a header costs 0.2 s instead of 1.2 s. A header whose sources did not change since it last
passed is skipped (a file of fingerprints in BUILD).
"""
import concurrent.futures
import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from check_house import includes_of, tracked  # noqa: E402

FLAGS = ["-std=c++20", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-Wno-psabi", "-DEIGEN_DONT_VECTORIZE", "-DEIGEN_MPL2_ONLY",
         "-DEIGEN_NO_DEBUG"]
TYPES = "engine/math/types.h"


def package_flags():
    out = subprocess.run(["pkg-config", "--cflags", "eigen3", "sdl2", "lua5.2"], capture_output=True, text=True)
    return [flag.replace("-I", "-isystem", 1) for flag in out.stdout.split()]


def reached(header, graph):
    """The header and every header of ours that it includes, directly or not."""
    seen, todo = set(), [header]
    while todo:
        name = todo.pop()
        if name in seen or name not in graph:
            continue
        seen.add(name)
        todo += graph[name]
    return seen


def fingerprint(root, names, flags):
    digest = hashlib.sha256(" ".join(flags).encode())
    for name in sorted(names):
        digest.update(name.encode() + (root / name).read_bytes())
    return digest.hexdigest()


def compile_alone(root, header, flags, eigen):
    command = ["g++", *flags, f"-I{root}", *(["-include", eigen] if eigen else []), "-fsyntax-only", "-x", "c++", "-"]
    source = f'#include "{header}"\n'
    result = subprocess.run(command, input=source, capture_output=True, text=True, cwd=root)
    return result.returncode == 0, result.stderr


def main():
    root, build = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    work = build / "headers_alone"
    work.mkdir(parents=True, exist_ok=True)
    flags = FLAGS + [f"-I{build}/generated"] + package_flags()
    headers = [n for n in tracked(root) if n.endswith(".h") and n.startswith(("engine/", "game/", "platform/", "tools/"))]
    headers = [n for n in headers if not n.startswith(("platform/android", "platform/web"))]
    graph = includes_of(root, headers)

    passed_file = work / "passed.json"
    passed = json.loads(passed_file.read_text()) if passed_file.exists() else {}
    todo = {}
    for header in headers:
        names = reached(header, graph)
        stamp = fingerprint(root, names, flags)
        if passed.get(header) != stamp:
            todo[header] = (stamp, TYPES in names)

    eigen = work / "eigen.h"
    if any(uses for _, uses in todo.values()):
        eigen.write_text("#include <Eigen/Core>\n#include <Eigen/Geometry>\n")
        subprocess.run(["g++", *flags, "-x", "c++-header", str(eigen), "-o", str(eigen) + ".gch"], check=True)

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = {pool.submit(compile_alone, root, h, flags, str(eigen) if uses else None): h for h, (_, uses) in todo.items()}
        for job in concurrent.futures.as_completed(jobs):
            header, (ok, errors) = jobs[job], job.result()
            if ok:
                passed[header] = todo[header][0]
            else:
                failed += 1
                print(f"{header} does not compile alone:\n{errors}")
    passed_file.write_text(json.dumps(passed, indent=1))
    print(f"{len(headers)} headers, {len(todo)} compiled, {failed} failed")
    return 1 if failed or not headers else 0


if __name__ == "__main__":
    sys.exit(main())
