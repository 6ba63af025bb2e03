"""Tests of what docs/book.py does to texts, headers and pages; Doxygen is not run."""
from __future__ import annotations

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "docs"))
sys.dont_write_bytecode = True
import book  # noqa: E402
import book_pages  # noqa: E402
import book_search  # noqa: E402
import book_text  # noqa: E402

CHAPTER = ROOT / "chapters/01-particles/README.md"
PAGE = """<html xmlns="x"><head><title>Timestep: 1. Falling</title>
<script type="text/x-mathjax-config">
config
</script>
<script type="text/javascript" async="async" src="mathjax/MathJax.js"></script>
</head>
  <div class="summary"><a href="#gone">Gone</a></div>
<div class="contents">
<div class="toc"><h3>Energy</h3></div>Before &lt;all&gt;
<h1><a class="anchor" id="at-1-energy"></a>
Energy</h1><p>It <em>drift</em>s by \\(\\Delta t\\).</p>
<h2 class="memtitle"><span class="permalink"><a href="#a1">&#9670;</a></span>fall()</h2>
<div><code>void</code> fall</div></div><!-- contents -->"""


class TextTest(unittest.TestCase):
    def markdown(self, text: str, file: Path = CHAPTER) -> str:
        return book_text.markdown(text, file)

    def test_formulas_become_doxygens_and_code_stays(self) -> None:
        self.assertEqual(self.markdown("a $x_0$ b"), "a \\f$x_0\\f$ b")
        self.assertEqual(self.markdown("```math\nx\n```\n"), "\\f[\nx\n\\f]\n")
        for code in ("`$x$`", "```sh\necho $a $b\n## c\n```"):
            self.assertEqual(self.markdown(code), code)

    def test_headings_get_anchors(self) -> None:
        self.assertEqual(self.markdown("## The loop: it's"),
                         "## The loop: it's {#at-01-particles-the-loop-its}")
        self.assertEqual(self.markdown("# 1. Falling"),
                         "# 1.\u00a0Falling {#chapter-01-particles}\n\n[TOC]")
        self.assertEqual(self.markdown("## A", ROOT / "README.md"),
                         '<h1 id="at-home-a">A</h1>')

    def test_links_lead_to_pages_of_the_book_or_are_none(self) -> None:
        for link, target in (
                ("../../README.md", "[a](@ref index)"),
                ("../../common/physics/euler.hpp", "[a](@ref common/physics/euler.hpp)"),
                ("../../common/physics/euler.cpp",
                 "[a](@ref source-common-physics-euler-cpp)"),
                ("../../docs/weave.md", "a"), ("../../assets/README.md", "a"),
                ("../../common/physics", '<a href="files.html">a</a>'),
                ("../../tests", "a"),
                ("#the-loop", '<a href="chapter-01-particles.html'
                              '#at-01-particles-the-loop">a</a>')):
            self.assertEqual(self.markdown(f"[`a`]({link})"), target)
        self.assertEqual(self.markdown('![It "falls"](figures/x.svg)'),
                         '<img src="chapters/01-particles/figures/x.svg" '
                         'alt="It &quot;falls&quot;"/>')

    def test_markers_of_weaving_are_left_out(self) -> None:
        woven = self.markdown("<!-- weave: value a b -->5<!-- /weave --> s")
        self.assertEqual(woven, "5 s")

    def test_headers_lose_their_namespaces_and_keep_their_lines(self) -> None:
        for name in ("timestep", "timestep::exact", "timestep::inline TIMESTEP_PRECISION"):
            text = f"namespace {name} {{\nint a;\n}}  // namespace {name}\n"
            self.assertEqual(book_text.header(text), "\nint a;\n\n")


class PagesTest(unittest.TestCase):
    def setUp(self) -> None:
        folder, physics = ROOT / "chapters/01-particles", ROOT / "common/physics"
        euler = [physics / "euler.hpp", physics / "euler.cpp"]
        self.first = book_pages.Chapter(folder, euler)
        self.second = book_pages.Chapter(ROOT / "chapters/02-x", [physics / "forces.hpp"])

    def test_the_engine_page_tells_what_is_new_and_what_was_there(self) -> None:
        page = book_pages.engine(self.first, [])
        self.assertIn("Chapter 1 adds 2 files", page)
        self.assertIn("[euler.hpp](@ref common/physics/euler.hpp), "
                      "[euler.cpp](@ref source-common-physics-euler-cpp) | The three", page)
        self.assertIn("first chapter", page)
        with mock.patch.object(book_pages.Chapter, "own", []):
            page = book_pages.engine(self.second, [self.first])
        self.assertIn("which then has 3 files", page)
        self.assertIn("| 1 | [euler.hpp](@ref common/physics/euler.hpp)", page)

    def test_lines_of_code_are_no_comments_and_not_empty(self) -> None:
        with tempfile.TemporaryDirectory() as scratch:
            file = Path(scratch) / "a.cpp"
            file.write_text("// a\n\nint a;  // b\n/* c\n d */\n  }\n")
            self.assertEqual(book_pages.lines_of_code([file]), 2)

    def test_every_link_to_a_source_has_its_page(self) -> None:
        pages = book_pages.pages()
        for page in [ROOT / "README.md", *ROOT.glob("chapters/*/README.md")]:
            text = book_text.markdown(page.read_text(encoding="utf-8"), page)
            for name in book_text.re.findall(r"@ref (source-[\w-]+)", text):
                self.assertIn(name, pages)


class SearchTest(unittest.TestCase):
    def test_every_section_and_member_is_an_entry(self) -> None:
        self.assertEqual(book_search.entries("a.html", PAGE), [
            ["a.html", "1. Falling", "", "Before <all>"],
            ["a.html#at-1-energy", "1. Falling", "Energy", "It drifts by \\Delta t ."],
            ["a.html#a1", "1. Falling", "fall()", "void fall"]])

    def test_lists_and_sources_of_headers_are_no_entries(self) -> None:
        for name in ("files.html", "dir_1.html", "a_8hpp_source.html", "A-members.html"):
            self.assertEqual(book_search.entries(name, PAGE), [])


class FinishTest(unittest.TestCase):
    def finished(self, page: str, formulas: bool) -> str:
        with tempfile.TemporaryDirectory() as scratch:
            (Path(scratch) / "a.html").write_text(page)
            with mock.patch.object(book, "BOOK", Path(scratch)):
                book.finish_pages(formulas)
            return (Path(scratch) / "a.html").read_text()

    def test_pages_get_the_search_and_lose_dead_links(self) -> None:
        page = self.finished(PAGE, formulas=True)
        self.assertIn('src="book.js"', page)
        self.assertIn('<html lang="en"', page)
        self.assertNotIn("#gone", page)

    def test_mathjax_is_loaded_where_it_is_and_has_something_to_do(self) -> None:
        without = PAGE.replace("\\(", "").replace("\\)", "")
        self.assertIn("mathjax", self.finished(PAGE, formulas=True))
        self.assertNotIn("mathjax", self.finished(PAGE, formulas=False))
        self.assertNotIn("mathjax", self.finished(without, formulas=True))


if __name__ == "__main__":
    unittest.main()
