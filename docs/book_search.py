"""The full-text index of the book's search, from the pages that Doxygen wrote.

Each section of a page is one entry: where it is, the page's title, its own heading, and
its text. docs/book.js reads the list from book_index.js, as a page that is opened from
a file may load a script but nothing else.
"""
from __future__ import annotations

import json
import re
from html import unescape
from pathlib import Path

TITLE = re.compile(r"<title>Timestep: (.*?)(?: (?:File|Namespace|Struct|Class)"
                   r"(?: Template)? Reference)?</title>")
CONTENTS = re.compile(r'<div class="contents">(.*)<!-- contents -->', re.DOTALL)
# What no reader searches for: what stands elsewhere as well, and displayed formulas
SKIPPED_PARTS = re.compile(
    r'<div class="toc">.*?</div>|<table class="memberdecls">.*?</table>'
    r'|<p class="formulaDsp">.*?</p>|<div class="ttc"[^\n]*'
    r"|<a [^>]*>More\.\.\.</a>|<p><a [^>]*>Go to the source code.*?</p>", re.DOTALL)
# What begins a section: a heading of a text, or the name of a documented member
HEADING = re.compile(
    r'<h[1-4](?:>\s*<a class="anchor")? id="(?P<id>[^"]+)">(?P<heading>.*?)</h[1-4]>'
    r'|<h2 class="memtitle"><span class="permalink"><a href="#(?P<member>[^"]+)">'
    r".*?</span>(?P<name>.*?)</h2>", re.DOTALL)
# Lists of what other pages hold, and sources of which there is the documentation
SKIPPED_PAGES = re.compile(r"(_source|-members|_8md)\.html$|^(dir_.*|annotated|files|pages)\.html$")


def plain(html: str) -> str:
    """The words of a piece of a page; a formula in a sentence is its TeX."""
    text = re.sub(r"</?(?:code|em|b|span|a|tt|strong)\b[^>]*>", "", html)
    text = unescape(re.sub(r"<[^<>]*>", " ", text))
    return " ".join(re.sub(r"\\[()\[\]]", " ", text).split())


def entries(name: str, html: str) -> list[list[str]]:
    """Address, page, heading and text of every section of a page."""
    title, contents = TITLE.search(html), CONTENTS.search(html)
    if SKIPPED_PAGES.search(name) or not title or not contents:
        return []
    page, body = plain(title[1]), SKIPPED_PARTS.sub("", contents[1])
    found, start, address, heading = [], 0, name, ""
    for match in HEADING.finditer(body):
        found.append([address, page, heading, plain(body[start:match.start()])])
        address = f"{name}#{match['id'] or match['member']}"
        heading = plain(match["heading"] or match["name"])
        start = match.end()
    return [*found, [address, page, heading, plain(body[start:])]]


def index(pages: dict[Path, str]) -> list[list[str]]:
    return [entry for path, html in sorted(pages.items())
            for entry in entries(path.name, html)]


def script(found: list[list[str]]) -> str:
    rows = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in found)
    return f"window.bookIndex = [\n{rows}\n];\n"
