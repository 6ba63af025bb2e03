#!/usr/bin/env python3
"""Tests every option of a chapter's executable, right and wrong, from the outside.

    command_line.py EXECUTABLE [PART...]

What there is to run is read from `--list --json`, so that this serves every chapter.
Parts are the test classes below; without any, all run.
"""

import csv
import json
import math
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

EXECUTABLE = pathlib.Path()
SIZE = ["--size", "160x120"]
SMALL = [*SIZE, "--no-movie"]
PATIENCE = 300  # [s] for a run: a machine with much else to do is slow, not wrong
SUPPRESSIONS = pathlib.Path(__file__).resolve().parent / "lsan.supp"


def environment(**changes):
    """Ours without a display; a value of None takes a variable away."""
    result = dict(os.environ)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        result.pop(name, None)
    if SUPPRESSIONS.exists():
        result.setdefault("LSAN_OPTIONS",
                          f"suppressions={SUPPRESSIONS}:print_suppressions=0")
    for name, value in changes.items():
        if value is None:
            result.pop(name, None)
        else:
            result[name] = value
    return result


def read_png(file):
    """Width, height and raw rows of an 8-bit PNG; fails if anything in it is broken."""
    data = pathlib.Path(file).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{file} is not a PNG"
    place, pixels, header = 8, b"", b""
    while place < len(data):
        (length,) = struct.unpack(">I", data[place:place + 4])
        kind = data[place + 4:place + 8]
        body = data[place + 8:place + 8 + length]
        (checksum,) = struct.unpack(">I", data[place + 8 + length:place + 12 + length])
        assert zlib.crc32(kind + body) == checksum, f"{file}: broken chunk"
        header = body if kind == b"IHDR" else header
        pixels += body if kind == b"IDAT" else b""
        place += 12 + length
    width, height = struct.unpack(">II", header[:8])
    return width, height, zlib.decompress(pixels)


