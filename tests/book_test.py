"""The book in build/book is whole: it needs no network, and all that it names is there.

Run after `./timestep book`. Given --self-test, shows that planted faults are found in a
small made-up book.
"""
from __future__ import annotations

import argparse
import json
import re
import sys
import tempfile
from functools import cache
from html import unescape
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).resolve().parent.parent
API = ("common/physics", "common/graphics", "common/chapter")
TAG = re.compile(r"<(a|link|script|img|object|iframe|source|video|use)\s([^>]*)>")
ATTRIBUTE = re.compile(r'([\w:-]+)\s*=\s*"([^"]*)"')
IN_STYLE = re.compile(r"""url\(\s*['"]?([^'")]+)|@import\s+['"]([^'"]+)""")
FORMULA = re.compile(r'\\\(.+\\\)|<p class="formulaDsp">')
TREE_ENTRY = re.compile(r'\[ "(?:[^"\\]|\\.)*", "([^"]+)"')
SEARCHED = ("euler", "energy", "damping_factor")


@cache
def text_of(file: Path) -> str:
    return file.read_text(encoding="utf-8")


@cache
def anchors(file: Path) -> set[str]:
    return set(re.findall(r'\b(?:id|name)="([^"]+)"', text_of(file)))


def leads_nowhere(page: Path, address: str) -> bool:
    """Whether a local address names no file beside the page, or no anchor in it."""
    path, _, anchor = unquote(unescape(address)).partition("#")
    target = page.parent / path if path else page
    inside = ".." not in Path(path).parts and not path.startswith("/")
    if not inside or not target.exists():
        return True
    return bool(anchor) and target.suffix == ".html" and anchor not in anchors(target)


def page_faults(page: Path) -> list[str]:
    faults = []
    for tag, rest in TAG.findall(text_of(page)):
        attributes = dict(ATTRIBUTE.findall(rest))
        if tag == "img" and not attributes.get("alt") and "footer" not in rest:
            faults.append(f"a picture without alt text: {attributes.get('src')}")
        for name in {"href", "src", "data", "xlink:href"} & attributes.keys():
            address = attributes[name]
            remote = re.match(r"\w+:|//", address)
            if remote and tag != "a" and not address.startswith("data:"):
                faults.append(f"loads {address}")
            elif not remote and leads_nowhere(page, address):
                faults.append(f"{address} leads nowhere")
    if FORMULA.search(text_of(page)) and "mathjax/MathJax.js" not in text_of(page):
        faults.append("formulas, but no MathJax to set them")
    return [f"{page.name}: {fault}" for fault in dict.fromkeys(faults)]


def style_faults(file: Path) -> list[str]:
    named = (a or b for a, b in IN_STYLE.findall(text_of(file)))
    return [f"{file.name}: loads {address}" for address in named
            if re.match(r"https?:|//", address)]


def search_faults(book: Path) -> list[str]:
    """Every address of the search exists, and words of the texts are found."""
    listed = text_of(book / "book_index.js")
    entries = json.loads(listed[listed.index("["):listed.rindex("]") + 1])
    faults = [f"search: {address} leads nowhere" for address, *_ in entries
              if leads_nowhere(book / "index.html", address)]
    words = " ".join(word for _, *texts in entries for word in texts).lower()
    return faults + [f"search: nothing is found for {word}" for word in SEARCHED
                     if word not in words]


def missing_pages(book: Path, root: Path) -> list[str]:
    """A page for each chapter, one for the engine as of it, and one for each header."""
    names = [f"{kind}-{page.parent.name}" for kind in ("chapter", "common")
             for page in sorted(root.glob("chapters/*/README.md"))]
    names += [page.stem for page in root.glob("docs/extremes.md")]
    faults = [f"there is no page {name}" for name in names
              if not (book / f"{name}.html").is_file()]
    titles = " ".join(re.findall(r"<title>(.*?)</title>",
                                 " ".join(map(text_of, book.glob("*_8hpp.html")))))
    headers = (f for folder in API for f in sorted((root / folder).glob("*.hpp")))
    return faults + [f"{header.name} has no page" for header in headers
                     if f" {header.relative_to(root)} " not in titles]


