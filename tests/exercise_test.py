"""Tests of ./timestep exercise, and that every exercise has all of its parts.

A copy of the script runs with a compiler and tests that are made up, over two exercises.
"""
from __future__ import annotations

import re
import unittest

from setup_test import ROOT, Script

COMPILER_SAYS = "1_1_drop.cpp:7: error: 'sped' was not declared"


class ExerciseTest(Script):
    def setUp(self) -> None:
        super().setUp()
        self.system("apt")
        folder = self.root / "chapters/01-fall/exercises"
        (folder / "solutions").mkdir(parents=True)
        for name, line in (("1_1_drop", "1.1, warm-up: Let it drop"),
                           ("1_2_lift", "1.2, core: Pick it up")):
            (folder / f"{name}.hpp").write_text(f"/// @file\n/// Exercise {line}\n")
            (folder / f"solutions/{name}.cpp").write_text(f"// {name} solved\n")
        self.programs = self.root / "build/release/bin"
        self.programs.mkdir(parents=True)
        self.file = "chapters/01-fall/exercises/1_1_drop.cpp"

    def answer(self, said: str, code: int, built: bool = True) -> None:
        """What the exercise's test says, or what Ninja says that does not get so far."""
        program = self.programs / "exercise-1.1"
        ninja = (f"echo 'FAILED: drop.o'; echo 'c++ -long drop.cpp'; "
                 f"echo \"{COMPILER_SAYS}\"; "
                 f"echo 'ninja: build stopped: subcommand failed.'; exit 1")
        self.fake("cmake", "" if built else f'[[ $1 == --preset ]] || {{ {ninja}; }}')
        program.write_text(f"#!{self.bin}/bash\ncat <<'END'\n{said}\nEND\nexit {code}\n")
        program.chmod(0o755)

    def test_alone_it_lists_the_exercises_and_builds_nothing(self) -> None:
        code, said = self.timestep("exercise", lacking="libglm-dev")
        self.assertEqual(code, 0)
        self.assertRegex(said, rf"^1\.1 +warm-up +Let it drop +{self.file}\n"
                               r"1\.2 +core +Pick it up +[^\n]*/1_2_lift\.cpp\n$")

    def test_a_right_answer_is_told(self) -> None:
        self.answer("Passed all 2 test cases with 3 assertions.", 0)
        code, said = self.timestep("exercise", "1.1")
        self.assertEqual(code, 0)
        self.assertRegex(said, r"^Exercise 1\.1 is solved\.[^\n]* --solution\n$")

    def test_a_wrong_answer_is_told_in_words(self) -> None:
        self.answer("what I print\n/a.hpp:1: failed: explicitly with 1 message: "
                    "'Euler's v: yours is 1'\nFailed 1 test case, failed 1 assertion.", 1)
        code, said = self.timestep("exercise", "1.1")
        self.assertEqual(code, 1)
        self.assertEqual(said.splitlines(), [
            "what I print", "- Euler's v: yours is 1",
            f"timestep: exercise 1.1 is not solved yet; edit {self.file} and try again"])

    def test_a_crash_is_a_wrong_answer(self) -> None:
        self.answer("/a.cpp:1: failed: fatal error condition with message: "
                    "'SIGSEGV - Segmentation violation signal'", 139)
        code, said = self.timestep("exercise", "1.1")
        self.assertEqual(code, 1)
        self.assertIn("- SIGSEGV", said)

    def test_of_a_file_that_does_not_compile_the_compilers_words_are_shown(self) -> None:
        self.answer("", 0, built=False)
        code, said = self.timestep("exercise", "1.1")
        self.assertEqual(code, 1)
        self.assertEqual(said.splitlines(), [
            COMPILER_SAYS,
            f"timestep: {self.file} does not build; the compiler says why"])

    def test_missing_packages_are_told_first(self) -> None:
        code, said = self.timestep("exercise", "1.1", lacking="libglm-dev")
        self.assertEqual((code, said.count("\n")), (2, 1), said)
        self.assertIn("sudo apt-get install libglm-dev", said)

    def test_the_solution_is_shown(self) -> None:
        self.assertEqual(self.timestep("exercise", "1.2", "--solution"),
                         (0, "// 1_2_lift solved\n"))

    def test_unknown_exercises_name_the_nearest(self) -> None:
        for word, nearest in (("1.3", "1.2"), ("2.1", "1.1"), ("", "1."), ("*", "1."),
                              ("1.1 1.2", "1."), ("--solution", "1.")):
            code, said = self.timestep("exercise", word)
            self.assertEqual(code, 2)
            self.assertRegex(said, rf"^timestep: no exercise [^\n]*'{nearest}[^\n]*\n$")

    def test_words_that_it_does_not_take_are_refused(self) -> None:
        for words in (("1.1", "more"), ("1.1", "--solution", "more")):
            code, said = self.timestep("exercise", *words)
            self.assertEqual(code, 2)
            self.assertRegex(said, r"^timestep: exercise takes [^\n]* more'\n$")


class EveryExercise(unittest.TestCase):
    def test_has_all_of_its_parts(self) -> None:
        headers = sorted(ROOT.glob("chapters/*/exercises/*.hpp"))
        self.assertTrue(headers)
        for header in headers:
            with self.subTest(header.name):
                folder, name = header.parent, header.stem
                number = ".".join(name.split("_")[:2])
                self.assertEqual(int(folder.parent.name[:2]), int(number.split(".")[0]))
                for part in (f"{name}.cpp", f"{name}_test.cpp", f"solutions/{name}.cpp"):
                    self.assertTrue((folder / part).is_file(), f"{part} is missing")

                # The text has its title, its grade and the command
                first = re.search(rf"^/// Exercise {number}, ([\w-]+): (.+)$",
                                  header.read_text(encoding="utf-8"), re.MULTILINE)
                self.assertTrue(first, "no line '/// Exercise N.M, grade: Title'")
                text = (folder.parent / "README.md").read_text(encoding="utf-8")
                self.assertIn(f"**{number} {first[2]}** ({first[1]})", text)
                self.assertIn(f"`./timestep exercise {number}`", text)

    def test_has_a_header(self) -> None:
        for test in ROOT.glob("chapters/*/exercises/*_test.cpp"):
            header = test.with_name(test.name.replace("_test.cpp", ".hpp"))
            self.assertTrue(header.is_file(), f"{header} is missing")


if __name__ == "__main__":
    unittest.main()
