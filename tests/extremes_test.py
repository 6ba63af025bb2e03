"""Tests of docs/extremes.py over a made-up chapter: what is planted is found.

Then, of the real chapters, that the page is up to date and every failure has advice.
"""
from __future__ import annotations

import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "docs"))
sys.dont_write_bytecode = True
import extremes  # noqa: E402
import extremes_page  # noqa: E402

# A program whose metric is a thousandth of what --set size= says, but for three sizes
PROGRAM = """#!/bin/sh
for word; do case $word in size=*) size=${word#size=} ;; esac; done
case $size in
  -1) exit 2 ;;
  -2) echo "no such size" >&2; exit 1 ;;
  9999) echo '{"failed": {"what": "position is inf", "step": 7}}' ;;
  *) error=$(awk -v s="$size" 'BEGIN { printf "%.17g", -FACTOR * s / 1000 }')
     echo '{"metrics": {"error": {"value": '$error', "unit": "m"}}}' ;;
esac
"""


def row(what: str, size: float, remedy: str = "smaller steps", kind: str = "step") -> dict:
    return {"what": what, "kind": kind, "args": ["--set", f"size={size}"],
            "metric": "error", "accurate": 0.01, "bounded": 1, "remedy": remedy}


ROWS = [row("small", 0.62, "nothing"), row("large", 123.4), row("huge", 1234),
        row("beyond", 9999), row("none", -1, "a size"), row("flat", 0.5, "nothing", "shape")]


class Chapter(unittest.TestCase):
    """A repository with one chapter and its program, published as it is."""

    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        self.chapter = self.root / "chapters/01-fall"
        self.chapter.mkdir(parents=True)
        (self.chapter / "README.md").write_text("# 1. Falling: and landing\n")
        self.page = self.root / extremes_page.PAGE
        self.page.parent.mkdir()
        self.page.write_text("# Extremes\n\nWords.\n\n"
                             f"{extremes_page.BEGIN}\n{extremes_page.END}\n")
        self.results = self.chapter / "extremes_results.json"
        self.declare(ROWS)
        self.program(1)
        self.assertEqual(self.extremes("--publish")[0], 0)

    def declare(self, rows: list[dict]) -> None:
        (self.chapter / "extremes.json").write_text(json.dumps(rows))

    def program(self, factor: float) -> None:
        file = self.root / "01-fall"
        file.write_text(PROGRAM.replace("FACTOR", str(factor)))
        file.chmod(0o755)

    def extremes(self, *arguments: str) -> tuple[int, str]:
        """Exit code and all that is said."""
        said = io.StringIO()
        with mock.patch.object(extremes, "ROOT", self.root), \
                mock.patch.object(sys, "argv", ["extremes.py", "--bin", str(self.root),
                                                *arguments]), \
                contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            return extremes.main(), said.getvalue()


class RunTest(Chapter):
    def test_each_verdict_is_given_with_its_number(self) -> None:
        found = json.loads(self.results.read_text())
        self.assertEqual({what: pair[0] for what, pair in found.items()}, {
            "small": "accurate: 0.00062 m", "large": "bounded: 0.12 m",
            "huge": "explodes: 1.2 m", "beyond": "overflows: step 7", "none": "refused",
            "flat": "accurate: 0.0005 m"})
        self.assertEqual(self.extremes()[0], 0)

    def test_a_crash_is_no_refusal(self) -> None:
        self.declare([*ROWS, row("worse", -2)])
        code, said = self.extremes()
        self.assertEqual(code, 1)
        self.assertIn("crashed: no such size", said)

    def test_a_metric_that_is_not_there_and_a_run_without_end_are_said(self) -> None:
        program = self.root / "01-fall"
        lost = {**row("lost", 1), "metric": "eror"}
        with self.assertRaisesRegex(extremes_page.PublishError, "^lost: .* eror$"):
            extremes.measure(program, lost, "double")
        program.write_text("#!/bin/sh\nexec sleep 60\n")
        with mock.patch.object(extremes, "LONGEST", 0.1), \
                self.assertRaisesRegex(extremes_page.PublishError, "^long: not done"):
            extremes.measure(program, row("long", 1), "double")

    def test_a_changed_digit_is_found(self) -> None:
        self.program(1.05)
        code, said = self.extremes("01-fall")
        self.assertEqual(code, 1)
        self.assertIn("01-fall: large, single: bounded: 0.13 m, published bounded: 0.12 m",
                      said)

    def test_a_changed_verdict_is_found_and_published_on_purpose_alone(self) -> None:
        self.program(10)
        before = self.page.read_text()
        code, said = self.extremes()
        self.assertEqual((code, self.page.read_text()), (1, before))
        self.assertIn("large, double: explodes: 1.2 m, published bounded: 0.12 m", said)

        self.assertEqual(self.extremes("--publish")[0], 0)
        self.assertIn("| large | error | ✕ explodes: 1.2 m |", self.page.read_text())
        self.assertEqual(self.extremes()[0], 0)

    def test_a_planted_verdict_is_found(self) -> None:
        text = self.results.read_text().replace('"bounded: 0.12 m"', '"accurate: 0.12 m"', 1)
        self.results.write_text(text)
        code, said = self.extremes()
        self.assertEqual((code, said.count("published accurate: 0.12 m")), (1, 1))
        self.assertEqual(self.extremes("--page", "--check")[0], 1)

    def test_what_is_published_is_printed_without_a_run(self) -> None:
        (self.root / "01-fall").unlink()
        code, said = self.extremes("--published", "01-fall")
        self.assertEqual(code, 0)
        self.assertIn("| huge | error | explodes: 1.2 m | explodes: 1.2 m | smaller", said)

    def test_wrong_calls_end_in_one_line(self) -> None:
        with self.assertRaisesRegex(extremes.PublishError, "no chapter '01-fal'.*01-fall"):
            self.extremes("01-fal")
        (self.root / "01-fall").unlink()
        with self.assertRaisesRegex(extremes.PublishError, "there is no .*01-fall"):
            self.extremes()
        self.declare(ROWS[1:])
        with self.assertRaisesRegex(extremes.PublishError, "not those that are published"):
            self.extremes("--page")