class CommandLine(unittest.TestCase):
    """Each test runs in an empty folder of its own."""

    @classmethod
    def setUpClass(cls):
        listing = subprocess.run([EXECUTABLE, "--list", "--json"], capture_output=True,
                                 text=True, check=True, env=environment())
        cls.listing = json.loads(listing.stdout)
        cls.name = cls.listing["chapter"]
        cls.scene = cls.listing["scenes"][0]

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="timestep-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_it(self, *arguments, prefix=(), timeout=PATIENCE, **changes):
        command = [*prefix, EXECUTABLE, *map(str, arguments)]
        for more in ({}, {"ASAN_OPTIONS": "detect_leaks=0"}):
            done = subprocess.run(command, text=True, capture_output=True,
                                  cwd=self.folder, timeout=timeout,
                                  env=environment(**changes, **more),
                                  stdin=subprocess.DEVNULL)
            # The leak checker itself may crash over a driver's threads as they end
            if "LeakSanitizer has encountered a fatal error" not in done.stderr:
                break
        return done

    def good(self, *arguments, **settings):
        done = self.run_it(*arguments, **settings)
        self.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr}")
        return done

    def results(self, *arguments):
        done = self.good("--headless", "--results", "-", "--scene", self.scene["name"],
                         *arguments)
        return json.loads(done.stdout)

    def short(self, steps=12):
        """Options for a run of a few steps."""
        return ["--dt", repr(self.scene["dt"]), "--duration",
                repr(self.scene["dt"] * steps)]

    def left_behind(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*"))

    def bad(self, *arguments, code=2, says=(), prefix=(), **changes):
        """One line that says so, that exit code, nothing left behind."""
        before = self.left_behind()
        done = self.run_it(*arguments, prefix=prefix, **changes)
        with self.subTest(arguments=arguments):
            self.assertEqual(done.returncode, code, done.stderr)
            lines = done.stderr.splitlines()
            self.assertEqual(len(lines), 1, done.stderr)
            self.assertTrue(lines[0].startswith(self.name + ": "), lines[0])
            for word in [says] if isinstance(says, str) else says:
                self.assertIn(word, lines[0])
            self.assertEqual(done.stdout, "")
            self.assertEqual(self.left_behind(), before)


class Listing(CommandLine):
    def test_text_is_readable(self):
        text = self.good("--list").stdout
        for scene in self.listing["scenes"]:
            for part in ("methods", "parameters", "presets"):
                for thing in scene[part]:
                    self.assertIn(thing["name"], text)
        for line in text.splitlines():
            self.assertLessEqual(len(line), 88, line)

    def test_json_is_complete(self):
        for scene in self.listing["scenes"]:
            names = [method["name"] for method in scene["methods"]]
            self.assertTrue(names)
            self.assertLessEqual(set(scene["default_methods"]), set(names))
            self.assertTrue(0 < scene["dt"] <= scene["duration"])
            for method in scene["methods"]:
                self.assertRegex(method["color"], "^#[0-9a-f]{6}$")
                self.assertTrue(method["marker"] and method["dash"])
            ranges = {p["name"]: p for p in scene["parameters"]}
            for p in ranges.values():
                self.assertTrue(p["minimum"] <= p["default"] <= p["maximum"], p)
            for preset in scene["presets"]:
                self.assertTrue(preset["source"])
                for name, value in preset["values"].items():
                    p = ranges[name]
                    self.assertTrue(p["minimum"] <= value <= p["maximum"], preset)

    def test_help_names_every_option(self):
        text = self.good("--help").stdout
        options = ("--window --offscreen --headless --list --json --scene --method "
                   "--precision --dt --duration --preset --set --mesh --fix-winding --out "
                   "--results --frames --no-movie --size --fps --window-frames --version")
        for option in options.split():
            self.assertIn(option, text)
        self.assertEqual(self.good("-h").stdout, text)

    def test_version(self):
        self.assertIn(self.name, self.good("--version").stdout)

    def test_writes_nothing(self):
        for arguments in (["--list"], ["--list", "--json"], ["--help"], ["--version"]):
            self.good(*arguments)
        self.assertEqual(self.left_behind(), [])


class Headless(CommandLine):
    def test_results_are_complete(self):
        result = self.results(*self.short())
        self.assertEqual(list(result), [
            "chapter", "scene", "method", "precision", "preset", "mesh", "fix_winding",
            "dt", "duration", "steps", "time", "parameters", "state", "metrics",
            "cost"])
        self.assertEqual(result["chapter"], self.name)
        self.assertEqual(result["steps"], 12)
        self.assertEqual(result["precision"], "double")
        self.assertEqual(list(result["parameters"]),
                         [p["name"] for p in self.scene["parameters"]])
        for body in result["state"]:
            for number in body["position"] + body["velocity"]:
                self.assertTrue(math.isfinite(number))
        for metric in result["metrics"].values():
            self.assertEqual(list(metric), ["value", "unit"])
        self.assertEqual(list(result["cost"])[:4], [
            "force_evaluations", "steps", "wall_seconds", "nanoseconds_per_body_step"])

    def test_two_runs_give_the_same_bits(self):
        for precision in ("single", "double"):
            texts = []
            for _ in range(2):
                done = self.good("--headless", "--results", "-", "--method", "all",
                                 "--precision", precision, *self.short(30))
                texts.append(done.stdout[:done.stdout.index('"cost"')])
            self.assertEqual(*texts)
            self.assertIn(f'"precision": "{precision}"', texts[0])

    def test_every_scene_runs_in_both_precisions(self):
        for scene in self.listing["scenes"]:
            if scene["name"] in ("fails", "refuses"):
                continue
            for precision in ("single", "double"):
                self.good("--headless", "--scene", scene["name"], "--method", "all",
                          "--precision", precision, "--duration", repr(3 * scene["dt"]))

    def test_several_methods_run_side_by_side(self):
        methods = [m["name"] for m in self.scene["methods"]]
        result = self.results("--method", ",".join(methods), *self.short())
        self.assertEqual(result["method"], ",".join(methods))
        repeated = sum([["--method", m] for m in methods], [])
        again = self.results(*repeated, *self.short())
        every = self.results("--method", "all", *self.short())
        for other in (again, every):
            self.assertEqual(result["state"], other["state"])
        if len(methods) > 1:
            names = {name.split("/")[0] for name in result["metrics"]}
            self.assertEqual(names, set(methods))

    def test_one_method_does_as_it_does_among_others(self):
        every = self.results("--method", "all", *self.short())
        methods = [m["name"] for m in self.scene["methods"]]
        for method in methods:
            prefix = f"{method}/" if len(methods) > 1 else ""
            alone = self.results("--method", method, *self.short())
            for name, metric in alone["metrics"].items():
                self.assertEqual(every["metrics"][prefix + name], metric)

    def test_parameters_and_presets(self):
        for scene in self.listing["scenes"]:
            run = ["--headless", "--results", "-", "--scene", scene["name"],
                   "--duration", repr(2 * scene["dt"])]
            if scene["name"] in ("fails", "refuses"):
                continue
            values = {p["name"]: p["default"] for p in scene["parameters"]}
            sets = [["--set", f"{name}={value!r}"] for name, value in values.items()]
            done = self.good(*run, *sum(sets, []))
            self.assertEqual(json.loads(done.stdout)["parameters"], values)
            for preset in scene["presets"]:
                done = json.loads(self.good(*run, "--preset", preset["name"]).stdout)
                self.assertEqual(done["preset"], preset["name"])
                for name, value in preset["values"].items():
                    self.assertEqual(done["parameters"][name], value)

                # --set wins, wherever it stands
                name = next(iter(preset["values"]))
                p = next(p for p in scene["parameters"] if p["name"] == name)
                done = self.good(*run, "--set", f"{name}={p['minimum']!r}", "--preset",
                                 preset["name"])
                parameters = json.loads(done.stdout)["parameters"]
                self.assertEqual(parameters[name], p["minimum"])

    def test_steps_are_those_that_fit(self):
        result = self.results("--dt", "1/64", "--duration", "0.5")
        self.assertEqual((result["steps"], result["dt"]), (32, 1 / 64))
        self.assertEqual(self.results("--dt=0.1", "--duration=0.35")["steps"], 3)

    def test_results_file_only(self):
        self.good("--headless", "--results", "deep/er/r.json", *self.short())
        self.assertEqual(self.left_behind(), ["deep", "deep/er", "deep/er/r.json"])
        json.loads((self.folder / "deep/er/r.json").read_text())

    def test_default_folder(self):
        self.good("--headless", *self.short())
        self.assertEqual(self.left_behind(), ["out", f"out/{self.name}",
                                              f"out/{self.name}/results.json"])

    def test_out_brings_the_tables(self):
        self.good("--headless", "--out", "o", "--duration", repr(self.scene["dt"] * 50))
        self.assertEqual(self.left_behind(), ["o", "o/history.csv", "o/results.json",
                                              "o/trajectory.csv"])
        result = json.loads((self.folder / "o/results.json").read_text())
        with open(self.folder / "o/history.csv", encoding="utf-8") as file:
            history = list(csv.DictReader(file))
        self.assertEqual(float(history[0]["time"]), 0)
        self.assertEqual(float(history[-1]["time"]), result["time"])
        for name, metric in result["metrics"].items():
            self.assertEqual(float(history[-1][name]), metric["value"])

        with open(self.folder / "o/trajectory.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        last = [row for row in rows if float(row["time"]) == result["time"]]
        for body, row in zip(result["state"], last):
            self.assertEqual(row["body"], body["name"])
            self.assertEqual([float(row[c]) for c in "xyz"], body["position"])

    def test_without_home_or_path_and_from_anywhere(self):
        self.good("--headless", "--results", "-", *self.short(), HOME=None, PATH=None)
        self.good("--headless", "--results", "/dev/null", *self.short(), HOME="/none")
        self.assertEqual(self.left_behind(), [])


class Extremes(CommandLine):
    """Only for the chapter that the tests bring along."""

    def setUp(self):
        super().setUp()
        if self.name != "harness-chapter":
            self.skipTest("made for the tests' own chapter")

    def blow_up(self, *arguments):
        return self.good("--scene", "spring", "--set", "stiffness=1e6",
                         "--duration", "60", *arguments)

    def test_a_blow_up_is_said_and_written_down(self):
        done = self.blow_up("--headless", "--results", "-")
        self.assertEqual(len(done.stderr.splitlines()), 2)  # a line a method
        self.assertIn("early failed at step ", done.stderr)
        result = json.loads(done.stdout)
        self.assertIn("late/step", result["failed"])
        self.assertIn("early/what", result["failed"])

        one = json.loads(self.blow_up("--headless", "--results", "-", "--method",
                                      "early").stdout)
        self.assertEqual(list(one["failed"]), ["step", "time", "what"])
        self.assertEqual(one["cost"]["steps"], one["failed"]["step"])
        self.assertIn(one["state"][0]["position"][1], ("nan", "inf", "-inf"))

    def test_a_step_that_cannot_be_taken_is_said_and_written_down(self):
        done = self.good("--headless", "--results", "-", "--scene", "stuck", "--dt",
                         "1/64")
        self.assertEqual(done.stderr, f"{self.name}: early failed at step 8 (t = "
                                      "0.125 s): no way on\n")
        self.assertEqual(json.loads(done.stdout)["failed"],
                         {"step": 8, "time": 0.125, "what": "no way on"})

    def test_pictures_survive_a_blow_up(self):
        self.blow_up("--offscreen", *SMALL, "--out", "o", "--frames", "5")
        read_png(self.folder / "o/filmstrip.png")

    def test_other_exceptions_are_one_line(self):
        self.bad("--headless", "--scene", "fails", code=1, says="the scene gave up")
        self.bad("--offscreen", *SMALL, "--scene", "fails", code=1, says="gave up")
        self.bad("--headless", "--scene", "refuses", says="it never starts")

    def test_a_mesh_is_read(self):
        (self.folder / "t.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        run = ["--headless", "--results", "-", "--scene"]
        self.bad(*run, "mesh", "--mesh", "none.obj", says="none.obj")
        self.bad(*run, "fall", "--mesh", "t.obj", says="takes no mesh")
        self.bad(*run, "mesh", "--mesh", "", says="--mesh")
        if "without assimp" in self.run_it(*run, "mesh", "--mesh", "t.obj").stderr:
            self.skipTest("this build has no assimp")
        done = self.good(*run, "mesh", "--mesh", "t.obj")
        self.assertEqual(json.loads(done.stdout)["mesh"], "t.obj")

        # What was done to it is said once, however many methods run
        done = self.good(*run, "mesh", "--mesh", "t.obj", "--fix-winding", "--method",
                         "all")
        self.assertEqual(done.stderr, f"{self.name}: the mesh is turned\n")
        result = json.loads(done.stdout)
        self.assertEqual(result["fix_winding"], True)
        self.assertEqual(result["notices"], ["the mesh is turned"])
        self.bad(*run, "fall", "--fix-winding", says="takes no solid mesh")
        self.bad(*run, "mesh", "--fix-winding", says="no --mesh to turn")

        # Over this one assimp crashes
        (self.folder / "deep.gltf").write_text("[" * 1000000)
        self.bad(*run, "mesh", "--mesh", "deep.gltf", says="deep.gltf: is broken")
        self.bad(*run, "mesh", "--mesh", "/dev/zero", says="is not a file")

    def test_ctrl_c_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            running = subprocess.Popen(
                [EXECUTABLE, "--offscreen", *SMALL, "--dt", "1e-6", "--duration", "500",
                 "--out", "o"], cwd=self.folder, stderr=subprocess.PIPE, text=True,
                env=environment())
            while not list(self.folder.glob("o/.partial*results.json")):
                time.sleep(0.05)
            running.send_signal(number)
            _, errors = running.communicate(timeout=PATIENCE)
            self.assertEqual(running.returncode, 130)
            self.assertEqual(errors, f"{self.name}: interrupted\n")
            self.assertEqual(self.left_behind(), [])

    def test_a_signal_that_the_caller_ignores_stays_ignored(self):
        running = subprocess.Popen(
            ["sh", "-c", 'trap "" INT; exec "$0" "$@"', EXECUTABLE, "--headless",
             "--dt", "1e-6", "--duration", "500", "--out", "o"], cwd=self.folder,
            stderr=subprocess.DEVNULL, env=environment())
        while not list(self.folder.glob("o/.partial*results.json")):
            time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        with self.assertRaises(subprocess.TimeoutExpired):
            running.wait(0.3)
        running.terminate()
        self.assertEqual(running.wait(30), 130)


class WrongCalls(CommandLine):
    def test_unknown_names_bring_the_nearest(self):
        scene = self.scene["name"]
        method = self.scene["methods"][0]["name"]
        self.bad("--scene", scene[:-1], says=["unknown scene", scene])
        self.bad("--scene", "", says="unknown scene")
        self.bad("--method", method + "x", says=["unknown method", method])
        self.bad("--precision", "duoble", says=["unknown precision", "double"])
        self.bad("--preset", "nosuch", says="unknown preset")
        self.bad("--set", "nosuch=1", says="unknown parameter")
        self.bad("--headles", says=["unknown option", "--headless"])
        self.bad("-z", says="unknown option")
        self.bad("stray", says="unknown option")

    def test_methods(self):
        method = self.scene["methods"][0]["name"]
        self.bad("--method", "", says="--method")
        self.bad("--method", f"{method},", says="--method")
        self.bad("--method", f"{method},{method}", says=["--method", "twice"])
        self.bad("--method", method, "--method", method, says="twice")

    def test_time(self):
        wrong = ("0", "-1", "nan", "inf", "-inf", "1e999", "abc", "", "1/0", "0.1s")
        for value in wrong:
            self.bad("--headless", "--dt", value, says=["--dt", "greater than 0"])
            self.bad("--headless", f"--duration={value}" if value else "--duration=0",
                     says=["--duration", "greater than 0"])
        self.bad("--headless", "--dt", "2", "--duration", "1", says=["--dt", "to 1 s"])
        self.bad("--headless", "--dt", "1e-12", "--duration", "1", says="1e+12 steps")
        self.bad("--headless", "--dt", "1e-300", "--duration", "1e300", says="--dt")

    def test_any_step_runs_or_is_refused(self):
        for scene in self.listing["scenes"]:
            for dt, duration in (("1e12", "1e12"), ("1e300", "9e300"),
                                 ("1e-300", "3e-300"), ("5e-324", "5e-324")):
                done = self.run_it("--headless", "--results", "-", "--scene",
                                   scene["name"], "--dt", dt, "--duration", duration)
                self.assertIn(done.returncode, (0, 2), f"{scene['name']} {dt}")

    def test_parameters(self):
        for p in self.scene["parameters"]:
            beyond = p["maximum"] * 2 + 1
            for value in (beyond, "nan", "inf", "", "many", "1;2", "1e999"):
                self.bad("--headless", "--set", f"{p['name']}={value}",
                         says=["--set", p["name"], p["unit"]])
            if p["integer"]:
                self.bad("--headless", "--set", f"{p['name']}={p['minimum'] + 0.5}",
                         says="whole number")
        self.bad("--headless", "--set", "novalue", says="NAME=VALUE")
        self.bad("--headless", "--set", "=1", says="NAME=VALUE")
        name = self.scene["parameters"][0]["name"]
        self.bad("--headless", "--set", f"{name}=1", "--set", f"{name}=2",
                 says=[f"--set {name}", "more than once"])

    def test_one_line_whatever_it_quotes(self):
        self.bad("--dt", "1\n2\t\x1b[31m3", says="--dt 1?2??[31m3: must be")

    def test_numbers_of_the_output(self):
        for value in ("0", "-1", "x", "1.5", "1000000", ""):
            self.bad("--offscreen", "--frames", value, says="--frames")
            self.bad("--offscreen", "--fps", value, says="--fps")
        for value in ("0x0", "100", "100x", "x100", "-1x5", "1e9x1e9", "99999x100"):
            self.bad("--offscreen", f"--size={value}", says=["--size", "pixels"])
        self.bad("--window-frames", "0", says="--window-frames")

    def test_contradictions(self):
        self.bad("--headless", "--offscreen", says="exclude")
        self.bad("--window", "--headless", says="exclude")
        self.bad("--headless", "--frames", "3", says="--frames")
        self.bad("--window", "--results", "r.json", says="--results")
        self.bad("--json", says="--json")
        self.bad("--dt", "1", "--dt", "2", says=["--dt", "more than once"])
        for option in ("--dt", "--scene", "--set", "--out", "--method"):
            self.bad(option, says=[option, "needs a value"])

    def test_places_that_cannot_be_written(self):
        (self.folder / "file").write_text("mine")
        (self.folder / "folder/results.json").mkdir(parents=True)
        for mode in (["--headless"], ["--offscreen", *SMALL]):
            self.bad(*mode, "--out", "file", says=["--out", "file"])
            self.bad(*mode, "--out", "file/deeper", says="--out")
            self.bad(*mode, "--out", "new/folder/../../file/x", says="--out")
            self.bad(*mode, "--out", "/proc/nothing", says="--out /proc/nothing")
            self.bad(*mode, "--out", "/dev/null", says="--out")
            self.bad(*mode, "--out", "folder", says=["--out", "is a folder"])
            self.bad(*mode, "--out", "", says="--out")
            self.bad(*mode, "--results", "file/r.json", says="--results")
            self.bad(*mode, "--results", "folder", says=["--results", "is a folder"])
            self.bad(*mode, "--results", "/proc/r.json", says="--results")
            self.bad(*mode, "--results", "/dev/full", "--duration",
                     repr(2 * self.scene["dt"]), says="--results /dev/full")
            self.bad(*mode, "--results", "", says="--results")
        self.assertEqual((self.folder / "file").read_text(), "mine")

    def test_places_that_are_no_files_of_their_own(self):
        (self.folder / "loop").symlink_to("loop")
        (self.folder / "gone").symlink_to("nowhere")
        run = ["--headless", *self.short(), "--out", "o", "--results"]
        self.bad(*run, "loop", says="--results loop: is a link to nowhere")
        self.bad(*run, "gone", says="--results gone: is a link to nowhere")
        self.bad(*run, "new/", says="--results new/: names no file")
        for table in ("o/trajectory.csv", "o/../o/history.csv"):
            self.bad(*run, table, says=f"--results {table}: is another file")

    def test_files_that_may_not_grow(self):
        self.bad("--headless", "--dt", "1e-3", "--out", "o", says="to the end",
                 prefix=["sh", "-c", 'ulimit -f 1; exec "$0" "$@"'])

    def test_closed_standard_output(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([EXECUTABLE, "--list"], stdout=full, check=False,
                                  stderr=subprocess.PIPE, text=True, env=environment())
        self.assertEqual(done.returncode, 2)
        self.assertIn("standard output", done.stderr)

    def test_closed_standard_error(self):
        for away in ("2>&-", "2>/dev/full", "<&- >&- 2>&-"):
            shell = ["sh", "-c", f'exec "$0" "$@" {away}']
            self.assertEqual(self.run_it("--dt", "0", prefix=shell).returncode, 2)
            self.assertEqual(self.left_behind(), [])

        # What nobody can read must not end in a file that took the place
        self.good(*SMALL, *self.short(), "--out", "o",
                  prefix=["sh", "-c", 'exec "$0" "$@" 2>&-'])
        for table in ("trajectory", "history"):
            self.assertRegex((self.folder / f"o/{table}.csv").read_text(), "^time,")

    def test_no_display(self):
        self.bad("--window", says="display")
        self.bad("--window", DISPLAY=":987", says="display")

    def test_no_off_screen_opengl(self):
        self.bad("--offscreen", *SMALL, __EGL_VENDOR_LIBRARY_FILENAMES="/nothing.json",
                 EGL_PLATFORM="none", says="OpenGL")
        (self.folder / "libEGL.so.1").write_text("no library")
        self.bad("--offscreen", *SMALL, LD_LIBRARY_PATH=str(self.folder),
                 says="libEGL.so.1 cannot be loaded")


class Outputs(CommandLine):
    """What a complete off-screen run leaves behind."""

    def test_everything_is_written(self):
        run = ["--offscreen", "--size", "161x121", "--fps", "10", "--frames", "3",
               "--out", "-o ut'$(x)", "--duration", repr(20 * self.scene["dt"])]
        self.good(*run)
        out = self.folder / "-o ut'$(x)"
        expected = {"filmstrip.png", "trajectory.csv", "history.csv", "results.json",
                    "frames"}
        if shutil.which("ffmpeg"):
            expected.add("movie.mp4")
        self.assertEqual({p.name for p in out.iterdir()}, expected)
        self.assertEqual([p.name for p in sorted((out / "frames").iterdir())],
                         ["frame-0000.png", "frame-0001.png", "frame-0002.png"])
        if shutil.which("ffprobe") and shutil.which("ffmpeg"):
            self.check_movie(out / "movie.mp4")

    def check_movie(self, movie):
        probe = subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-of", "json", "-show_entries",
             "stream=codec_name,pix_fmt,width,height,nb_read_frames", f"file:{movie}"],
            capture_output=True, text=True, check=True)
        stream = json.loads(probe.stdout)["streams"][0]
        self.assertEqual(stream["codec_name"], "h264")
        self.assertEqual(stream["pix_fmt"], "yuv420p")
        self.assertEqual((stream["width"], stream["height"]), (162, 122))
        self.assertEqual(int(stream["nb_read_frames"]), 21)  # 2 s, both ends

    def test_numbers_are_those_of_a_headless_run(self):
        run = ["--scene", self.scene["name"], *self.short(), "--results"]
        self.good("--headless", *run, "a.json")
        self.good("--offscreen", *SMALL, "--out", "o", *run, "b.json")
        a, b = (json.loads((self.folder / n).read_text()) for n in ("a.json", "b.json"))
        self.assertTrue(a.pop("cost") and b.pop("cost"))
        self.assertEqual(a, b)

    def test_results_to_standard_output_alone(self):
        done = self.good("--offscreen", *SMALL, "--out", "o", "--results", "-",
                         *self.short())
        json.loads(done.stdout)
        self.assertFalse((self.folder / "o/results.json").exists())

    def test_a_second_run_replaces_the_first(self):
        run = ["--offscreen", *SMALL, *self.short(), "--out", "o", "--frames"]
        self.good(*run, "4")
        (self.folder / "o/frames/mine.png").write_text("mine")
        self.good(*run, "2")
        self.assertEqual([p.name for p in sorted((self.folder / "o/frames").iterdir())],
                         ["frame-0000.png", "frame-0001.png", "mine.png"])

    def test_a_link_stays_a_link(self):
        (self.folder / "real.json").write_text("old")
        (self.folder / "link.json").symlink_to("real.json")
        self.good("--headless", "--results", "link.json", *self.short())
        self.assertTrue((self.folder / "link.json").is_symlink())
        json.loads((self.folder / "real.json").read_text())


class Pictures(CommandLine):
    def check_picture(self, file, size=None):
        width, height, pixels = read_png(file)
        if size:
            self.assertEqual((width, height), size)
        self.assertGreater(len(set(pixels)), 20, f"{file} is blank")

    def test_pictures_show_something(self):
        self.good("--offscreen", *SMALL, "--out", "o", "--frames", "2", *self.short())
        self.check_picture(self.folder / "o/filmstrip.png")
        for i in range(2):
            self.check_picture(self.folder / f"o/frames/frame-000{i}.png", (160, 120))

    def test_the_end_differs_from_the_start(self):
        self.good("--offscreen", *SMALL, "--out", "o", "--frames", "2")
        first, last = ((self.folder / f"o/frames/frame-000{i}.png").read_bytes()
                       for i in range(2))
        self.assertNotEqual(first, last)

    def test_without_ffmpeg(self):
        done = self.good("--offscreen", *SIZE, "--out", "o", *self.short(),
                         PATH="/nowhere")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn("ffmpeg", done.stderr)
        self.assertFalse((self.folder / "o/movie.mp4").exists())

    def test_with_a_broken_ffmpeg(self):
        fake = self.folder / "bin/ffmpeg"
        fake.parent.mkdir()
        for script, says in (("exit 3", "ffmpeg ended with 3"),
                             ("cat >/dev/null", "ffmpeg wrote nothing")):
            fake.write_text(f"#!/bin/sh\n{script}\n")
            fake.chmod(0o755)
            done = self.good("--offscreen", *SIZE, "--out", "o", *self.short(),
                             PATH=f"{fake.parent}:{os.environ['PATH']}")
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(says, done.stderr)
            self.assertEqual(self.left_behind()[2:], [
                "o", "o/filmstrip.png", "o/history.csv", "o/results.json",
                "o/trajectory.csv"])

    def test_any_shape_of_picture_and_step(self):
        for size in ("64x64", "300x70", "70x300"):
            self.good("--offscreen", "--no-movie", "--size", size, "--out", size,
                      "--frames", "1", *self.short())
            self.check_picture(self.folder / size / "filmstrip.png")
        self.good("--offscreen", "--size", "64x64", "--fps", "24", "--out", "long",
                  "--dt", "0.25", "--duration", "0.5")


class Display(CommandLine):
    """With and without a display."""

    server, display = None, ""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if not shutil.which("Xvfb"):
            return
        # The server picks a display that is free, and says which once it is ready
        reading, writing = os.pipe()
        cls.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", "800x600x24"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as pipe:
            cls.display = ":" + pipe.readline().strip()

    @classmethod
    def tearDownClass(cls):
        if cls.server:
            cls.server.terminate()
            cls.server.wait()

    def under_xvfb(self, *arguments):
        if not self.server:
            self.skipTest("there is no Xvfb")
        return self.good(*arguments, "--size", "320x240", DISPLAY=self.display)

    def test_a_window_opens_and_closes(self):
        done = self.under_xvfb("--window", "--window-frames", "4")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        self.assertEqual(self.left_behind(), [])

    def test_a_window_is_the_default(self):
        self.under_xvfb("--window-frames", "3", "--method", "all")
        self.assertEqual(self.left_behind(), [])

    def test_every_scene_opens(self):
        for scene in self.listing["scenes"]:
            name = scene["name"]
            self.under_xvfb("--window", "--window-frames", "2", "--scene", name)

    def test_files_asked_for_are_written_despite_a_display(self):
        self.under_xvfb("--results", "r.json", "--no-movie", *self.short())
        self.assertTrue((self.folder / "r.json").exists())

    def test_without_a_display_it_goes_on_off_screen(self):
        done = self.good(*SMALL, "--out", "o", *self.short())
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn("--offscreen", done.stderr)
        self.assertTrue((self.folder / "o/filmstrip.png").exists())


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    EXECUTABLE = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
