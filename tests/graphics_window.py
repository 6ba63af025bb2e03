"""Runs the window's test on a virtual display: graphics_window.py PROGRAM.

Exits with 77, which CTest counts as skipped, where there is no xvfb-run.
"""

import shutil
import subprocess
import sys


def main():
    runner = shutil.which("xvfb-run")
    if runner is None:
        print("skipped: xvfb-run is not installed (Debian's package xvfb)")
        return 77
    command = [runner, "-a", "-s", "-screen 0 800x600x24", sys.argv[1]]
    return subprocess.run(command, timeout=120, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
