"""Tests bin/truth from the outside: wrong files, wrong options, wrong cases.

    truth_command.py EXECUTABLE

Each ends in one line that says what and where, and in exit code 2.
"""
from __future__ import annotations

import copy
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXECUTABLE = Path()
STEPS = {"id": "one", "kind": "constant_acceleration_steps",
         "inputs": {"method": "semi_implicit_euler", "dt": 0.5, "n": 2,
                    "x0": [0, 0, 0], "v0": [1, 0, 0], "a": [0, 0, 0]},
         "expected": {"x": [1, 0, 0], "v": [1, 0, 0]}, "tol": {"rel": 0, "abs": 1e-12}}
POLYHEDRA = {"id": "pair", "kind": "convex_pair",
             "inputs": {"A": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]},
                        "B": {"vertices": [[-0.25, 0.25, 0.25]]}},
             "expected": {"state": "separated", "signed_distance": 0.25,
                          "directions": [[-1, 0, 0]], "tie_count": 1},
             "tol": {"rel": 1e-9, "abs": 1e-10}}
BOXES = {"id": "boxes", "kind": "shape_pair",
         "inputs": {"A": {"type": "box", "size": [2, 2, 2], "t": [0, 0, 0]},
                    "B": {"type": "box", "size": [2, 2, 2], "t": [1, 1.5, 1]}},
         "expected": {"signed_distance": -0.5, "normal_A_to_B": [0, 1, 0]}}
OSCILLATOR = {"id": "two", "kind": "oscillator_steps",
              "inputs": {"method": "semi_implicit_euler", "m": 1, "k": 1, "x0": 0,
                         "v0": 0, "dt": 0.5, "n": 2},
              "expected": {"x": 0}, "tol": {"rel": 0, "abs": 1e-12}}


