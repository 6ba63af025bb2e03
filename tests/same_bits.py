"""The physics gives the same bits with gcc and clang, unoptimised and optimised.

Builds tests/bits/bits.cpp with the physics of each precision in every way there is here and
compares what they print. The flags are those of cmake/targets.cmake.
"""
import argparse
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COMPILERS = {
    "g++": ["-ffp-contract=off", "-fno-tree-slp-vectorize"],
    "clang++": ["-ffp-contract=off"],
}
LEVELS = [["-O0"], ["-O3", "-march=native"]]  # the two ends: what lies between is like them


def output(compiler: str, level: list[str], precision: str, folder: Path) -> str:
    """What the program prints when it is built in this way."""
    sources = [*sorted((ROOT / "common/physics").glob("*.cpp")), ROOT / "tests/bits/bits.cpp"]
    program = folder / "-".join([compiler, *level, precision]).replace("=", "")
    subprocess.run([compiler, "-std=c++20", *COMPILERS[compiler], *level,
                    f"-DTIMESTEP_{precision}", f"-I{ROOT}", *map(str, sources),
                    "-lccd", "-o", str(program)], check=True)
    return subprocess.run([str(program)], check=True, capture_output=True,
                          text=True).stdout


def first_difference(a: str, b: str) -> str:
    pairs = enumerate(zip(a.splitlines(), b.splitlines()), 1)
    return next((f"line {i}: {x} and {y}" for i, (x, y) in pairs if x != y), "length")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.parse_args()
    present = [c for c in COMPILERS if shutil.which(c)]
    # One compiler's plain build will do: all others are compared with it
    builds = [(c, level) for c in present for level in LEVELS
              if c == present[0] or level is not LEVELS[0]]
    wrong = 0
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(2) as pool:
        for precision in ("SINGLE", "DOUBLE"):
            texts = list(pool.map(lambda b: output(*b, precision, Path(name)), builds))
            for build, text in zip(builds, texts):
                same = text == texts[0]
                wrong += not same
                what = "same" if same else first_difference(texts[0], text)
                print(precision.lower(), build[0], *build[1], what)
    if len(present) < len(COMPILERS):
        print("only", *present, "found: compilers were not compared")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
