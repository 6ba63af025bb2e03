"""Tests bin/study from the outside: killed and resumed, in shards, under mpirun; and
how bin/ingredients ends.

    07_study.py --study EXECUTABLE --ingredients EXECUTABLE [--mpi EXECUTABLE] [PART…]
"""
from __future__ import annotations

import argparse
import collections
import csv
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SMALL = ["projectile", "spring", "clock"]
STUDY, MPI, INGREDIENTS = Path(), None, Path()
TIMES = ["us_per_frame", "spread", "repeats"]
SKIPPED = 77


def without_times(file: Path) -> list[list[str]]:
    """The table's cells; the times are the last columns."""
    with file.open(newline="", encoding="utf-8") as lines:
        head, *rows = csv.reader(lines)
    assert head[-len(TIMES):] == TIMES
    return [row[:-len(TIMES)] for row in [head, *rows]]


class InFolder(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def study(self, *words: object) -> subprocess.CompletedProcess:
        return subprocess.run([STUDY, *map(str, words)], cwd=self.folder, timeout=300,
                              capture_output=True, text=True, stdin=subprocess.DEVNULL)

    def done(self, *words: object) -> None:
        run = self.study(*words)
        self.assertEqual(run.returncode, 0, run.stderr)

    def refused(self, *words: object, says: str) -> None:
        run = self.study(*words)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertRegex(run.stderr, r"^study: [^\n]*\n$")
        self.assertIn(says, run.stderr)


class Killed(InFolder):
    """Twenty times at random moments: nothing lost, nothing doubled."""

    KILLS = 20

    def start_and_kill(self, more: int, pause: float) -> bool:
        """Once the journal has grown by so many bytes, and after a pause [s]."""
        journal = self.folder / "out/journal.jsonl"
        size = journal.stat().st_size if journal.exists() else 0
        run = subprocess.Popen([STUDY, *SMALL, "--out", "out"], cwd=self.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while run.poll() is None:
            if journal.exists() and journal.stat().st_size >= size + more:
                break
            time.sleep(0.0005)
        time.sleep(pause)
        run.send_signal(signal.SIGKILL)
        return run.wait() == -signal.SIGKILL

    def test_killed_and_resumed(self) -> None:
        self.done(*SMALL, "--out", "whole")
        total = (self.folder / "whole/journal.jsonl").stat().st_size
        chance = random.Random(7)
        journal, before = self.folder / "out/journal.jsonl", b""
        for _ in range(self.KILLS):
            self.assertTrue(self.start_and_kill(chance.randrange(total // 25),
                                                chance.uniform(0, 0.003)))
            now = journal.read_bytes()
            whole = before[:before.rfind(b"\n") + 1]
            self.assertTrue(now.startswith(whole), "a whole line was lost")
            before = now
        self.assertGreater(before.count(b"\n"), self.KILLS)
        self.done(*SMALL, "--out", "out")

        lines = [json.loads(line) for line in journal.read_text().splitlines()]
        for timed in (False, True):
            keys = collections.Counter(line["key"] for line in lines
                                       if (line["repeats"] > 0) == timed)
            self.assertEqual(set(keys.values()), {1}, "something was computed twice")
        self.assertEqual(without_times(self.folder / "whole/study.csv"),
                         without_times(self.folder / "out/study.csv"))

    def test_interrupted_in_words(self) -> None:
        run = subprocess.Popen([STUDY, "orbit", "--out", "out"], cwd=self.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               text=True)
        journal = self.folder / "out/journal.jsonl"
        while run.poll() is None and not (journal.exists() and journal.stat().st_size):
            time.sleep(0.001)
        run.send_signal(signal.SIGINT)
        said = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 130, said)
        self.assertIn("the same command goes on", said.splitlines()[-1])
        self.assertFalse((self.folder / "out/study.csv").exists())


class Shards(InFolder):
    def test_merged_bytes(self) -> None:
        options = [*SMALL, "--no-times"]
        self.done(*options, "--out", "one")
        for shard in (3, 1):
            self.done(*options, "--out", "shards", "--shard", f"{shard}/3")
        self.refused(*options, "--merge", "shards", says="cells are missing")
        self.done(*options, "--merge", "shards", "--partial", "--out", "partial")
        self.done(*options, "--out", "elsewhere", "--shard", "2/3")
        self.done(*options, "--merge", "shards", "elsewhere", "--out", "merged")
        for name in ("study.csv", "study.json"):
            one, merged, partial = ((self.folder / folder / name).read_bytes()
                                    for folder in ("one", "merged", "partial"))
            self.assertEqual(one, merged)
            self.assertLess(len(partial), len(one))

    def test_what_any_journal_has_is_not_computed_again(self) -> None:
        for shard in ("1/2", "2/2"):
            self.done(*SMALL, "--out", "out", "--shard", shard)
        self.done(*SMALL, "--out", "out")
        self.assertEqual((self.folder / "out/journal.jsonl").read_bytes(), b"")
        self.done(*SMALL, "--out", "out", "--shard", "2/3")
        self.assertEqual((self.folder / "out/journal-2-of-3.jsonl").read_bytes(), b"")


class Mpi(InFolder):
    def ranks(self, *words: str) -> subprocess.CompletedProcess:
        """Leaks are looked for without MPI alone: its own are in plugins that it has
        unloaded by then, which no suppression can name."""
        leaks = {"ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"}
        as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_rmaps_base_oversubscribe": "1"}
        return subprocess.run(["mpirun", "-n", "2", MPI, *words], timeout=120,
                              cwd=self.folder, env=os.environ | as_root | leaks,
                              capture_output=True, text=True, stdin=subprocess.DEVNULL)

    def test_two_ranks_give_the_same_bytes(self) -> None:
        self.done(*SMALL, "--out", "one")
        run = self.ranks(*SMALL, "--out", "two")
        self.assertEqual(run.returncode, 0, run.stderr)
        journals = sorted(f.name for f in (self.folder / "two").glob("*.jsonl"))
        self.assertEqual(journals, ["journal-1-of-2.jsonl", "journal-2-of-2.jsonl"])
        self.assertEqual(len(re.findall("errors, 0 %", run.stderr)), 1)
        self.assertEqual(without_times(self.folder / "one/study.csv"),
                         without_times(self.folder / "two/study.csv"))

    def test_a_rank_that_fails_stops_all(self) -> None:
        (self.folder / "two").mkdir()
        (self.folder / "two/journal-2-of-2.jsonl").write_text("no record\n")
        run = self.ranks("clock", "--no-times", "--out", "two")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("journal-2-of-2.jsonl: line 1 is no record", run.stderr)
        self.assertFalse((self.folder / "two/study.csv").exists())
        self.assertEqual((self.folder / "two/journal-1-of-2.jsonl").read_bytes(), b"")

    def test_one_rank_says_what_is_wrong_with_the_call(self) -> None:
        for words, says in ((["orbitt"], "did you mean orbit?"),
                            (["--shard", "1/1"], "ranks are shards")):
            run = self.ranks(*words)
            self.assertNotEqual(run.returncode, 0)
            self.assertEqual(run.stderr.count(says), 1, run.stderr)


class Slurm(InFolder):
    """The script of a job, with programs that only say how they are called."""

    SCRIPT = Path(__file__).resolve().parent.parent / "study/study.slurm"

    def setUp(self) -> None:
        super().setUp()
        (self.folder / "build/release/bin").mkdir(parents=True)
        for program in ("sbatch", "build/release/bin/study"):
            file = self.folder / program
            file.write_text(f'#!/bin/sh\necho {file.name} "$@"\n')
            file.chmod(0o755)

    def job(self, task: int, least: int, most: int,
            **more: str) -> subprocess.CompletedProcess:
        numbers = {"SLURM_ARRAY_JOB_ID": "42", "SLURM_ARRAY_TASK_ID": str(task),
                   "SLURM_ARRAY_TASK_MIN": str(least),
                   "SLURM_ARRAY_TASK_MAX": str(most)}
        path = {"PATH": f"{self.folder}:{os.environ['PATH']}"}
        return subprocess.run(["bash", self.SCRIPT, "orbit"], cwd=self.folder,
                              env=path | numbers | more, timeout=60,
                              capture_output=True, text=True)

    def test_a_job_a_shard_and_the_first_submits_the_merge(self) -> None:
        first, last = (self.job(task, 1, 4).stdout.splitlines() for task in (1, 4))
        self.assertEqual(last, ["study orbit --out out/study --shard 4/4"])
        self.assertEqual(first[1], "study orbit --out out/study --shard 1/4")
        for word in ("--dependency=afterok:42", "--kill-on-invalid-dep=yes", "orbit"):
            self.assertIn(word, first[0].split())
        self.assertEqual(self.job(1, 1, 1, TIMESTEP_MERGE="1").stdout.strip(),
                         "study orbit --merge out/study --out out/study")

    def test_failed_jobs_alone_keep_the_number_of_shards(self) -> None:
        run = self.job(7, 3, 7, SHARDS="16")
        self.assertEqual(run.stdout.strip(),
                         "study orbit --out out/study --shard 7/16")
        for least in (0, 3):
            run = self.job(least, least, 7)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn("must begin at 1", run.stderr)


class Calls(InFolder):
    def test_wrong_calls(self) -> None:
        self.refused("orbitt", says="did you mean orbit?")
        self.refused("--shard", "3/2", says="I from 1 to N")
        self.refused("--merge", "nowhere", says="neither a folder nor a file")
        self.refused("clock", "--out", "/dev/null/x", says="cannot be written")
        self.assertEqual(list(self.folder.iterdir()), [])

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_a_folder_that_may_not_be_read(self) -> None:
        (self.folder / "closed").mkdir(mode=0)
        self.refused("--merge", "closed", says="closed: cannot be read")

    def test_a_journal_of_another_study(self) -> None:
        self.done("clock", "--no-times", "--out", "out")
        journal = self.folder / "out/journal.jsonl"
        journal.write_text(journal.read_text().replace('"settings":{}',
                                                       '"settings":{"n":3}'))
        self.refused("clock", "--out", "out", says="the journal is of another study")
        journal.write_text(journal.read_text().replace('"settings":{"n":3}',
                                                       '"settings":{}')
                           .replace('"duration":600', '"duration":60'))
        self.refused("clock", "--out", "out", says="the journal is of another study")

    def test_quick_thins_a_scene_that_is_named(self) -> None:
        for words in ([], ["--quick"]):
            self.done("clock", "--no-times", "--out", f"out{len(words)}", *words)
        all_rows, rows = (without_times(self.folder / out / "study.csv")
                          for out in ("out0", "out1"))
        self.assertTrue(1 < len(rows) < len(all_rows))

    def test_list_is_for_programs_too(self) -> None:
        listed = json.loads(self.study("--list", "--json").stdout)
        self.assertGreater(len(listed["problems"]), 30)
        self.assertIn(" ", listed["compiler"])


class Ingredients(InFolder):
    def test_what_cannot_be_written_is_said_at_once(self) -> None:
        (self.folder / "folder").mkdir()
        with open("/dev/full", "w", encoding="utf-8") as full:
            for words, out in (([], full), (["--help"], full),
                               (["--json", "folder"], subprocess.PIPE)):
                run = subprocess.run([INGREDIENTS, "--errors-only", *words], stdout=out,
                                     cwd=self.folder, stderr=subprocess.PIPE, text=True,
                                     timeout=60)
                self.assertEqual(run.returncode, 2)
                self.assertRegex(run.stderr, r"^ingredients: [^\n]*\n$")
        self.assertEqual([f.name for f in self.folder.iterdir()], ["folder"])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--study", type=Path, required=True)
    parser.add_argument("--mpi", type=Path)
    parser.add_argument("--ingredients", type=Path)
    options, rest = parser.parse_known_args()
    STUDY, MPI, INGREDIENTS = options.study, options.mpi, options.ingredients
    if "Mpi" in rest and (MPI is None or shutil.which("mpirun") is None):
        print("left out: there is no MPI")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *rest])
