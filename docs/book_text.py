"""The repository's texts and headers as Doxygen needs them for the book.

Markdown is written for repository hosts. `$…$` and ```math blocks become Doxygen's,
headings get the anchors that a host gives them, with the page's folder before, as
Doxygen's anchors are shared by all pages. Links lead to the pages of the book; what it
does not hold is no link. In headers the namespaces are left out, so that the page of a
file documents what the file declares.
"""
from __future__ import annotations

import os
import re
from html import escape
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Texts of docs that are pages of the book, after the chapters
PAGES = ("extremes",)
API = ("common/physics", "common/graphics", "common/chapter")

PARTS = re.compile(
    r"^```+math\n(?P<display>.*?)^```+$"
    r"|(?P<code>^(?P<fence>```+|~~~+).*?^(?P=fence)[`~]*$"
    r"|(?P<ticks>`+)(?!`).+?(?P=ticks)(?!`))"
    r"|(?<![\\$\w])\$(?P<inline>[^\s$](?:[^$]*[^\s$\\])?)\$(?![\w$])"
    r"|(?P<marker><!--\s*/?weave\b.*?-->)"
    r"|^(?P<level>#+) +(?P<heading>[^\n{]+)$"
    r"|!\[(?P<alt>[^\[\]]*)\]\((?P<image>[^()\s:]+)\)"
    r"|\[(?P<text>[^\[\]]*)\]\((?P<link>[^()\s:]+)\)",
    re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(
    r"^(?:namespace timestep\S* (?:\w+ )?\{|\}  // namespace timestep.*)$", re.MULTILINE)


def texts() -> list[Path]:
    return [ROOT / "README.md", *sorted(ROOT.glob("chapters/*/README.md")),
            *(ROOT / f"docs/{page}.md" for page in PAGES)]


def is_chapter(file: Path) -> bool:
    return file.parent.parent == ROOT / "chapters"


def page_of(file: Path) -> str:
    """The name of a Markdown file's page, which is its file in the book as well."""
    if is_chapter(file):
        return f"chapter-{file.parent.name}"
    return "index" if file.parent == ROOT else file.stem


def source_page(path: str) -> str:
    """The name of the page that shows a source, by its path in the repository."""
    return "source-" + re.sub(r"\W", "-", path)


def is_source(file: Path) -> bool:
    """Whether a file gets a page that shows it."""
    in_api = file.suffix == ".hpp" and file.is_relative_to(ROOT / "common")
    return file.is_file() and file.suffix != ".md" and not in_api


def anchor(file: Path, heading: str) -> str:
    """The page's name, then the heading as repository hosts write it in links."""
    words = re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
    page = file.parent.name if is_chapter(file) else file.stem
    return f"at-{page if file.parent != ROOT else 'home'}-{words}"


def links(text: str, file: Path) -> list[Path]:
    """What a page links to in the repository."""
    return [target_of(file, match["link"])[0] for match in PARTS.finditer(text)
            if match["link"]]


def pictures(text: str, file: Path) -> list[Path]:
    return [target_of(file, match["image"])[0] for match in PARTS.finditer(text)
            if match["image"]]


def target_of(file: Path, link: str) -> tuple[Path, str]:
    path, _, heading = link.partition("#")
    return Path(os.path.normpath(file.parent / path)) if path else file, heading


def linked(file: Path, text: str, link: str) -> str:
    """A link's text, and the page of the book that it leads to, if there is one."""
    target, heading = target_of(file, link)
    text = text.replace("`", "")  # Doxygen takes a link's text as it is
    path = target.relative_to(ROOT).as_posix()
    if heading:
        return f'<a href="{page_of(target)}.html#{anchor(target, heading)}">{text}</a>'
    if target in texts():
        return f"[{text}](@ref {page_of(target)})"
    if path in API:
        return f'<a href="files.html">{text}</a>'
    if target.suffix == ".hpp" and path.startswith("common/"):
        return f"[{text}](@ref {path})"
    return f"[{text}](@ref {source_page(path)})" if is_source(target) else text


def picture(file: Path, alt: str, image: str) -> str:
    path = target_of(file, image)[0].relative_to(ROOT).as_posix()
    return f'<img src="{path}" alt="{escape(alt)}"/>'


def title(file: Path, level: str, heading: str) -> str:
    """A heading. Those of the front page stay out of the tree, which lists chapters."""
    if file.parent == ROOT:
        name, n = anchor(file, heading), len(level) - 1
        return f'<h{n} id="{name}">{heading}</h{n}>' if n else f"# {heading}"
    if level != "#":
        return f"{level} {heading} {{#{anchor(file, heading)}}}"
    heading = heading.replace(". ", ".\N{NO-BREAK SPACE}", 1)  # a title, not a list
    return f"# {heading} {{#{page_of(file)}}}\n\n[TOC]"


def markdown(text: str, file: Path) -> str:
    def replace(match: re.Match) -> str:
        if match["marker"]:  # Doxygen would take the space after it as well
            return ""
        if match["display"] is not None:
            return f"\\f[\n{match['display']}\\f]"
        if match["inline"] is not None:
            return f"\\f${match['inline']}\\f$"
        if match["heading"]:
            return title(file, match["level"], match["heading"])
        if match["image"]:
            return picture(file, match["alt"], match["image"])
        if match["link"]:
            return linked(file, match["text"], match["link"])
        return match[0]

    return PARTS.sub(replace, text)


def header(text: str) -> str:
    return NAMESPACE.sub("", text)


def engine_so_far(chapter: str) -> str:
    """What ends a chapter in the book: the way to its generated page."""
    return (f"\n## The engine so far {{#at-{chapter}-engine}}\n\n"
            f"\\subpage common-{chapter} lists the files that this chapter adds to the "
            "engine, and those that it carries over.\n")


def for_book(file: Path) -> str:
    """A text or a header of the repository as the book has it."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".hpp":
        return header(text)
    end = engine_so_far(file.parent.name) if is_chapter(file) else ""
    return markdown(text, file) + end
