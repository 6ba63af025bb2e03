"""The pages of the book that nobody writes: sources, and the engine as of each chapter.

A source page shows a file that no other page documents. `common as of chapter N` lists
the files that the chapter adds and what it carries over.
"""
from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from book_text import ROOT, is_chapter, is_source, links, source_page, texts

LANGUAGES = {".cpp": "cpp", ".hpp": "cpp", ".py": "py"}
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


@dataclass
class Chapter:
    """A chapter with the files of common/physics that it introduces."""

    folder: Path
    files: list[Path]

    @property
    def number(self) -> int:
        return int(self.folder.name[:2])

    @property
    def own(self) -> list[Path]:
        return [f for f in sorted(self.folder.iterdir()) if f.suffix in (".hpp", ".cpp")]


def path_of(file: Path) -> str:
    return file.relative_to(ROOT).as_posix()


def chapters() -> list[Chapter]:
    """Every chapter that has a text, with its row of the manifest."""
    manifest = (ROOT / "cmake/manifest.cmake").read_text(encoding="utf-8")
    rows = dict(re.findall(r'^\s*"(\d\d-[\w-]+):([^"]*)"', manifest, re.MULTILINE))
    found = []
    for page in filter(is_chapter, texts()):
        concepts = rows.get(page.parent.name, "").split()
        files = [ROOT / f"common/physics/{concept}{suffix}"
                 for concept in concepts for suffix in (".hpp", ".cpp")]
        found.append(Chapter(page.parent, [f for f in files if f.is_file()]))
    return found


def lines_of_code(files: list[Path]) -> int:
    """Lines that hold more than a comment."""
    texts = (COMMENT.sub("", file.read_text(encoding="utf-8")) for file in files)
    return sum(bool(line.strip()) for text in texts for line in text.splitlines())


def brief(file: Path) -> str:
    """The first sentence of a file's comment."""
    found = re.search(r"@file\n((?:///.*\n)+)", file.read_text(encoding="utf-8"))
    text = re.sub(r"\s*///\s*", " ", found[1]).strip() if found else ""
    return re.split(r"(?<=\.)\s", text)[0]


# --- sources --------------------------------------------------------------------------

def source_files(found: list[Chapter]) -> list[Path]:
    """The sources that chapters introduce, hold or link to, in the order of chapters."""
    files: list[Path] = []
    for chapter in found:
        files += chapter.files + chapter.own
    for page in texts():
        files += links(page.read_text(encoding="utf-8"), page)
    return list(filter(is_source, dict.fromkeys(files)))


def source(file: Path) -> str:
    language = LANGUAGES.get(file.suffix, "")
    text = file.read_text(encoding="utf-8").rstrip()
    return (f"# {path_of(file)} {{#{source_page(path_of(file))}}}\n\n"
            f"````{language}\n{text}\n````\n")


def source_list(files: list[Path]) -> str:
    entries = "".join(f"- \\subpage {source_page(path_of(file))}\n" for file in files)
    return ("# Sources {#sources}\n\nWhat the chapters show and link to, whole. Headers of "
            f"`common` are documented under *Files*.\n\n{entries}")


# --- the engine as of a chapter ---------------------------------------------------------

def link(file: Path) -> str:
    path = path_of(file)
    return f"[{file.name}](@ref {source_page(path) if is_source(file) else path})"


def counted(files: list[Path]) -> str:
    return f"{len(files)} files with {lines_of_code(files):,} lines of code"


def added(chapter: Chapter) -> str:
    """A row for each concept: its header and, if there is one, its source."""
    concepts = {file.stem: [f for f in chapter.files if f.stem == file.stem]
                for file in chapter.files}
    rows = [f"| {', '.join(map(link, files))} | {brief(files[0])} "
            f"| {lines_of_code(files)} |" for files in concepts.values()]
    head = ["| files | what they hold | lines of code |", "|---|---|---:|"]
    return "\n".join(head + rows)


def carried_over(earlier: list[Chapter]) -> str:
    if not earlier:
        return "This is the first chapter: nothing was there before it."
    rows = [f"| {before.number} | {', '.join(map(link, before.files))} "
            f"| {lines_of_code(before.files)} |" for before in earlier]
    return "\n".join([
        "All of this is as its own chapter shows it, untouched: no file may include what a "
        "later chapter introduces, and a test walks the includes.",
        "", "| chapter | files, untouched | lines of code |", "|---:|---|---:|", *rows])


def engine(chapter: Chapter, earlier: list[Chapter]) -> str:
    before = [file for one in earlier for file in one.files]
    own = ", ".join(map(link, chapter.own))
    return "\n\n".join([
        f"# common as of chapter {chapter.number} {{#common-{chapter.folder.name}}}",
        f"Chapter {chapter.number} adds {counted(chapter.files)} to `common/physics`, "
        f"which then has {counted(before + chapter.files)}.",
        "## What the chapter adds {#added-" + chapter.folder.name + "}", added(chapter),
        "## What it carries over {#carried-" + chapter.folder.name + "}",
        carried_over(earlier),
        "## Its program {#program-" + chapter.folder.name + "}",
        f"The program of the chapter is in {counted(chapter.own)}: {own}. It also uses "
        "`common/chapter` and `common/graphics`, which all chapters share."]) + "\n"


def pages() -> dict[str, str]:
    """Every generated page by its name."""
    found = chapters()
    files = source_files(found)
    pages = {source_page(path_of(file)): source(file) for file in files}
    pages["sources"] = source_list(files)
    for i, chapter in enumerate(found):
        pages[f"common-{chapter.folder.name}"] = engine(chapter, found[:i])
    return pages
