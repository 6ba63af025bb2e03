"""Fills everything between weave markers in the text, from sources and results.

A marker is an HTML comment, what it stands for follows up to the closing comment:

    <!-- weave: code common/physics/euler.cpp explicit_euler --> … <!-- /weave -->

docs/weave.md says what there is. `--check` changes nothing and names what is stale.
"""
from __future__ import annotations

import argparse
import os
import re
import shlex
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import figures
import pictures
import weave_bench
import weave_code
import weave_notation
import weave_study
import weave_table
from weave_marker import INLINE, Place, replace_all
from weave_runs import ROOT, Chapter, Run, WeaveError, look_up, machine, written


@dataclass
class Weaver:
    """Fills markers; `options` are those of the command line."""

    root: Path
    options: argparse.Namespace
    chapters: dict[str, Chapter] = field(default_factory=dict)
    stale: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    # --- names ------------------------------------------------------------------------

    def chapter(self, place: Place, name: str) -> tuple[Chapter, str]:
        """The chapter that a name belongs to: NAME of this one, or CHAPTER:NAME."""
        of, colon, rest = name.partition(":")
        folder = self.root / "chapters" / of if colon else place.file.parent
        if folder == self.root or not folder.is_dir():
            raise WeaveError(f"'{name}' must name a chapter, as in 01-particles:NAME")
        if folder.name not in self.chapters:
            self.chapters[folder.name] = Chapter(folder, self.options.build,
                                                 self.options.store)
        return self.chapters[folder.name], rest if colon else name

    def run(self, place: Place, name: str) -> Run:
        chapter, name = self.chapter(place, name)
        return chapter.run(name)

    def number(self, place: Place, run: Run) -> object:
        """The value at a marker's path; over=PATH divides by another, *N scales."""
        def at(path: str) -> object:
            for start in (run.results, run.results["metrics"], run.results["cost"]):
                try:
                    return look_up(start, path)
                except KeyError:
                    continue
            raise WeaveError(f"the results of '{run.name}' hold no '{path}'")

        value = at(place.word(2, "a path"))
        if "over" in place.options:
            value /= at(place.options["over"])
        return value if place.scale is None else value * place.scale

    # --- kinds ------------------------------------------------------------------------

    def code(self, place: Place) -> str:
        file = place.word(1, "a file")
        text = weave_code.excerpt(self.root / file, place.words[2:])
        link = os.path.relpath(self.root / file, place.file.parent)
        keywords = ("+doc", "struct", "lines")
        what = next((w for w in place.words[2:] if w not in keywords), "")
        name = "" if "lines" in place.words else f", `{what.partition('#')[0]}`"
        return f"*[{file}]({link}){name}*\n\n```cpp\n{text}\n```"

    def value(self, place: Place) -> str:
        value = self.number(place, self.run(place, place.word(1, "a run")))
        return written(value, place.format(".3g") if not isinstance(value, str) else "")

    def timing(self, place: Place) -> str:
        if not self.options.timings:
            return self.kept(place, "a number", r"[−-]?[\d.,]+( × 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?")
        chapter, name = self.chapter(place, place.word(1, "a run"))
        run = chapter.run_with(name, chapter.runs[chapter.expand(name)[0]], fresh=True)
        return written(self.number(place, run), place.format(".2g"))

    def machine(self, place: Place) -> str:
        if not self.options.timings:
            return self.kept(place, "the machine's name", r".*\w.*")
        return machine()

    def kept(self, place: Place, what: str, pattern: str) -> str:
        if not re.fullmatch(pattern, place.old.strip()):
            self.say_stale(place, f"{what} is missing (weave.py --timings measures)")
        return place.old

    def table(self, place: Place) -> str:
        names = place.word(1, "a run").split(",")
        runs = []
        for name in names:
            chapter, own = self.chapter(place, name)
            runs += [chapter.run(one) for one in chapter.expand(own)]
        return weave_table.table(runs, place.options)

    def output(self, place: Place) -> str:
        chapter, name = self.chapter(place, place.word(1, "a command"))
        return chapter.output(name)

    def figure(self, place: Place) -> str:
        chapter, name = self.chapter(place, place.word(1, "a figure"))
        alt = place.word(2, "alt text that states its finding, in quotes")
        note = figures.bring_up_to_date(chapter, name, self.options.check)
        if note.startswith("stale"):
            self.say_stale(place, note)
        elif note and note not in self.notes:
            self.notes.append(note)
        path = chapter.folder / "figures" / f"{name}.svg"
        return f"![{alt}]({os.path.relpath(path, place.file.parent)})"

    def picture(self, place: Place) -> str:
        chapter, name = self.chapter(place, place.word(1, "a scene"))
        alt = place.word(2, "alt text, in quotes")
        if self.options.pictures:
            pictures.render(chapter, name)
        if not pictures.is_fresh(chapter, name):
            self.say_stale(place, "its picture is old (weave.py --pictures renders it)")
        path = os.path.relpath(pictures.path(chapter, name), place.file.parent)
        return f"![{alt}]({path})"

    def notation(self, place: Place) -> str:
        text = place.file.read_text(encoding="utf-8")
        return weave_notation.table(place.file, text, self.root)

    def bench(self, place: Place) -> str:
        return weave_bench.table(self.root, place)

    def measured(self, place: Place) -> str:
        return weave_bench.number(self.root, place)

    def study(self, place: Place) -> str:
        return weave_study.table(self.root, place)

    def studied(self, place: Place) -> str:
        return weave_study.number(self.root, place)

    # --- files ------------------------------------------------------------------------

    def say_stale(self, place: Place, why: str) -> None:
        what = shlex.join(word for word in place.words[:3] if len(word) < 50)
        where = f"{place.file.relative_to(self.root)}:{place.line}"
        line = f"{where}: weave: {what}: {why}"
        if line not in self.stale:
            self.stale.append(line)

    def fill(self, place: Place) -> str:
        new = getattr(self, place.kind)(place)
        new = new if place.kind in INLINE else f"\n\n{new}\n\n"
        if new != place.old:
            shown = f": '{place.old}' should be '{new}'" if place.kind in INLINE else ""
            self.say_stale(place, "stale" + shown)
        return new

    def weave(self, file: Path) -> str:
        def complain(line: int, what: str) -> None:
            self.errors.append(f"{file.relative_to(self.root)}:{line}: weave: {what}")

        return replace_all(file, self.fill, complain)

    def prefetch(self, files: list[Path]) -> None:
        """Runs all that is declared and quoted, in parallel; faults are told later."""
        quoted = "\n".join(file.read_text(encoding="utf-8") for file in files)
        jobs = []
        for folder in sorted((self.root / "chapters").glob("[0-9][0-9]-*")):
            place = Place(folder / "README.md", 0, [], {}, "")
            chapter, _ = self.chapter(place, "")
            names = set(re.findall(r"[\w@.=-]+", quoted))
            names.update(*chapter.figures.values())
            declared = {**{run: [run] for run in chapter.runs}, **chapter.sweeps}
            wanted = {run for n in names & declared.keys() for run in declared[n]}
            jobs += [(chapter, run) for run in sorted(wanted)]
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(lambda job: quietly(job[0].run, job[1]), jobs))


