#!/usr/bin/env python3
"""README.md stays true: every command in its ```sh blocks runs on the files its other blocks show (```xml file=PATH), every path it
names exists, and it is short.

usage: test_readme.py ROOT BUILD
Commands run in order from ROOT, without a display. `tools/test` runs this very test and `--full` has no bound, so they are only looked
up; a game that waits for a window to be closed gets a number of frames.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

LONGEST = 200  # lines
NOT_RUN = {"tools/test", "tools/test --full", "tools/setup"}


def commands(text):
    for block in re.findall(r"^```sh\n(.*?)^```", text, re.S | re.M):
        for line in block.splitlines():
            command = line.split("  #")[0].strip()
            if command and not command.startswith("#"):
                yield command


def write_files(text, root, build):
    for name, content in re.findall(r"^```\w+ file=(\S+)\n(.*?)^```", text, re.S | re.M):
        path = Path(re.sub(r"^build/", f"{build}/", str(name)))
        path = path if path.is_absolute() else root / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)


def named_paths(text):
    """Words in back quotes or links that look like a file or folder of ours."""
    words = re.findall(r"`([a-zA-Z0-9_./-]+)`", text) + re.findall(r"\]\(([a-zA-Z0-9_./-]+)\)", text)
    return sorted({w.rstrip("/") for w in words if "/" in w and not w.startswith(("build/", "/"))})


def run(command, root, build):
    if command in NOT_RUN:
        return None if os.access(root / command.split()[0], os.X_OK) else "no such script"
    command = re.sub(r"\bbuild/", f"{build}/", command)
    if "brittle play" in command:
        command += " --frames 60"
    environment = dict(os.environ, SDL_VIDEODRIVER="offscreen", SDL_AUDIODRIVER="dummy")
    for display in ("DISPLAY", "WAYLAND_DISPLAY"):
        environment.pop(display, None)
    result = subprocess.run(command, shell=True, cwd=root, env=environment, capture_output=True, text=True, timeout=300)
    return None if result.returncode == 0 else f"exit status {result.returncode}\n{result.stdout[-1500:]}{result.stderr[-1500:]}"


def main():
    root, build = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    text = (root / "README.md").read_text()
    problems = []
    if len(text.splitlines()) >= LONGEST:
        problems.append(f"{len(text.splitlines())} lines, expected fewer than {LONGEST}")
    problems += [f"names {path}, which is not there" for path in named_paths(text) if not (root / path).exists()]
    write_files(text, root, build)
    found = list(commands(text))
    if len(found) < 2:
        problems.append("expected at least tools/play and tools/test in ```sh blocks")
    for command in found:
        wrong = run(command, root, build)
        print(("ok      " if wrong is None else "FAILED  ") + command)
        if wrong:
            problems.append(f"{command}: {wrong}")
    print("\n".join("README.md: " + p for p in problems) or f"README.md: {len(found)} commands hold")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
