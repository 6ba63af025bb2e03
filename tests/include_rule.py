"""A chapter sees only what it or an earlier chapter introduced.

Walks the real include graph of the sources and compares it with cmake/manifest.cmake.
Given --self-test, shows that each rule finds a planted violation.
"""
from __future__ import annotations

import argparse
import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
# The physics knows no files, clocks, streams, threads, nor hidden randomness
FOREIGN_TO_PHYSICS = {"chrono", "filesystem", "fstream", "iostream", "random", "thread"}


def manifest(root: Path) -> list[tuple[str, list[str]]]:
    """Each chapter with the concepts that it introduces, in order."""
    text = (root / "cmake/manifest.cmake").read_text(encoding="utf-8")
    rows = re.findall(r'^\s*"([0-9][0-9]-[\w-]+):([^"]*)"', text, re.MULTILINE)
    return [(chapter, concepts.split()) for chapter, concepts in rows]


def includes(file: Path) -> list[tuple[str, str]]:
    return INCLUDE.findall(file.read_text(encoding="utf-8"))


def resolve(root: Path, file: Path, name: str) -> Path | None:
    """The repository's file that a quoted include means, if it is one of ours."""
    found = (p for p in (root / name, file.parent / name) if p.is_file())
    return next(found, None)


def reached(root: Path, file: Path) -> set[Path]:
    """Every file of ours that a file includes, directly or through others."""
    seen: set[Path] = set()
    waiting = [file]
    while waiting:
        one = waiting.pop()
        quoted = (name for quote, name in includes(one) if quote == '"')
        for target in filter(None, (resolve(root, one, name) for name in quoted)):
            target = target.resolve()
            if target not in seen:
                seen.add(target)
                waiting.append(target)
    return seen


def sources(folder: Path) -> list[Path]:
    return sorted(f for f in folder.rglob("*") if f.suffix in (".hpp", ".cpp"))


def introduced_by(root: Path) -> tuple[dict[Path, int], list[str]]:
    """The number of the chapter that introduces each file; faults of the manifest."""
    faults, order = [], {}
    physics = root / "common/physics"
    for index, (chapter, concepts) in enumerate(manifest(root)):
        for concept in concepts:
            files = [f for f in (physics / f"{concept}.hpp", physics / f"{concept}.cpp")
                     if f.is_file()]
            if not files:
                faults.append(f"manifest: {concept} of {chapter} is no file")
            for file in files:
                if file in order:
                    faults.append(f"manifest: {concept} is introduced twice")
                order[file] = index
    faults += [f"manifest: no chapter introduces {f.relative_to(root)}"
               for f in sources(physics) if f not in order]
    return order, faults


def chapter_faults(root: Path, order: dict[Path, int]) -> list[str]:
    names = [chapter for chapter, _ in manifest(root)]
    checked = dict(order)
    for index, name in enumerate(names):
        checked.update({file: index for file in sources(root / "chapters" / name)})
    faults = []
    for file, index in checked.items():
        for target in sorted(reached(root, file)):
            if order.get(target, -1) > index:
                who = f"{file.relative_to(root)} (chapter {names[index]})"
                whom = f"{target.relative_to(root)} of {names[order[target]]}"
                faults.append(f"{who} reaches {whom}")
    return faults


def layer_faults(root: Path) -> list[str]:
    """Physics and graphics know nothing of each other, nor of what is built on them."""
    forbidden = {"physics": ("common/graphics", "common/chapter", "chapters"),
                 "graphics": ("common/physics", "common/chapter", "chapters")}
    faults = []
    for layer, others in forbidden.items():
        for file in sources(root / "common" / layer):
            for target in sorted(reached(root, file)):
                where = target.relative_to(root)
                if where.as_posix().startswith(tuple(other + "/" for other in others)):
                    faults.append(f"{file.relative_to(root)} reaches {where}")
    for file in sources(root / "common/physics"):
        faults += [f"{file.relative_to(root)} includes <{name}>"
                   for quote, name in includes(file)
                   if quote == "<" and name in FOREIGN_TO_PHYSICS]
    return faults


def check(root: Path) -> list[str]:
    root = root.resolve()
    order, faults = introduced_by(root)
    return faults + chapter_faults(root, order) + layer_faults(root)


# --- the test of the test -------------------------------------------------------------

SOUND = {
    "cmake/manifest.cmake": 'set(m\n  "01-a: low"\n  "02-b: high"\n)',
    "common/physics/low.hpp": "#include <vector>\n",
    "common/physics/low.cpp": '#include "common/physics/low.hpp"\n',
    "common/physics/high.hpp": '#include "common/physics/low.hpp"\n',
    "common/graphics/draw.hpp": "#include <fstream>\n",
    "common/chapter/run.hpp": '#include "common/graphics/draw.hpp"\n',
    "chapters/01-a/main.cpp": '#include "common/physics/low.hpp"\n#include "own.hpp"\n',
    "chapters/01-a/own.hpp": '#include "common/chapter/run.hpp"\n',
    "chapters/02-b/main.cpp": '#include "common/physics/high.hpp"\n',
}
LOW, HIGH = "common/physics/low.hpp", "common/physics/high.hpp"
DRAW, RUN = "common/graphics/draw.hpp", "common/chapter/run.hpp"
PLANTED = [  # file, a line to add, what must be found
    ("chapters/01-a/main.cpp", f'#include "{HIGH}"', "main.cpp (chapter 01-a)"),
    ("chapters/01-a/own.hpp", f'  # include "{HIGH}"', "main.cpp (chapter 01-a)"),
    ("common/physics/low.cpp", f'#include "{HIGH}"', "low.cpp (chapter 01-a)"),
    ("common/physics/low.cpp", '#include "low.hpp"\n#include <chrono>', "<chrono>"),
    ("common/physics/low.hpp", f'#include "{DRAW}"', "low.hpp reaches"),
    ("common/physics/low.hpp", f'#include "{RUN}"', "low.hpp reaches"),
    ("common/graphics/draw.hpp", f'#include "{LOW}"', "draw.hpp reaches"),
    ("common/graphics/draw.hpp", f'#include "{RUN}"', "draw.hpp reaches"),
    ("common/physics/stray.cpp", "", "no chapter introduces"),
    ("cmake/manifest.cmake", '  "03-c: low"', "introduced twice"),
    ("cmake/manifest.cmake", '  "03-c: none"', "no file"),
]


def plant(root: Path, file: str, line: str) -> None:
    for name, text in SOUND.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    if file:
        with (root / file).open("a", encoding="utf-8") as target:
            target.write(f"\n{line}\n")


def self_test() -> list[str]:
    failures = []
    for file, line, expected in [("", "", ""), *PLANTED]:
        with tempfile.TemporaryDirectory() as scratch:
            plant(Path(scratch), file, line)
            found = check(Path(scratch))
        if bool(found) != bool(file) or not any(expected in f for f in found or [""]):
            failures.append(f"self-test: {file}: {line!r} gave {found}")
    return failures


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--self-test", action="store_true")
    faults = self_test() if parser.parse_args().self_test else check(ROOT)
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
