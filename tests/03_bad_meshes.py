#!/usr/bin/env python3
"""What chapter 3's program says of meshes that are no solids.

    03_bad_meshes.py EXECUTABLE

Writes a corpus of broken files and gives each to the scene thrown-wrench: exit code 2 and
one line that names the file and the fault.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

EXECUTABLE = pathlib.Path()
MESHES = pathlib.Path(__file__).resolve().parent.parent / "assets/meshes"

POINTS = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
FACES = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
INSIDE_OUT = POINTS + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"
BUNNY = (MESHES / "bunny.obj").read_text()

# The file, what is in it, and what the line must say of it
CORPUS = [
    ("empty.obj", "", "is empty"),
    ("text.obj", "Dear reader,\nthis is no mesh.\n", ""),
    ("text.xyz", "Dear reader,\nthis is no mesh.\n", ""),
    ("points.obj", POINTS, ""),
    ("cut.obj", BUNNY[:100_000], "boundary edges"),
    ("cut.glb", b"glTF\2\0\0\0\xff\0\0\0\x10\0\0\0JSON{", ""),
    ("cut.gltf", (MESHES / "tetrahedron.gltf").read_text()[:400], ""),
    ("nan.obj", "v nan 0 0\n" + POINTS + FACES, "is not finite"),
    ("infinite.obj", "v 1e999 0 0\n" + POINTS + FACES, "is not finite"),
    ("index.obj", POINTS + FACES + "f 1 2 4000000000\n", "out of range"),
    ("behind.obj", POINTS + FACES + "f 1 2 5\n", "out of range"),
    ("flat.obj", POINTS + FACES + "f 1 1 2\n", "1 triangle without area"),
    ("open.obj", POINTS + FACES[:-8], "not closed: 3 boundary edges"),
    ("bunny-open.obj", "".join(BUNNY.splitlines(True)[:-12]),
     "not closed: 22 boundary edges"),
    ("double.obj", POINTS + FACES + FACES[:8], "3 edges with more than two triangles"),
    ("mixed.obj", POINTS + FACES[:-8] + "f 2 4 3\n", "3 edges between opposite windings"),
    ("sheet.obj", POINTS + "f 1 2 3\nf 1 3 2\n", "no volume"),
    ("inside-out.obj", INSIDE_OUT, "inside out: volume -0.167 m³"),
    ("dust.obj", POINTS.replace("1", "1e-30") + FACES, ""),
]


class BadMeshes(unittest.TestCase):
    scene = "thrown-wrench"

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="timestep-"))
        self.addCleanup(shutil.rmtree, self.folder)
        if "without assimp" in self.throw(self.write("good.obj", POINTS + FACES)).stderr:
            self.skipTest("this build has no assimp")

    def write(self, name, content):
        file = self.folder / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def throw(self, mesh, *more):
        command = [EXECUTABLE, "--headless", "--results", "-", "--scene",
                   self.scene, "--duration", "0.1", "--mesh", mesh, *more]
        return subprocess.run(command, text=True, capture_output=True, timeout=300,
                              cwd=self.folder, env=dict(os.environ),
                              stdin=subprocess.DEVNULL)

    def check_refused(self, mesh, says):
        for precision in ("single", "double"):
            with self.subTest(mesh=mesh, precision=precision):
                done = self.throw(mesh, "--precision", precision)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertIn(f"mesh {mesh}: ", done.stderr)
                self.assertIn(says, done.stderr)
                self.assertEqual(done.stdout, "")

    def test_each_is_refused_in_one_line_that_names_the_fault(self):
        for name, content, says in CORPUS:
            self.check_refused(self.write(name, content), says)
        self.check_refused("none.obj", "there is no such file")

    def test_no_cut_of_a_file_is_worse_than_refused(self):
        wrench = (MESHES / "wrench.obj").read_text()
        for i in range(1, 12):
            self.check_refused(self.write("cut.obj", wrench[:len(wrench) * i // 12]), "")

    def test_winding_is_turned_where_that_is_asked_for_and_said(self):
        self.check_refused(self.write("inside-out.obj", INSIDE_OUT),
                           "; try --fix-winding")
        done = self.throw("inside-out.obj", "--fix-winding")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn("mesh inside-out.obj: was inside out", done.stderr)
        turned = json.loads(done.stdout)
        self.assertTrue(turned["fix_winding"])
        self.assertEqual(len(turned["notices"]), 1)

        # As if it had been right from the start, and a mesh that is right stays
        good = json.loads(self.throw("good.obj").stdout)
        same = self.throw("good.obj", "--fix-winding")
        self.assertEqual(same.stderr, "")
        self.assertNotIn("notices", good)
        for other in (turned, json.loads(same.stdout)):
            self.assertEqual(other["metrics"].keys(), good["metrics"].keys())
            self.assertEqual(other["state"], good["state"])


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    EXECUTABLE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
