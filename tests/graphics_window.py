"""Runs the window's test on a virtual display: graphics_window.py PROGRAM.

Exits with 77, which CTest counts as skipped, where there is no Xvfb.
"""

import os
import shutil
import subprocess
import sys


def main() -> int:
    if shutil.which("Xvfb") is None:
        print("skipped: Xvfb is not installed (Debian's package xvfb)")
        return 77

    # The server picks a display that is free, and says which once it is ready
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "800x600x24"],
        pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            display = ":" + pipe.readline().strip()
        environment = {**os.environ, "DISPLAY": display}
        return subprocess.run([sys.argv[1]], timeout=120, check=False,
                              env=environment).returncode
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    sys.exit(main())