class PageTest(Chapter):
    def test_it_counts_both_precisions_and_keeps_the_words(self) -> None:
        text = self.page.read_text()
        self.assertTrue(text.startswith("# Extremes\n\nWords.\n"))
        self.assertIn("6 extremes, each in double and in single precision, are 12 runs", text)
        self.assertIn("| [1 Falling](../chapters/01-fall/README.md#where-it-breaks) "
                      "| 6 | 4 | 2 | 2 | 2 | 0 | 2 |", text)
        self.assertIn("(#needles-plates-and-slivers) | 2\u00a0● |", text)
        self.assertEqual(self.extremes("--page", "--check")[0], 0)

    def test_a_page_changed_by_hand_is_stale(self) -> None:
        self.page.write_text(self.page.read_text().replace("explodes: 1.2", "explodes: 1.1"))
        code, said = self.extremes("--page", "--check")
        self.assertEqual(code, 1)
        self.assertIn("is stale", said)

    def test_rows_without_advice_or_kind_are_found(self) -> None:
        for planted, fault in ((row("large", 123.4, "nothing"), "nothing says what to do"),
                               (row("large", 123.4, ""), "nothing says what to do"),
                               (row("large", 123.4, kind="odd"), "no kind 'odd'")):
            self.declare([planted if each["what"] == "large" else each for each in ROWS])
            code, said = self.extremes("--page", "--check")
            self.assertEqual(code, 1)
            self.assertIn(fault, said)


class MatrixTest(unittest.TestCase):
    def test_methods_are_told_by_the_word_before_the_comma(self) -> None:
        def extreme(what: str, *args: str) -> extremes_page.Extreme:
            return extremes_page.Extreme(Path("06-impulses"),
                                         {**row(what, 1), "args": args}, ["refused"] * 2)

        columns = extremes_page.by_method(
            [extreme("lcp, a stack", "--method", "lcp"), extreme("a wall, a stack", "wall"),
             extreme("substeps, two", "--method", "substeps"),
             extreme("lcp, a row", "--method", "lcp")], "06-impulses")
        self.assertEqual({name: len(some) for name, some in columns.items()},
                         {"`lcp`": 2, "`substeps`": 1})
        self.assertEqual(extremes_page.matrix(columns).splitlines()[0],
                         "| kind | `lcp` | `substeps` |")
        self.assertIn(" | 4\u00a0– | 2\u00a0– |", extremes_page.matrix(columns))


class RealTest(unittest.TestCase):
    def test_the_page_is_up_to_date_and_every_failure_has_advice(self) -> None:
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            code = extremes_page.bring_up_to_date(ROOT, check=True)
        self.assertEqual(code, 0, said.getvalue())

    def test_no_chapter_has_an_extreme_twice(self) -> None:
        for folder in extremes_page.find_chapters(ROOT, []):
            what = [each["what"] for each in extremes_page.rows_of(folder)]
            self.assertEqual(len(what), len(set(what)), folder.name)


if __name__ == "__main__":
    unittest.main()
