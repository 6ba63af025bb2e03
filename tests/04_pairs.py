#!/usr/bin/env python3
"""What chapter 4's program answers to files of pairs, good and hostile.

    04_pairs.py EXECUTABLE

A file that is not as it should be ends in exit code 2 and one line that names the file,
the case and the field, and leaves nothing behind.
"""

import copy
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

EXECUTABLE = pathlib.Path()
TRUTH = pathlib.Path(__file__).resolve().parent / "truth"
METHODS = ["gjk_epa", "closed_form", "sat", "libccd_epa", "libccd_mpr"]

UNIT = [1, 0, 0, 0, 1, 0, 0, 0, 1]
TETRAHEDRON = {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "dimension": 3,
               "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}
POINT = {"vertices": [[3, 0, 0]], "dimension": 0}
HULLS = {"id": "hulls", "kind": "convex_pair", "inputs": {"A": TETRAHEDRON, "B": POINT}}
BOX = {"type": "box", "size": [2, 2, 2], "R": UNIT, "t": [0, 0, 0]}
SPHERE = {"type": "sphere", "r": 0.5, "t": [0, 0, 1.25]}
CAPSULE = {"type": "capsule", "p": [0, 0, 4], "q": [0, 0, 3], "r": 0.5}
CYLINDER = {"type": "cylinder", "r": 0.5, "h": 2, "axis": "x", "R": UNIT, "t": [0, 3, 0]}
SHAPES = {"id": "shapes", "kind": "shape_pair", "inputs": {"A": BOX, "B": SPHERE}}
TRIANGLE = {"type": "triangle", "points": [[0, 0, 2], [1, 0, 2], [0, 1, 2]]}


def with_shape(shape):
    return {**SHAPES, "inputs": {"A": BOX, "B": shape}}


def without(shape, name):
    return {key: value for key, value in shape.items() if key != name}


# What is wrong with a shape beside a box, and what the line must say of it
BAD_SHAPES = [
    (None, "inputs.B: must be an object"),
    ({}, "inputs.B.type: is missing"),
    ({**BOX, "type": "banana"}, "inputs.B.type: must be box, sphere"),
    ({**BOX, "type": 3}, "inputs.B.type: must be a string"),
    ({**BOX, "size": [2, -2, 2]}, "inputs.B.size[1]: must not be negative"),
    ({**BOX, "size": [2, 2]}, "inputs.B.size: must be three numbers"),
    ({**BOX, "size": "2"}, "inputs.B.size: must be three numbers"),
    ({**BOX, "R": UNIT[:8]}, "inputs.B.R: must be nine numbers"),
    ({**BOX, "R": [2, *UNIT[1:]]}, "inputs.B.R: is no rotation"),
    ({**BOX, "R": [-1, *UNIT[1:]]}, "inputs.B.R: is no rotation"),
    ({**BOX, "R": [0] * 9}, "inputs.B.R: is no rotation"),
    ({**BOX, "R": [1e200] * 9}, "inputs.B.R: is no rotation"),
    ({**BOX, "t": [0, None, 0]}, "inputs.B.t: must be three numbers"),
    (without(BOX, "t"), "inputs.B.t: is missing"),
    ({**SPHERE, "r": "0.5"}, "inputs.B.r: must be a number"),
    ({**SPHERE, "r": -0.5}, "inputs.B.r: must not be negative"),
    ({**SPHERE, "r": True}, "inputs.B.r: must be a number"),
    (without(CAPSULE, "q"), "inputs.B.q: is missing"),
    ({**CYLINDER, "axis": "w"}, "inputs.B.axis: must be x, y or z"),
    ({**CYLINDER, "h": [2]}, "inputs.B.h: must be a number"),
    ({"type": "hull", "points": []}, "inputs.B.points: must have at least one point"),
    ({"type": "hull", "points": {}}, "inputs.B.points: must be a list of points"),
    ({"type": "point", "t": [1, 2]}, "inputs.B.t: must be three numbers"),
]

# And with a polyhedron
BAD_HULLS = [
    ([], "inputs.B: must be an object"),
    ({}, "inputs.B.vertices: is missing"),
    ({"vertices": []}, "inputs.B.vertices: must have at least one point"),
    ({"vertices": 3}, "inputs.B.vertices: must be a list of points"),
    ({"vertices": [1, 2, 3]}, "inputs.B.vertices[0]: must be three numbers"),
    ({"vertices": [[0, 0, 0], [1, "0", 0]]}, "inputs.B.vertices[1]: must be three"),
    ({**TETRAHEDRON, "faces": [[0, 1, 4]]}, "inputs.B.faces[0][2]: must be the index"),
    ({**TETRAHEDRON, "faces": [[0, 1]]}, "inputs.B.faces[0]: must be three"),
    ({**TETRAHEDRON, "faces": [[0, 1, 1.5]]}, "inputs.B.faces[0][2]: must be the index"),
    ({**TETRAHEDRON, "faces": "none"}, "inputs.B.faces: must be a list"),
    ({**TETRAHEDRON, "dimension": 4}, "inputs.B.dimension: must be 0, 1, 2 or 3"),
    ({**TETRAHEDRON, "dimension": -1}, "inputs.B.dimension: must be 0, 1, 2 or 3"),
]

# What is no JSON, or too much of it
BAD_TEXTS = [
    ("", "not a JSON file"),
    ("{", "not a JSON file"),
    ("Dear reader", "not a JSON file"),
    ('{"cases": [NaN]}', "not a JSON file"),
    ('{"cases": [Infinity]}', "not a JSON file"),
    ('{"cases": [1e999]}', "not a JSON file"),
    ('{"cases": []} {}', "not a JSON file"),
    ('{"cases": [], "cases": []}', 'not a JSON file: "cases" is named twice'),
    ('{"cases": ["' + "x" * 10**6, "not a JSON file"),
    (b'{"cases": ["\xff\xfe"]}', "not a JSON file"),
    ("\0" * 100, "not a JSON file"),
    ("[" * 100_000, "deeper than 32"),
    ('{"cases": ' + "[" * 40 + "]" * 40 + "}", "deeper than 32"),
    ("[]", "it has no list of cases"),
    ("3", "it has no list of cases"),
    ("{}", "it has no list of cases"),
    ('{"cases": {}}', "it has no list of cases"),
    ('{"cases": []}', "there are no cases"),
]


class Pairs(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="timestep-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, content, name="pairs.json"):
        if not isinstance(content, (str, bytes)):
            content = json.dumps({"cases": content})
        data = content.encode() if isinstance(content, str) else content
        (self.folder / name).write_bytes(data)
        return name

    def run_program(self, *options):
        return subprocess.run([EXECUTABLE, *options], text=True, capture_output=True,
                              timeout=60, cwd=self.folder, stdin=subprocess.DEVNULL)

    def answers(self, content, *options):
        done = self.run_program("--pairs", self.write(content), "--results", "-",
                                *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stderr[-300:])
        return json.loads(done.stdout)

    def answer(self, case, *options):
        return self.answers([case], *options)["cases"][0]

    def refused(self, says, *options):
        before = sorted(self.folder.rglob("*"))
        done = self.run_program(*options)
        self.assertEqual(done.returncode, 2, done.stderr[-300:])
        self.assertRegex(done.stderr, r"\A04-contacts: [^\n]{1,500}\n\Z")
        self.assertIn(says, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def refused_file(self, content, says):
        with self.subTest(says=says, content=str(content)[:60]):
            self.refused(f"pairs.json: {says}", "--pairs", self.write(content),
                         "--results", "r.json")

    def test_known_pairs(self):
        for precision, within in (("double", 1e-15), ("single", 1e-6)):
            results = self.answers([HULLS, SHAPES, with_shape(TRIANGLE) | {"id": "t"},
                                    with_shape(CAPSULE) | {"id": "c"},
                                    with_shape(CYLINDER) | {"id": "y"}],
                                   "--precision", precision)
            self.assertEqual((results["chapter"], results["pairs"], results["method"],
                              results["precision"]),
                             ("04-contacts", "pairs.json", "gjk_epa", precision))
            hulls, shapes, triangle, capsule, cylinder = results["cases"]
            self.assertEqual(hulls["id"], "hulls")
            self.assertEqual(hulls["state"], "separated")
            self.assertAlmostEqual(hulls["signed_distance"], 2, delta=within)
            self.assertEqual(hulls["normal"], [1, 0, 0])
            self.assertEqual((hulls["witness_A"], hulls["witness_B"]),
                             ([1, 0, 0], [3, 0, 0]))
            self.assertEqual(hulls["contacts"], [])
            self.assertEqual(hulls["reason"], "converged")
            self.assertGreater(hulls["iterations"], 0)
            self.assertEqual(shapes["state"], "penetrating")
            self.assertAlmostEqual(shapes["signed_distance"], -0.25, delta=within)
            self.assertEqual(shapes["normal"], [0, 0, 1])
            self.assertAlmostEqual(shapes["contacts"][0]["depth"], 0.25, delta=within)
            self.assertAlmostEqual(triangle["signed_distance"], 1, delta=within)
            self.assertAlmostEqual(capsule["signed_distance"], 1.5, delta=within)
            self.assertAlmostEqual(cylinder["signed_distance"], 1.5, delta=4 * within)

    def test_a_method_answers_what_it_takes(self):
        for method in METHODS:
            results = self.answers([SHAPES, HULLS], "--method", method)
            self.assertEqual(results["method"], method)
            shapes, hulls = results["cases"]
            takes = method != "sat"
            self.assertEqual(shapes["reason"] == "no_answer", not takes)
            self.assertEqual(shapes["state"], "penetrating" if takes else None)
            if method in ("closed_form", "sat"):
                self.assertEqual(hulls["reason"], "no_answer")
                self.assertIsNone(hulls["signed_distance"])

    def test_all_of_the_truth_in_every_way(self):
        for name in ("geometry_public", "robustness_public"):
            text = (TRUTH / f"{name}.json").read_text()
            for method in METHODS:
                for precision in ("single", "double"):
                    results = self.answers(text, "--method", method,
                                           "--precision", precision)
                    self.assertEqual(len(results["cases"]),
                                     len(json.loads(text)["cases"]))

    def test_shapes_without_extent_are_shapes(self):
        for points in (1, 2, 1000):
            many = {"vertices": [[3, 0, 0]] * points}
            case = {**HULLS, "inputs": {"A": many, "B": many}}
            for method in ("gjk_epa", "libccd_epa", "libccd_mpr"):
                answer = self.answer(case, "--method", method)
                self.assertLessEqual(abs(answer["signed_distance"]), 1e-12)
                self.assertAlmostEqual(math.hypot(*answer["normal"]), 1, delta=1e-15)
            self.assertEqual(self.answer(case)["state"], "touching")
        for shape in ({**BOX, "size": [0, 0, 0]}, {**SPHERE, "r": 0},
                      {"type": "point", "t": [0, 0, 0]}):
            # From inside the box's middle it is 1 to the outside
            self.assertEqual(self.answer(with_shape({**shape, "t": [0, 0, 0]}))
                             ["signed_distance"], -1)

    def test_a_million_points_in_one_place(self):
        point = "[3, 0, 0]"
        text = ('{"cases": [{"id": "many", "kind": "convex_pair", "inputs": {"A": '
                + json.dumps(TETRAHEDRON) + ', "B": {"vertices": ['
                + ",".join([point] * 10**6) + "]}}}]}")
        self.assertEqual(self.answers(text)["cases"][0]["signed_distance"], 2)

    def test_numbers_at_the_end_of_the_range(self):
        for length in (1e300, 1e150, 1e39, 1e-39, 1e-300):
            shape = {**BOX, "size": [length] * 3, "t": [length] * 3}
            for precision in ("single", "double"):
                answer = self.answer(with_shape(shape), "--precision", precision)
                numbers = [answer["signed_distance"], *(answer["normal"] or [])]
                self.assertTrue(answer["reason"] == "out_of_range"
                                or all(map(math.isfinite, numbers)), answer)

    def test_text_that_is_no_file_of_pairs(self):
        for text, says in BAD_TEXTS:
            with self.subTest(text=text[:40]):
                self.refused(says, "--pairs", self.write(text), "--results", "-")
        good = json.dumps({"cases": [HULLS, SHAPES]})
        for i in range(1, 16):
            self.refused_file(good[:len(good) * i // 16], "not a JSON file")

    def test_files_that_cannot_be_read(self):
        os.mkfifo(self.folder / "pipe")
        (self.folder / "folder").mkdir()
        for name in ("none.json", "pipe", "folder", "/dev/zero"):
            self.refused("is not a file that can be read", "--pairs", name)
        self.refused("two?lines", "--pairs", "two\nlines")
        self.refused("the file's name is empty", "--pairs", "")

    def test_cases_that_are_no_cases(self):
        for case in (None, 3, "x", []):
            self.refused_file([case], "case number 1: case: must be an object")
        for name in ("id", "kind", "inputs"):
            broken = without(HULLS, name)
            self.refused_file([SHAPES, broken], f"case {broken.get('id', 'number 2')}: "
                                                f"case.{name}: is missing")
        self.refused_file([{**HULLS, "id": 3}], "case number 1: case.id: must be a str")
        self.refused_file([{**HULLS, "kind": "geom_plane"}],
                          "case hulls: case.kind: must be convex_pair or shape_pair")
        self.refused_file([{**HULLS, "inputs": []}],
                          "case hulls: inputs: must be an object")
        for name in ("A", "B"):
            lacking = {**HULLS, "inputs": without(HULLS["inputs"], name)}
            self.refused_file([lacking], f"case hulls: inputs.{name}: is missing")
        self.refused_file([HULLS, copy.deepcopy(HULLS)],
                          "case hulls: another case has this id, too")

    def test_shapes_that_are_no_shapes(self):
        for shape, says in BAD_SHAPES:
            self.refused_file([HULLS, with_shape(shape)], f"case shapes: {says}")
        for shape, says in BAD_HULLS:
            broken = {**HULLS, "inputs": {"A": TETRAHEDRON, "B": shape}}
            self.refused_file([SHAPES, broken], f"case hulls: {says}")

    def test_options_that_go_with_it_and_those_that_do_not(self):
        name = self.write([HULLS])
        for other in (["--scene", "pairs"], ["--dt", "0.1"], ["--list"],
                      ["--set", "a=1"], ["--mesh", "bunny.obj"], ["--frames", "3"],
                      ["--window"], ["--offscreen"], ["--no-movie"]):
            self.refused(f"--pairs: does not go with {other[0]}", "--pairs", name, *other)
        self.refused("takes one method", "--pairs", name, "--method", "sat,gjk_epa")
        self.refused('unknown method of --pairs "gjk"', "--pairs", name, "--method", "gjk")
        self.refused("unknown precision", "--pairs", name, "--precision", "half")
        self.refused("--pairs: is given more than once", "--pairs", name, "--pairs", name)
        self.refused("is a folder", "--pairs", name, "--results", ".")
        listing = json.loads(self.run_program("--list", "--json").stdout)
        (job,) = listing["file_jobs"]
        self.assertEqual(job["option"], "pairs")
        self.assertEqual([method["name"] for method in job["methods"]], METHODS)

    def test_results_go_where_they_are_asked_to(self):
        printed = self.run_program("--pairs", self.write([HULLS]), "--results", "-")
        for options, place in ((["--results", "r/s.json"], "r/s.json"),
                               (["--out", "o", "--headless"], "o/results.json"),
                               ([], "out/04-contacts/results.json")):
            done = self.run_program("--pairs", "pairs.json", *options)
            self.assertEqual((done.returncode, done.stdout),
                             (0, f"the results are in {place}\n"))
            self.assertEqual((self.folder / place).read_text(), printed.stdout)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    EXECUTABLE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
