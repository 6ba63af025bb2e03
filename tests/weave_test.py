"""Tests of docs/weave.py on a small made-up chapter with a made-up executable."""
from __future__ import annotations

import contextlib
import importlib.util
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "docs"))
sys.dont_write_bytecode = True
import weave  # noqa: E402
import weave_runs  # noqa: E402

PROGRAM = '''#!/usr/bin/env python3
import json, pathlib, sys
def after(option, default):
    return sys.argv[sys.argv.index(option) + 1] if option in sys.argv else default
styles = [("a", "circle", "solid"), ("b", "square", "dashed")]
methods = [{"name": n, "summary": "", "color": "#0072b2", "marker": m, "dash": d}
           for n, m, d in styles]
if "--markdown" in sys.argv: print("| x |\\n|---|\\n| 1 |"); sys.exit()
if "--list" in sys.argv:
    print(json.dumps({"scenes": [{"name": "fall", "methods": methods}]})); sys.exit()
if after("--scene", "fall") != "fall": sys.exit("no scene of that name")
dt = float(after("--dt", "0.5"))
results = {"chapter": "01-x", "scene": "fall", "method": "a,b", "dt": dt, "steps": 10,
           "metrics": {"a/error": {"value": dt * 2e-5, "unit": "m"},
                       "b/error": {"value": -dt, "unit": "m"}},
           "cost": {"a/v1.0 seconds": 3.0, "b/v1.0 seconds": 1.5}}
out = pathlib.Path(after("--out", "."))
if "--offscreen" in sys.argv: (out / "filmstrip.png").write_bytes(b"png")
(out / "history.csv").write_text("t,a/error\\n0,0\\n1,2\\n")
print(json.dumps(results))
'''
FIGURES = '''from figure_style import new_figure
def error_growth(runs):
    figure, axes = new_figure()
    axes.plot(runs["half"].history["t"], **runs["half"].look("b"))
    return figure
def measured(runs):
    figure, axes = new_figure()
    axes.plot([each["ns"] for each in runs["bench:contacts/"].values()])
    return figure
'''
SOURCE = "int fall() { return 1; }\n"


