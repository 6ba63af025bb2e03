"""Tests of docs/study_data.py, weave_study.py and study_figures.py on a made-up study."""
from __future__ import annotations

import contextlib
import importlib.util
import io
import json
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "docs"))
sys.dont_write_bytecode = True
import study_data  # noqa: E402
import study_figures  # noqa: E402
import study_report  # noqa: E402
import weave_study  # noqa: E402
from weave_marker import BLOCKS, INLINE, Place  # noqa: E402
from weave_runs import ROOT, WeaveError  # noqa: E402

CSV = """\
key,problem,chapter,scene,method,precision,dt,settings,error,unit,evaluations,steps,\
bodies,failed,peer,us_per_frame,spread,repeats
orbit/euler/double/dt=1,orbit,02,orbit,euler,double,1,,nan,m,10,10,1,escaped,false,nan,nan,0
orbit/euler/double/dt=0.5,orbit,02,orbit,euler,double,0.5,,1,m,20,20,1,,false,2,0.1,5
orbit/euler/double/dt=0.1,orbit,02,orbit,euler,double,0.1,,0.25,m,100,100,1,,false,10,0.1,5
orbit/rk4/double/dt=0.5,orbit,02,orbit,rk4,double,0.5,,0.125,m,80,20,1,,false,8,0.1,5
orbit/rk4/double/dt=1/60,orbit,02,orbit,rk4,double,0.016666666666666666,,-1e-6,m,4800,600,\
1,,false,240,0.1,5
orbit/rk4/single/dt=0.5,orbit,02,orbit,rk4,single,0.5,,0.5,m,80,20,1,,false,7,0.1,5
orbit/GSL rk4/double/dt=0.5,orbit,02,orbit,GSL rk4,double,0.5,,0.125,m,80,20,1,,true,16,0.1,5
rope/sweeps/double/dt=0.1/iterations=4,rope,02,rope,sweeps,double,0.1,\
iterations=4,0.5,m,400,100,5,,false,nan,nan,0
rope/sweeps/double/dt=0.1/iterations=10,rope,02,rope,sweeps,double,0.1,iterations=10 g=9.81,\
0.25,m,1000,100,5,,false,nan,nan,0
"""
INGREDIENTS = {"machine": "an abacus", "rows": [
    {"ingredient": "drag", "scene": "light ball", "matters": True, "with": "drag",
     "without": "none", "unit": "m", "error_with": 4.5e-8, "error_without": 2.677,
     "ns_with": 50.0, "ns_without": 20.0, "ns_more": 30.04, "spread": 0.1},
    {"ingredient": "drag", "scene": "heavy ball", "matters": False, "with": "drag",
     "without": "none", "unit": "m", "error_with": 0.0, "error_without": 4.4e-4,
     "ns_with": 50.0, "ns_without": 51.0, "ns_more": -1.04, "spread": 0.1}]}


class StudyTableTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "study").mkdir()
        (self.root / study_data.PUBLISHED).write_text(CSV, encoding="utf-8")
        (self.root / study_data.INGREDIENTS).write_text(json.dumps(INGREDIENTS))
        self.orbit = study_data.of_problem(study_data.published(self.root), "orbit")

    def place(self, *words: str, **options: str) -> Place:
        return Place(self.root / "README.md", 1, list(words), options, "")

    def table(self, *words: str, **options: str) -> list[list[str]]:
        text = weave_study.table(self.root, self.place("study", *words, **options))
        return [[cell.strip() for cell in line.strip("|").split("|")]
                for line in text.splitlines()]

    def number(self, *words: str, **options: str) -> str:
        return weave_study.number(self.root, self.place("studied", *words, **options))

    def test_the_front_is_what_no_other_beats(self) -> None:
        self.assertEqual([r.key for r in study_data.front(self.orbit)],
                         ["orbit/euler/double/dt=0.5", "orbit/rk4/single/dt=0.5",
                          "orbit/rk4/double/dt=0.5", "orbit/rk4/double/dt=1/60"])

    def test_times_of_the_front_are_ratios_to_its_cheapest(self) -> None:
        head, _, *rows = self.table("front", "orbit")
        self.assertEqual(head[-2:], ["error [m]", "time"])
        self.assertEqual(rows[0], ["`euler`", "double", "1/2", "–", "1.0", "1"])
        self.assertEqual(rows[-1], ["`rk4`", "double", "1/60", "–", "1.0 × 10⁻⁶", "120"])
        self.assertEqual(len(rows), 4)
        _, _, *rows = self.table("front", "orbit", rows="2")
        self.assertEqual([row[-1] for row in rows], ["1", "120"])

    def test_ratios_have_three_digits(self) -> None:
        self.assertEqual([weave_study.over_cheapest(cost, 2.0) for cost in (2, 2.4691, 2468)],
                         ["1", "1.23", "1,230"])

    def test_without_times_the_cost_is_evaluations(self) -> None:
        _, _, *rows = self.table("front", "rope")
        self.assertEqual(rows[0][3:], ["iterations 4", "5.0 × 10⁻¹", "1"])
        self.assertEqual(rows[1][3:], ["iterations 10", "2.5 × 10⁻¹", "2.5"])

    def test_what_was_tried_counts_failures(self) -> None:
        _, _, *rows = self.table("tried", "orbit")
        self.assertEqual(rows[0], ["`euler`", "3", "1", "2.5 × 10⁻¹", "1/10", "5"])
        self.assertEqual(rows[2][0], "`GSL rk4`")

    def test_ingredients_name_their_cost_and_share(self) -> None:
        _, _, *rows = self.table("ingredients")
        self.assertEqual(rows[0], ["drag", "light ball", "yes", "drag / none",
                                   "4.5 × 10⁻⁸ m", "2.7 m", "+30", "+60 %"])
        self.assertEqual(rows[1][-2:], ["−1", "−2 %"])

    def test_a_choice_is_ours(self) -> None:
        text = CSV.replace("GSL rk4,double,0.5,,0.125,m,80,20,1,,true,16",
                           "GSL rk4,double,0.5,,0.0125,m,80,20,1,,true,1")
        (self.root / study_data.PUBLISHED).write_text(text, encoding="utf-8")
        self.assertNotIn("`GSL rk4`", [row[0] for row in self.table("front", "orbit")])
        self.assertEqual(self.number("orbit@0.3", "method"), "`rk4`")

    def test_the_guide_has_the_price_of_a_tenth_of_the_error(self) -> None:
        wishes = [{"scene": "a planet", "good enough": "1 m", "problem": "orbit",
                   "error": 1.25},
                  {"scene": "a rope", "good enough": "0.5 m", "problem": "rope",
                   "error": 0.5}]
        (self.root / "guide.json").write_text(json.dumps(wishes))
        _, _, orbit, rope = self.table("guide", "guide.json")
        self.assertEqual(orbit, ["a planet", "1 m", "`euler`", "double", "1/2", "–",
                                 "1 m", "× 4"])
        self.assertEqual(rope[5:], ["iterations 4", "0.5 m", "–"])
        wishes[1]["error"] = 0.1
        (self.root / "guide.json").write_text(json.dumps(wishes))
        with self.assertRaisesRegex(WeaveError, "guide.json: nothing of 'rope' errs by"):
            self.table("guide", "guide.json")

    def test_numbers_in_sentences(self) -> None:
        key = "orbit/rk4/double/dt=1/60"
        self.assertEqual(self.number(key, "error", ".0e"), "−1 × 10⁻⁶")
        self.assertEqual(self.number(key, "us_per_frame", ".0f",
                                     over="orbit/rk4/double/dt=0.5"), "30")
        self.assertEqual(self.number("orbit@0.3", "method"), "`rk4`")
        self.assertEqual(self.number("orbit@0.3", "dt"), "1/2")
        self.assertEqual(self.number("orbit@1e-3", "dt"), "1/60")
        self.assertEqual(self.number("rope@0.3", "iterations"), "10")
        self.assertEqual(self.number("rope@0.3", "settings"), "iterations 10")
        self.assertEqual(self.number("ingredients/drag", "error_without", ".2f"), "2.68")
        self.assertEqual(self.number("ingredients/drag/not", "ns_more", ".0f"), "−1")
        self.assertEqual(self.number("machine"), "an abacus")

    def test_what_is_not_there_is_said(self) -> None:
        for words, said in ((("nothing", "error"), "has no 'nothing'"),
                            (("orbit@1e-9", "error"), "errs by 1e-9"),
                            (("orbit@0.3", "colour"), "no column 'colour'"),
                            (("ingredients/salt", "ns_more"), "no ingredient 'salt'")):
            with self.assertRaisesRegex(WeaveError, re.escape(said)):
                self.number(*words)
        with self.assertRaisesRegex(WeaveError, "no problem 'orbt'; it has orbit, rope"):
            self.table("front", "orbt")
        with self.assertRaisesRegex(WeaveError, "not 'frnt'"):
            self.table("frnt", "orbit")
        (self.root / study_data.PUBLISHED).unlink()
        with self.assertRaisesRegex(WeaveError, "study --publish"):
            self.number("orbit@1", "error")

    def test_markers_are_known(self) -> None:
        self.assertIn("study", BLOCKS)
        self.assertIn("studied", INLINE)

    def test_what_failed_is_shown_at_the_cost_of_its_steps(self) -> None:
        failed = self.orbit[0]
        self.assertEqual(failed.failed, "escaped")
        self.assertEqual(study_data.cost_or_guess(failed, self.orbit), 1)

    def test_the_front_is_named_first_and_peers_are_dashed(self) -> None:
        looks = study_figures.looks(self.orbit)
        self.assertEqual(list(looks), ["rk4", "euler", "GSL rk4"])
        self.assertEqual([look["linestyle"] for look in looks.values()],
                         ["-", "-", "--"])
        self.assertEqual(study_figures.distance_to_front("GSL rk4", self.orbit), 2)

    def test_the_scale_leaves_out_what_is_far_off(self) -> None:
        far = study_data.record_of({"key": "k", "problem": "orbit", "method": "euler",
                                    "precision": "double", "dt": "1", "error": "1e30"},
                                   1.0)
        self.assertLess(study_figures.top_of([*self.orbit, far]), 100)
        self.assertTrue(math.isfinite(study_figures.top_of([])))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_a_figure_a_problem_the_same_each_time(self) -> None:
        file = self.root / study_data.PUBLISHED
        one, two = (study_figures.draw_all(file, self.root / name) for name in "ab")
        self.assertEqual([path.name for path in one], ["orbit.svg", "rope.svg"])
        for a, b in zip(one, two):
            self.assertEqual(a.read_text(), b.read_text())
        text = one[0].read_text()
        for word in ("GSL rk4", "error [m]", "time of a frame", "failed"):
            self.assertIn(word, text)
        self.assertIn("evaluations a second", one[1].read_text())

    def test_a_report_is_published_whole_or_not_at_all(self) -> None:
        out, programs = self.root / "out", self.root / "bin"
        out.mkdir()
        programs.mkdir()
        timed = CSV.replace("5,,false,nan,nan,0", "5,,false,3,0.1,5")
        (out / "study.csv").write_text(timed, encoding="utf-8")
        program = programs / "ingredients"
        problems = [{"name": "orbit", "cells": 6}, {"name": "rope", "cells": 2}]
        for name, says in (("ingredients", {"rows": INGREDIENTS["rows"]}),
                           ("study", {"compiler": "cc", "problems": problems})):
            (programs / name).write_text(f"#!/bin/sh\necho '{json.dumps(says)}'\n")
            (programs / name).chmod(0o755)
        (self.root / study_data.INGREDIENTS).unlink()
        call = ["study_report", "--out", str(out), "--root", str(self.root),
                "--program", str(program)]

        def code(*more: str) -> int:
            with mock.patch.object(sys, "argv", [*call, *more]), \
                    contextlib.redirect_stdout(io.StringIO()), \
                    contextlib.redirect_stderr(io.StringIO()):
                return study_report.main()

        self.assertEqual(code(), 0)
        self.assertFalse((self.root / study_data.INGREDIENTS).exists())
        self.assertEqual(code("--publish"), 0)
        self.assertIn("machine", study_data.ingredients(self.root))
        made = json.loads((self.root / study_data.MACHINE).read_text())
        self.assertEqual(made["compiler"], "cc")
        for part in (timed.partition("rope/")[0], timed.rpartition("rope/")[0], CSV):
            (out / "study.csv").write_text(part, encoding="utf-8")
            self.assertEqual(code("--publish"), 2)
            self.assertEqual((self.root / study_data.PUBLISHED).read_text(), timed)
        (out / "study.csv").write_text(timed, encoding="utf-8")
        program.write_text("#!/bin/sh\nexit 3\n")
        self.assertEqual(code("--publish"), 2)

    def test_a_part_is_not_published(self) -> None:
        for words in (["--quick"], ["orbit"], ["--shard", "1/2"], ["--no-times"]):
            done = subprocess.run([ROOT / "timestep", "study", "--publish", *words],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, rf"\A[^\n]*whole[^\n]*{words[0]}\n\Z")

    def test_without_matplotlib_a_line_says_what_to_install(self) -> None:
        said = io.StringIO()
        with mock.patch("importlib.util.find_spec", return_value=None), \
                mock.patch.object(sys, "argv", ["study_figures", "x.csv", "y"]), \
                contextlib.redirect_stdout(said):
            self.assertEqual(study_figures.main(), 0)
        self.assertIn("install matplotlib", said.getvalue())


if __name__ == "__main__":
    unittest.main()