class TruthCommand(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.good = self.file("good.json", {"cases": [STEPS, OSCILLATOR]})

    def file(self, name: str, content: object) -> str:
        text = content if isinstance(content, str) else json.dumps(content)
        (self.folder / name).write_text(text)
        return name

    def truth(self, *words: str) -> subprocess.CompletedProcess:
        return subprocess.run([EXECUTABLE, *words], cwd=self.folder, timeout=300,
                              capture_output=True, text=True, stdin=subprocess.DEVNULL)

    def refused(self, *words: str, says: str = "") -> None:
        before = sorted(self.folder.rglob("*"))
        done = self.truth(*words)
        with self.subTest(words=words):
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"^truth: [^\n]*\n$")
            self.assertIn(says, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertEqual(sorted(self.folder.rglob("*")), before)

    def refused_case(self, case: object, says: str) -> None:
        self.refused(self.file("case.json", {"cases": [case]}), says=says)

    def test_cases_pass_and_fail(self) -> None:
        done = self.truth(self.good, "--out", "new/computed.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        computed = json.loads((self.folder / "new/computed.json").read_text())["cases"]
        self.assertEqual([c["id"] for c in computed], ["one", "two"])
        self.assertTrue(all(c["pass"] for c in computed))

        wrong = copy.deepcopy(STEPS)
        wrong["expected"]["x"] = [2, 0, 0]
        done = self.truth(self.file("wrong.json", {"cases": [wrong]}))
        self.assertEqual(done.returncode, 1)
        self.assertIn("FAILED one: x: computed [1.0,0.0,0.0]", done.stdout)

    def test_options(self) -> None:
        self.refused(says="FILE")
        self.refused("--nope", self.good)
        for option in ("--kind", "--precision", "--out"):
            self.refused(self.good, option, says=option)
        for precision in ("half", "0", "7", ""):
            self.refused(self.good, "--precision", precision, says="single or double")
        self.refused(self.good, "--kind", "nosuch", says="nosuch")

    def test_files(self) -> None:
        os.mkfifo(self.folder / "pipe")
        for name in ("missing.json", "", ".", "/dev/zero", "pipe"):
            self.refused(name, says="is not a file that can be read")
        for content in ("", "{", "[]", "3", "{}", '{"cases": 3}', '{"cases": [NaN]}',
                        "[" * 100000, '{"cases": [' + "[" * 1000 + "]" * 1000 + "]}"):
            self.refused(self.file("broken.json", content), says="broken.json: not a")
        self.refused(self.file("none.json", {"cases": []}), says="no cases")
        self.refused("two\nlines", says="two?lines")

    def test_places_that_cannot_be_written(self) -> None:
        (self.folder / "folder").mkdir()
        (self.folder / "loop").symlink_to("loop")
        for place in ("folder", "loop", "new/", "", "good.json/x", "/proc/x"):
            self.refused(self.good, "--out", place, says="--out")
        self.assertEqual(self.truth(self.good, "--out", "/dev/null").returncode, 0)
        self.assertTrue(Path("/dev/null").is_char_device())

    def test_standard_output_that_takes_nothing(self) -> None:
        for away in (">&-", ">/dev/full"):
            done = subprocess.run(["sh", "-c", f'"$0" "$1" {away}', EXECUTABLE, self.good],
                                  cwd=self.folder, stderr=subprocess.PIPE, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn("standard output", done.stderr)

    def test_cases_of_another_shape(self) -> None:
        for case in (None, 3, "x", [], {}):
            self.refused_case(case, "case.json: case without id")
        for key in STEPS:
            lacking = {k: v for k, v in STEPS.items() if k != key}
            self.refused_case(lacking, "case.json: case")
            for value in (None, 3, [], [[1]]):
                self.refused_case({**STEPS, key: value}, "case.json: case")
        for value in ("x", True, {"x": 1}, ["x"]):
            self.refused_case({**STEPS, "expected": {"x": value}}, "expected: must be")
        self.refused_case({**STEPS, "expected": {}}, "expected: must be")

    def test_inputs_of_another_type(self) -> None:
        for case in (STEPS, OSCILLATOR):
            for n in (-1, 1.5, 10**18, -10**18, 2**63, 1e300, "3", None, True):
                changed = {**case, "inputs": {**case["inputs"], "n": n}}
                self.refused_case(changed, f"case {case['id']}: n: must be")
            for dt in ("0.1", None, [], True):
                changed = {**case, "inputs": {**case["inputs"], "dt": dt}}
                self.refused_case(changed, "dt: must be a number")
        for x in (1, [1, 2], [1, 2, 3, 4], [1, 2, "3"], {"x": 1}):
            changed = {**STEPS, "inputs": {**STEPS["inputs"], "x0": x}}
            self.refused_case(changed, "x0: must be three numbers")

    def test_inputs_out_of_range(self) -> None:
        for name, value in (("m", 0), ("m", -1), ("k", -1)):
            changed = {**OSCILLATOR, "inputs": {**OSCILLATOR["inputs"], name: value}}
            self.refused_case(changed, f"{name}: must")
        for e in (-0.1, 1, 1e300, "0.5", None):
            orbit = {**OSCILLATOR, "kind": "kepler_exact", "inputs": {"e": e, "t": 1}}
            self.refused_case(orbit, "e: must")
        for steps in (None, 3, [], [0], [2.5], ["8"], [8] * 99, {"8": 8}):
            ladder = {**OSCILLATOR, "kind": "convergence_order",
                      "inputs": {"method": "rk4", "theta0": 1, "omega0": 0, "T": 1,
                                 "steps": steps}}
            self.refused_case(ladder, "steps: must be")

    def test_pairs_are_judged_by_distance_state_and_the_worth_of_a_normal(self) -> None:
        for precision in ("single", "double"):
            for case, fields in ((POLYHEDRA, {"state": "penetrating"}),
                                 (POLYHEDRA, {"signed_distance": 0.25001}),
                                 (BOXES, {"signed_distance": -0.50001}),
                                 (BOXES, {"signed_distance": 0.5})):
                wrong = {**case, "expected": {**case["expected"], **fields}}
                for each, code in ((case, 0), (wrong, 1)):
                    name = self.file("pair.json", {"cases": [each]})
                    done = self.truth(name, "--precision", precision)
                    with self.subTest(fields=fields, precision=precision, code=code):
                        self.assertEqual(done.returncode, code, done.stdout)

        done = self.truth(self.file("pair.json", {"cases": [POLYHEDRA]}), "--out", "o")
        self.assertEqual(done.returncode, 0)
        (case,) = json.loads((self.folder / "o").read_text())["cases"]
        self.assertEqual(case["computed"]["gap_along_normal"], 0.25)
        for shape, says in (({"vertices": []}, "inputs.B.vertices: must have"),
                            ({"vertices": [[0, 0, "0"]]}, "inputs.B.vertices[0]: must be")):
            inputs = {**POLYHEDRA["inputs"], "B": shape}
            self.refused_case({**POLYHEDRA, "inputs": inputs}, says)

    def test_null_is_equal_to_null_alone(self) -> None:
        for method, limit, code in (("implicit_euler", None, 0), ("implicit_euler", 100, 1),
                                    ("velocity_verlet", 2, 0), ("velocity_verlet", None, 1)):
            case = {"id": "limit", "kind": "stability_limit", "inputs": {"method": method},
                    "expected": {"omega_dt_max": limit}, "tol": {"rel": 0, "abs": 1e-12}}
            name = self.file("limit.json", {"cases": [case]})
            with self.subTest(method=method, limit=limit):
                self.assertEqual(self.truth(name).returncode, code)

    def test_other_kinds_and_methods_are_not_covered(self) -> None:
        other = {**STEPS, "inputs": {**STEPS["inputs"], "method": "nosuch"}}
        name = self.file("other.json", {"cases": [{**STEPS, "kind": "nosuch"}, other]})
        done = self.truth(name)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\nall +0 +0 +2\n")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    EXECUTABLE = Path(sys.argv.pop(1)).resolve()
    unittest.main()