class WeaveTest(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name).resolve()
        self.chapter = self.root / "chapters/01-x"
        self.write("build/bin/01-x", PROGRAM).chmod(0o755)
        self.write("common/fall.cpp", SOURCE)
        self.write("chapters/01-x/figures.py", FIGURES)
        self.write("chapters/01-x/runs.json", json.dumps({
            "runs": {"half": ["--scene", "fall"], "bad": ["--scene", "rise"],
                     "steps": {"args": [], "sweep": {"--dt": [0.5, 0.25]}}},
            "commands": {"extremes": ["bin/01-x", "--markdown"],
                         "script": ["python3", "build/bin/01-x", "--markdown"]},
            "figures": {"error-growth": ["half"], "measured": ["bench:contacts/"]}}))

    def write(self, path: str, text: str) -> Path:
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        return file

    def run_weave(self, *options: str) -> tuple[int, str]:
        said = io.StringIO()
        weave_runs.file_digest.cache_clear()
        with contextlib.redirect_stdout(said):
            code = weave.main(["--root", str(self.root), "--build",
                               str(self.root / "build"), *options])
        return code, said.getvalue()

    def woven(self, text: str, *options: str) -> str:
        file = self.write("chapters/01-x/README.md", text)
        code, said = self.run_weave(*options)
        self.assertEqual(code, 0, said)
        return file.read_text(encoding="utf-8")

    def inline(self, marker: str, old: str = "") -> str:
        text = self.woven(f"is <!-- weave: {marker} -->{old}<!-- /weave -->.")
        return text.split("-->")[1].removesuffix("<!-- /weave ")

    def complaint(self, text: str, *options: str) -> tuple[int, str]:
        self.write("chapters/01-x/README.md", text)
        return self.run_weave(*options)

    def test_value_is_written_as_readers_write_it(self) -> None:
        small = "value half metrics.a/error.value .1e"
        self.assertEqual(self.inline(small), "1.0 × 10⁻⁵")
        self.assertEqual(self.inline("value half b/error .2f"), "−0.50")
        self.assertEqual(self.inline("value half b/error .0f *-1000"), "500")
        self.assertEqual(self.inline("value half steps d"), "10")
        self.assertEqual(self.inline("value half scene"), "fall")
        self.assertEqual(self.inline("value steps@0.25 b/error"), "−0.25")

    def test_names_may_contain_dots_and_values_may_be_ratios(self) -> None:
        ratio = 'value half "a/v1.0 seconds" .1f "over=b/v1.0 seconds"'
        self.assertEqual(self.inline(ratio), "2.0")

    def test_value_from_another_page_names_its_chapter(self) -> None:
        file = self.write("README.md", "is <!-- weave: value 01-x:half steps d -->"
                                       "<!-- /weave -->")
        self.assertEqual(self.run_weave()[0], 0)
        self.assertIn("-->10<!--", file.read_text())
        self.write("README.md", "is <!-- weave: value half steps d --><!-- /weave -->")
        self.assertEqual(self.run_weave()[0], 2)

    def test_table_of_methods_and_of_runs(self) -> None:
        def table(words: str) -> str:
            return self.woven(f"<!-- weave: table {words} --><!-- /weave -->")

        text = table('half columns="error*1000:.2f:error [mm]"')
        self.assertIn("| method | error [mm] |\n|---|---:|\n| `a` | 0.01 |\n"
                      "| `b` | −500.00 |", text)
        text = table('steps rows=runs columns="b/error:.2f,steps:d:n"')
        self.assertIn("| run | b/error [m] | n |\n|---|---:|---:|\n"
                      "| 0.5 | −0.50 | 10 |", text)
        text = table('steps columns="error:.2f:at {run}"')
        self.assertIn("| method | at 0.5 | at 0.25 |", text)

    def test_code_names_its_file(self) -> None:
        text = self.woven("<!-- weave: code common/fall.cpp fall -->\nold\n"
                          "<!-- /weave -->")
        self.assertIn("*[common/fall.cpp](../../common/fall.cpp), `fall`*\n\n"
                      "```cpp\nint fall() {", text)
        self.assertNotIn("old", text)

    def test_output_of_a_command(self) -> None:
        for name in ("extremes", "script"):
            text = self.woven(f"<!-- weave: output {name} --><!-- /weave -->")
            self.assertIn("-->\n\n| x |\n|---|\n| 1 |\n\n<!--", text)

    def test_a_line_that_begins_with_a_comment_is_joined_to_the_last(self) -> None:
        marker = "<!-- weave: value half steps d -->10<!-- /weave -->"
        code, said = self.complaint(f"took\n{marker} s", "--check")
        self.assertEqual((code, said.count("\n")), (1, 1))
        self.assertEqual(self.woven(f"took\n{marker} s"), f"took {marker} s")

    def test_weaving_twice_changes_nothing_and_check_agrees(self) -> None:
        once = self.woven("A <!-- weave: value half steps d -->9<!-- /weave -->\n\n"
                          "<!-- weave: code common/fall.cpp fall +doc -->"
                          "<!-- /weave -->")
        self.assertEqual(self.woven(once), once)
        self.assertEqual(self.run_weave("--check"), (0, ""))

    def test_check_names_file_line_and_place_and_changes_nothing(self) -> None:
        text = "\nA <!-- weave: value half steps d -->9<!-- /weave -->"
        code, said = self.complaint(text, "--check")
        self.assertEqual(code, 1)
        self.assertEqual(said, "chapters/01-x/README.md:2: weave: value half steps: "
                               "stale: '9' should be '10'\n")
        self.assertEqual((self.chapter / "README.md").read_text(), text)

    def test_a_changed_executable_is_run_again(self) -> None:
        text = "A <!-- weave: value half steps d -->9<!-- /weave -->"
        self.assertIn("10", self.woven(text))
        self.write("build/bin/01-x", PROGRAM.replace('"steps": 10', '"steps": 11'))
        self.assertIn("11", self.woven(text))

    def test_faults_are_one_line_with_file_and_line(self) -> None:
        for marker in ("value", "value none steps", "value half none", "knit", 'code "',
                       "value half steps zz", "value bad steps", "output none",
                       "code common/none.cpp f", "code common/fall.cpp g",
                       'table half columns=""', 'table half columns="none"',
                       'figure none "alt"', "figure error-growth"):
            text = f"\n\nA <!-- weave: {marker} -->x<!-- /weave -->"
            code, said = self.complaint(text)
            self.assertEqual(code, 2, marker)
            self.assertRegex(said, r"^chapters/01-x/README.md:3: weave: [^\n]+\n$")
        for text in ("A <!-- weave: value half steps -->", "A <!-- /weave -->",
                     "<!-- weave: value half steps --><!-- /weave -->",
                     "a <!-- weave: machine --><!-- weave: machine --><!-- /weave -->"):
            self.assertEqual(self.complaint(text)[0], 2, text)

    def test_markers_in_code_are_left_alone(self) -> None:
        text = "`<!-- weave: none -->`\n\n```md\n<!-- weave: none -->\n```\n"
        self.assertEqual(self.woven(text), text)

    def test_timings_are_measured_only_when_asked(self) -> None:
        text = ('x <!-- weave: timing half "a/v1.0 seconds" .1f -->7.5<!-- /weave --> '
                "on <!-- weave: machine -->an abacus<!-- /weave -->")
        self.assertEqual(self.woven(text), text)
        self.assertEqual(self.run_weave("--check"), (0, ""))
        measured = self.woven(text, "--timings")
        self.assertIn("-->3.0<!--", measured)
        self.assertNotIn("abacus", measured)
        self.assertEqual(self.complaint(text.replace("7.5", "fast"), "--check")[0], 1)

    def test_published_measurements_are_quoted_and_never_taken(self) -> None:
        self.write("bench/results.json", json.dumps({"machine": "an abacus", "medians": {
            "kepler/rk4/whole": {"ns": 60.0, "energy_error": 1e-8},
            "kepler/rk4/alone": {"ns": 40.0, "energy_error": 1e-8},
            "kepler/rk4/GSL": {"ns": 160.0, "energy_error": 2e-8}}}))
        self.assertEqual(self.inline("measured machine"), "an abacus")
        self.assertEqual(self.inline("measured kepler/rk4/alone ns .0f"), "40")
        self.assertEqual(self.inline("measured kepler/rk4/GSL ns .1f "
                                     "over=kepler/rk4/alone"), "4.0")
        text = self.woven("<!-- weave: bench kepler --><!-- /weave -->", "--timings")
        self.assertIn("| `rk4` | 60.0 | 40.0 |", text)
        for marker in ("bench none", "bench", "bench rotation", "measured kepler/rk4/alone",
                       "measured kepler/rk4/none ns"):
            self.assertEqual(self.complaint(f"A <!-- weave: {marker} --><!-- /weave -->")[0],
                             2, marker)

    def test_pictures_are_rendered_only_when_asked(self) -> None:
        text = '<!-- weave: picture fall "It falls" --><!-- /weave -->'
        self.assertIn("--pictures", self.complaint(text, "--check")[1])
        woven = self.woven(text, "--pictures")
        self.assertIn("![It falls](pictures/fall.png)", woven)
        self.assertEqual(self.run_weave("--check"), (0, ""))
        self.write("build/bin/01-x", PROGRAM.replace('"steps": 10', '"steps": 11'))
        self.assertEqual(self.run_weave("--check")[0], 1)

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_figures_repeat_follow_the_colour_scheme_and_grow_old(self) -> None:
        text = '<!-- weave: figure error-growth "It grows" --><!-- /weave -->'
        self.assertEqual(self.complaint(text, "--check")[0], 1)
        self.assertIn("![It grows](figures/error-growth.svg)", self.woven(text))
        file = self.chapter / "figures/error-growth.svg"
        svg = file.read_text(encoding="utf-8")
        for part in ("prefers-color-scheme:dark", "var(--1b1f24", "#0072b2", "<text"):
            self.assertIn(part, svg)
        self.assertEqual(self.run_weave("--check"), (0, ""))
        file.unlink()
        self.woven(text)
        self.assertEqual(file.read_text(encoding="utf-8"), svg)
        self.write("chapters/01-x/figures.py", FIGURES.replace('"b"', '"a"'))
        self.assertEqual(self.run_weave("--check")[0], 1)

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_a_figure_of_the_benchmarks_grows_old_with_them(self) -> None:
        text = '<!-- weave: figure measured "It is fast" --><!-- /weave -->'
        code, said = self.complaint(text)
        self.assertEqual(code, 2)
        self.assertIn("there is no bench/results.json", said)
        medians = {"contacts/a": {"ns": 2}, "rotation/b": {"ns": 3}}
        self.write("bench/results.json", json.dumps({"medians": medians}))
        self.assertIn("figures/measured.svg", self.woven(text))
        medians["rotation/b"]["ns"] = 4
        self.write("bench/results.json", json.dumps({"medians": medians}))
        self.assertEqual(self.run_weave("--check"), (0, ""))
        medians["contacts/a"]["ns"] = 4
        self.write("bench/results.json", json.dumps({"medians": medians}))
        self.assertEqual(self.run_weave("--check")[0], 1)


if __name__ == "__main__":
    unittest.main()