def tree_faults(book: Path) -> list[str]:
    addresses = {a for script in book.glob("*.js") if script.name != "book_index.js"
                 for a in TREE_ENTRY.findall(text_of(script))}
    return [f"tree: {address} leads nowhere" for address in sorted(addresses)
            if leads_nowhere(book / "index.html", address)]


def faults_of(book: Path, root: Path) -> list[str]:
    if not (book / "index.html").is_file():
        return [f"there is no book in {book}: run ./timestep book"]
    faults = missing_pages(book, root) + search_faults(book) + tree_faults(book)
    for page in sorted(book.glob("*.html")):
        faults += page_faults(page)
    for style in sorted([*book.glob("*.css"), *book.rglob("*.svg")]):
        faults += style_faults(style)
    return faults


# --- the test of the test -------------------------------------------------------------

SOUND = {
    "book/index.html": '<title>T</title><a href="chapter-01-x.html#one">1</a>'
                       '<a href="https://example.org">far</a>',
    "book/chapter-01-x.html": '<h1 id="one">1</h1><img src="p.svg" alt="it falls"/>'
                              '<script src="mathjax/MathJax.js"></script>\\(x\\)',
    "book/common-01-x.html": "", "book/mathjax/MathJax.js": "",
    "book/a_8hpp.html": "<title>Timestep: common/physics/a.hpp File Reference</title>",
    "book/p.svg": "<svg/>", "book/book.css": "p { color: red; }",
    "book/navtree.js": '[ "One", "chapter-01-x.html#one", null ]',
    "book/book_index.js": 'window.bookIndex = [["chapter-01-x.html#one", "1", "Energy", '
                          '"Euler damping_factor"]];',
    "chapters/01-x/README.md": "", "common/physics/a.hpp": "",
}
PLANTED = [  # a file, what is added to it (nothing: it is taken away), what is found
    ("book/index.html", "", "no book"),
    ("book/common-01-x.html", "", "no page common-01-x"),
    ("book/mathjax/MathJax.js", "", "MathJax.js leads nowhere"),
    ("book/a_8hpp.html", "", "a.hpp has no page"),
    ("book/a_8hpp.html", "\\(y\\)", "no MathJax"),
    ("book/a_8hpp.html", '<a href="b.html">', "b.html leads nowhere"),
    ("book/a_8hpp.html", '<a href="chapter-01-x.html#two">', "#two leads nowhere"),
    ("book/a_8hpp.html", '<a href="../chapters/01-x/README.md">', "leads nowhere"),
    ("book/a_8hpp.html", '<img src="p.svg"/>', "without alt"),
    ("book/a_8hpp.html", '<script src="https://a.org/x.js">', "loads https://a.org/x.js"),
    ("book/a_8hpp.html", '<link href="//a.org/x.css">', "loads //a.org/x.css"),
    ("book/book.css", "@import 'https://a.org/font.css';", "loads https://a.org"),
    ("book/p.svg", "<style>p{fill:url(https://a.org/p)}</style>", "loads https://a.org/p"),
    ("book/navtree.js", '[ "Two", "two.html", null ]', "tree: two.html"),
    ("chapters/02-y/README.md", "new", "no page chapter-02-y"),
    ("docs/extremes.md", "new", "no page extremes"),
]


def self_test() -> list[str]:
    failures = []
    for name, added, expected in [("", "", ""), *PLANTED]:
        with tempfile.TemporaryDirectory() as scratch:
            root = Path(scratch)
            for file, text in {**SOUND, **({name: ""} if added else {})}.items():
                (root / file).parent.mkdir(parents=True, exist_ok=True)
                (root / file).write_text(SOUND.get(file, text) + added * (file == name))
            if name and not added:
                (root / name).unlink()
            text_of.cache_clear()
            anchors.cache_clear()
            found = faults_of(root / "book", root)
        if bool(found) != bool(name) or not any(expected in f for f in found or [""]):
            failures.append(f"self-test: {name}: {added!r} gave {found}")
    return failures


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--book", type=Path, default=ROOT / "build/book")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    faults = self_test() if options.self_test else faults_of(options.book, ROOT)
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