def quietly(call, argument: str) -> None:
    try:
        call(argument)
    except WeaveError:
        pass  # told with the file and line of the marker that quotes it


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for option, meaning in (("--check", "change nothing, name what is stale"),
                            ("--timings", "measure timings anew"),
                            ("--pictures", "render pictures anew")):
        parser.add_argument(option, action="store_true", help=meaning)
    parser.add_argument("--root", type=Path, default=ROOT, help=argparse.SUPPRESS)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    options = parser.parse_args(arguments)
    options.root, options.build = options.root.resolve(), options.build.resolve()
    options.store = options.root / "build/weave"
    return finish(Weaver(options.root, options))


def finish(weaver: Weaver) -> int:
    """Weaves every page, says what is to be said and returns the exit code."""
    root, check = weaver.root, weaver.options.check
    pages = (root.glob(each) for each in ("README.md", "chapters/*/README.md"))
    files = [file for found in pages for file in sorted(found)]
    weaver.prefetch(files)
    for file in files:
        old, new = file.read_text(encoding="utf-8"), weaver.weave(file)
        if new != old and check and not weaver.stale:
            weaver.stale.append(f"{file.relative_to(root)}: a marker begins a line")
        elif new != old and not check:
            file.write_text(new, encoding="utf-8")
            print(f"wove {file.relative_to(root)}")
    # What weaving has just brought up to date is no news
    left = [s for s in weaver.stale if check or "(weave.py" in s]
    for line in [*weaver.notes, *weaver.errors, *left]:
        print(line)
    return 2 if weaver.errors else 1 if check and left else 0


if __name__ == "__main__":
    sys.exit(main())
