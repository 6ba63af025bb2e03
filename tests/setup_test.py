"""Tests of ./timestep's set-up: what it says and does where packages are missing.

A copy of the script runs with package managers that are made up, so that nothing is
installed and every system gives the same answer.
"""
from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TOOLS = ("bash", "cat", "comm", "dirname", "env", "mkdir", "readlink", "sed", "sort")
# Each answers which of its arguments are installed: all but those in $LACKING
MANAGERS = {
    "apt": ("dpkg-query", 'shift 3; for p; do case " $LACKING " in *" $p "*) ;; '
                          '*) echo "installed $p" ;; esac; done'),
    "dnf": ("rpm", 'shift 3; for p; do case " $LACKING " in *" $p "*) '
                   'echo "package $p is not installed" ;; *) echo "$p" ;; esac; done'),
    "pacman": ("pacman", 'shift; for p; do case " $LACKING " in *" $p "*) ;; '
                         '*) echo "$p" ;; esac; done'),
    "brew": ("brew", 'echo glm'),
}


class Script(unittest.TestCase):
    """A copy of the script in a folder of its own, with nothing but made-up programs."""

    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name).resolve()
        (self.root / "cmake").mkdir()
        shutil.copy(ROOT / "timestep", self.root)
        shutil.copy(ROOT / "cmake/packages.txt", self.root / "cmake")
        self.bin = self.root / "bin"
        self.bin.mkdir()
        for tool in TOOLS:
            (self.bin / tool).symlink_to(shutil.which(tool))
        (self.bin / "python3").symlink_to(sys.executable)
        self.fake("id", "echo 1000")
        self.fake("sudo", "exit 1")

    def fake(self, name: str, script: str) -> None:
        (self.bin / name).write_text(f"#!{self.bin}/bash\n{script}\n")
        (self.bin / name).chmod(0o755)

    def system(self, manager: str) -> None:
        if manager == "dnf":
            self.fake("dnf", "")
        self.fake(*MANAGERS[manager])

    def timestep(self, *words: str, lacking: str = "", script: Path | None = None,
                 **more: str) -> tuple[int, str]:
        environment = {"PATH": str(self.bin), "LACKING": lacking, "LANG": "C", **more}
        run = subprocess.run([script or self.root / "timestep", *words], cwd="/",
                             env=environment, capture_output=True, text=True,
                             stdin=subprocess.DEVNULL)
        return run.returncode, run.stdout + run.stderr


