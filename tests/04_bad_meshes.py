#!/usr/bin/env python3
"""What chapter 4's program says of meshes that are no solids.

    04_bad_meshes.py EXECUTABLE

The corpus of chapter 3 and some more, for the scene mesh and each of its methods: exit
code 2 and one line that names the file and the fault.
"""

import importlib.util
import pathlib
import sys
import unittest

SPEC = importlib.util.spec_from_file_location(
    "bad_meshes", pathlib.Path(__file__).with_name("03_bad_meshes.py"))
bad_meshes = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(bad_meshes)


class BadMeshes(bad_meshes.BadMeshes):
    scene = "mesh"

    def test_winding_is_turned_where_that_is_asked_for_and_said(self):
        mesh = self.write("inside-out.obj", bad_meshes.INSIDE_OUT)
        done = self.throw(mesh, "--fix-winding")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn("scene mesh takes no solid mesh", done.stderr)

    def test_many_points_at_one_place(self):
        points = "v 1 2 3\n" * 1_000_000
        self.check_refused(self.write("point.obj", points + "f 1 2 3\nf 4 5 6\n"), "")

    def test_every_method_refuses(self):
        mesh = self.write("open.obj", bad_meshes.POINTS + bad_meshes.FACES[:-8])
        for method in ("hull", "authored", "decomposition"):
            done = self.throw(mesh, "--method", method)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("not closed: 3 boundary edges", done.stderr)

    def test_a_small_mesh_far_away_is_still_a_mesh(self):
        far = bad_meshes.POINTS.replace(" 0", " 1000").replace(" 1\n", " 1001\n")
        far = far.replace("v 1 ", "v 1001 ").replace(" 1 ", " 1001 ")
        done = self.throw(self.write("far.obj", far + bad_meshes.FACES))
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    bad_meshes.EXECUTABLE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
