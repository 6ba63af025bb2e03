"""Builds the book: build/book/index.html, which needs no network and can be moved.

Called by `./timestep book`. Doxygen makes the pages from build/book-input; MathJax,
pictures and the search are added to what it wrote.
"""
from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import book_pages
import book_search
from book_pages import path_of
from book_text import API, ROOT, for_book, pictures, texts

INPUT, BOOK = ROOT / "build/book-input", ROOT / "build/book"
# Where Debian and Fedora keep MathJax 2, and where Arch Linux does
MATHJAX = ("/usr/share/javascript/mathjax", "/usr/share/mathjax2")
# All that TeX input with SVG output may load
MATHJAX_PARTS = ("MathJax.js", "extensions/tex2jax.js", "extensions/TeX",
                 "extensions/MathEvents.js", "extensions/AssistiveMML.js",
                 "extensions/toMathML.js", "jax/element", "jax/input/TeX",
                 "jax/output/SVG/config.js", "jax/output/SVG/jax.js",
                 "jax/output/SVG/autoload", "jax/output/SVG/fonts/TeX")
MATHJAX_SCRIPTS = re.compile(r'<script type="text/x-mathjax-config">.*?</script>\n'
                             r"<script[^>]*></script>\n", re.DOTALL)
# Links to parts of the page, some of which Doxygen then leaves out
SUMMARY = re.compile(r' *<div class="summary">.*?</div>\n', re.DOTALL)
FORMULA = re.compile(r'\\\(.+\\\)|<p class="formulaDsp">')
SCRIPTS = '<script src="book.js" defer="defer"></script>\n'


class BookError(Exception):
    """What is wrong, in one line."""


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def lay_out_input() -> None:
    """Writes what Doxygen reads: texts, headers and generated pages."""
    shutil.rmtree(INPUT, ignore_errors=True)
    headers = [file for folder in API for file in (ROOT / folder).glob("*.hpp")]
    for file in headers:
        write(INPUT / file.relative_to(ROOT), for_book(file))
    for file in texts():  # Not in folders: these would be listed with those of the headers
        write(INPUT / path_of(file).replace("/", "-"), for_book(file))
    for name, text in book_pages.pages().items():
        write(INPUT / f"{name}.md", text)
    print(f"Doxygen reads {len(texts())} texts and {len(headers)} headers", flush=True)


def run_doxygen() -> None:
    shutil.rmtree(BOOK, ignore_errors=True)
    run = subprocess.run(["doxygen", "docs/Doxyfile"], cwd=ROOT, capture_output=True,
                         text=True, stdin=subprocess.DEVNULL)
    said = run.stderr.replace(f"{INPUT}/", "").strip()
    if run.returncode != 0 or said:
        lines = said.splitlines() or [f"exit code {run.returncode}"]
        write(ROOT / "build/book.log", said)
        raise BookError(f"Doxygen objects: {lines[0]} (build/book.log has all)")


def copy(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.is_dir():
        shutil.copytree(source, target)
    else:
        shutil.copyfile(source, target)


def copy_pictures() -> None:
    for page in texts():
        for file in pictures(page.read_text(encoding="utf-8"), page):
            if not file.is_file():
                raise BookError(f"{path_of(page)}: there is no {path_of(file)}")
            copy(file, BOOK / file.relative_to(ROOT))


def copy_mathjax() -> bool:
    """Whether there is a MathJax to copy."""
    found = next((Path(p) for p in MATHJAX if Path(p, "MathJax.js").is_file()), None)
    for part in MATHJAX_PARTS if found else ():
        copy(found / part, BOOK / "mathjax" / part)
    return bool(found)


def finish_pages(formulas: bool) -> int:
    """Adds the search to every page, and drops what is of no use there."""
    pages = {path: path.read_text(encoding="utf-8") for path in BOOK.glob("*.html")}
    for path, html in pages.items():
        html = html.replace("<html ", '<html lang="en" ', 1)
        html = SUMMARY.sub("", html.replace("</head>", SCRIPTS + "</head>", 1))
        if not (formulas and FORMULA.search(html)):
            html = MATHJAX_SCRIPTS.sub("", html)
        write(path, html)
    shutil.copy(ROOT / "docs/book.js", BOOK)
    found = book_search.index(pages)
    write(BOOK / "book_index.js", book_search.script(found))
    return len(found)


def main() -> int:
    if not shutil.which("doxygen"):
        raise BookError("the book needs Doxygen (cmake/packages.txt names its package)")
    lay_out_input()
    run_doxygen()
    copy_pictures()
    formulas = copy_mathjax()
    sections = finish_pages(formulas)
    if not formulas:
        print("MathJax 2 is missing: formulas stay as TeX (cmake/packages.txt names it)")
    print(f"{path_of(BOOK)}/index.html: the book, with {sections} sections to search")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (BookError, OSError, UnicodeError) as problem:
        print(f"timestep: {problem}", file=sys.stderr)
        sys.exit(2)