class SetupTest(Script):
    def test_help_lists_the_commands_from_any_folder(self) -> None:
        for words in ((), ("help",), ("--help",)):
            code, said = self.timestep(*words)
            self.assertEqual(code, 0)
            for command in ("tour", "test", "exercise", "book", "extremes", "bench", "format",
                            "setup"):
                self.assertIn(f"\n  {command} ", said)

    def test_unknown_command_names_the_nearest(self) -> None:
        code, said = self.timestep("tuor")
        self.assertEqual(code, 2)
        self.assertRegex(said, r"^timestep: no command 'tuor'; [^\n]*'tour'[^\n]*\n$")

    def test_words_that_a_command_does_not_take_are_refused(self) -> None:
        for command in ("help", "setup", "book", "format"):
            code, said = self.timestep(command, "more")
            self.assertEqual(code, 2)
            self.assertRegex(said, rf"^timestep: {command} [^\n]*'more'\n$")

    def test_it_works_through_a_link(self) -> None:
        self.system("apt")
        link = self.root / "elsewhere" / "link"
        link.parent.mkdir()
        link.symlink_to(self.root / "timestep")
        code, said = self.timestep("setup", lacking="libglm-dev", script=link)
        self.assertEqual(code, 2)
        self.assertIn("sudo apt-get install libglm-dev", said)

    def test_a_place_that_cannot_be_written_is_one_line(self) -> None:
        self.system("apt")
        (self.root / "build").write_text("not a folder")
        for command in ("tour", "test"):
            code, said = self.timestep(command)
            self.assertEqual(code, 2)
            self.assertRegex(said, r"^timestep: cannot write into [^\n]*/build\n$")

    def test_nothing_is_said_where_nothing_is_missing(self) -> None:
        for manager in ("apt", "dnf", "pacman"):
            self.system(manager)
            self.assertEqual(self.timestep("setup"), (0, ""), manager)
            shutil.rmtree(self.root / "build", ignore_errors=True)

    def test_missing_packages_become_one_line_to_type(self) -> None:
        for manager, lacking, line in (
                ("brew", "", "brew install "),
                ("pacman", "glm python", "sudo pacman -S --needed glm python"),
                ("dnf", "glm-devel", "sudo dnf install glm-devel"),
                ("apt", "catch2 libglm-dev", "sudo apt-get install catch2 libglm-dev")):
            self.system(manager)
            for command in ("setup", "tour", "test"):
                code, said = self.timestep(command, lacking=lacking)
                self.assertEqual((code, said.count("\n")), (2, 1), said)
                self.assertIn(f"type: {line}", said)
                self.assertNotIn(" -\n", said)

    def test_developers_packages_are_set_up_only_when_asked_for(self) -> None:
        self.system("apt")
        self.assertEqual(self.timestep("setup", lacking="clang-tidy"), (0, ""))
        code, said = self.timestep("setup", "developer", lacking="clang-tidy")
        self.assertEqual(code, 2)
        self.assertRegex(said, r"^timestep: [^\n]* sudo apt-get install clang-tidy\n$")
        self.assertEqual(self.timestep("setup", "developer"), (0, ""))

    def test_packages_of_bench_are_set_up_only_when_asked_for(self) -> None:
        self.system("apt")
        lacking = "libbenchmark-dev libgsl-dev"
        self.assertEqual(self.timestep("setup", lacking=lacking), (0, ""))
        code, said = self.timestep("setup", "bench", lacking=lacking)
        self.assertEqual(code, 2)
        self.assertRegex(said, r"^timestep: [^\n]* apt-get install libbenchmark-dev\n$")
        code, said = self.timestep("setup", "bench", lacking="libgsl-dev")
        self.assertEqual(code, 0)
        self.assertRegex(said, r"^Optional [^\n]+: sudo apt-get install libgsl-dev\n$")

    def test_missing_optional_packages_are_said_and_passed_over(self) -> None:
        self.system("apt")
        code, said = self.timestep("setup", lacking="ffmpeg")
        self.assertEqual(code, 0)
        self.assertRegex(said, r"^Optional [^\n]+: sudo apt-get install ffmpeg\n$")

    def test_the_book_needs_doxygen_and_would_like_mathjax(self) -> None:
        self.system("apt")
        (self.root / "docs").mkdir()
        (self.root / "docs/book.py").write_text("print('made')")
        lacking = "g++ doxygen libjs-mathjax"
        code, said = self.timestep("book", lacking=lacking)
        self.assertEqual(code, 2)
        self.assertRegex(said, r"^timestep: [^\n]* sudo apt-get install doxygen\n$")
        self.fake("doxygen", "")
        code, said = self.timestep("book", lacking=lacking)
        self.assertEqual(code, 0)
        self.assertRegex(said, r"^Optional [^\n]* apt-get install libjs-mathjax\nmade\n$")

    def test_root_installs_and_fetches_the_lists_only_when_needed(self) -> None:
        self.system("apt")
        self.fake("id", "echo 0")
        calls = self.root / "calls"
        lists = self.root / "lists"
        self.fake("apt-get", f"""echo "$DEBIAN_FRONTEND $*" >> {calls}
            [[ $1 == update ]] && echo > {lists}
            [[ -e {lists} ]]""")
        code, said = self.timestep("setup", lacking="libglm-dev")
        self.assertEqual(code, 0, said)
        install = "noninteractive install -y -qq --no-install-recommends libglm-dev"
        called = calls.read_text().splitlines()
        self.assertEqual(called, [install, " update -qq", install])
        self.timestep("setup", lacking="libglm-dev")
        self.assertEqual(calls.read_text().splitlines()[3:], [install])

    def test_failed_installations_are_told(self) -> None:
        self.system("apt")
        self.fake("sudo", 'shift; "$@"')
        self.fake("apt-get", "exit 100")
        code, said = self.timestep("setup", lacking="libglm-dev")
        self.assertEqual(code, 2)
        self.assertIn("could not install libglm-dev", said)
        for _ in range(2):
            code, said = self.timestep("setup", lacking="ffmpeg")
            self.assertEqual(code, 0)
        self.assertNotIn("Installing", said)

    def test_nothing_is_installed_where_that_is_not_wanted(self) -> None:
        self.system("apt")
        self.fake("id", "echo 0")
        self.fake("apt-get", f"echo > {self.root}/called")
        code, _ = self.timestep("setup", lacking="libglm-dev", TIMESTEP_NO_INSTALL="1")
        self.assertEqual(code, 2)
        self.assertFalse(os.path.exists(self.root / "called"))


if __name__ == "__main__":
    unittest.main()
