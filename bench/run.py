"""Measures everything in several rounds and writes tables of ratios into out/bench.

bench.json is as Google Benchmark has it, results.json has the medians, table.md the
ratios, and so have table.csv, rotation.csv, top.csv, contacts.csv and growth.csv;
table.md also says who answers how many pairs of chapter 4's truth wrongly, and what
becomes of chapter 6's scenes; so do stacks.csv, accuracy.csv and simbench.csv. Called by
`./timestep bench` after the build. A round measures all once, in an order of its own, so
that what slows the machine down for a while slows everything down alike.
"""
from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
import bench_table  # noqa: E402  (it finds docs)
from weave_runs import machine  # noqa: E402

# Leapfrog and the naive start take the steps of other methods
SKIPPED = "--benchmark_filter=-leapfrog|naive_start"
ROOT = Path(__file__).resolve().parent.parent
# What is asked of the programs of each precision
WORLD_PARTS = {"single": ["stacks", "accuracy"],
               "double": ["stacks", "accuracy", "simbench"]}
WORLD_TABLES = ("stacks", "accuracy", "simbench")
PAIR_FILES = [ROOT / f"tests/truth/{name}.json" for name in bench_table.PAIR_FILES]

LEGEND = """\
{machine}, {compiler}. {bandwidth}

Pairs are single / double precision. Particles are oscillators, 10⁶ of their steps a
second: 4,096 in cache, 1,000,000 in memory; implicit methods get one. *whole*: a
method on whole arrays, with any acceleration; *swarm* and *alone*: the same lines,
compiled for particles that do not feel each other. *by hand*: one vectorised loop of
the same arithmetic. *bandwidth*: what a swarm must read and write in a second, over a
triad's and over an update's in place. Kepler: double, a step of one planet. Rotation:
a step of one of many free bodies, and how far off two of them get at 60 steps a second:
the *attitude error* and *energy* of a top, the *flips* of a body that spins about its
middle axis. *Bullet's bodies*: only what moves a free one; *its world*: as it is meant
to be used, without collision detection. Pairs: of chapter 4's exact ones / of those that
broke other libraries, how many answers are *off* by such a share of the pair's size, on
the *wrong side* of touching, missing or broken off, or never come; of shapes that are
apart SAT and libccd say no more than that. Contacts: ns an answer, in double but for a
Bullet in single, and in brackets how many of a thousand are off by more than 1 %; over
Bullet's time, ours in single / in double.
Growth: overlapping hulls of so many vertices.

Stacks: boxes of 1 m at 60 Hz, all by default, no body asleep; the mean *time* of a step
in the first 5 s, over Bullet's in the same precision, and over what Box3D's and Jolt's
would be by their times over Bullet's (single) on another machine. In 10 s: the deepest
overlap, by one separating axis test for all, the *drift* of the top (of the pile: the
mean way of a box in the last second), the share by which all energy changed. *Stands*:
no box is half its size from its start. Accuracy: at 60 Hz but where it says so; energies
after 10 s. SimBenchmark: all in double, its error and in brackets the seconds of processor
time to get there; iterations of `substeps` are substeps, of `worst_first` impacts; what
is left out takes up to hours. ERP is each peer's default of 0.2 but where it is off. Peers:
{peers}.
"""


def measure_round(program: Path, options: list[str]) -> dict:
    """One process that measures everything once; says how far it is."""
    listed = subprocess.run([program, *options, "--benchmark_list_tests"], check=True,
                            capture_output=True, text=True).stdout.splitlines()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "round.json"
        command = [program, *options, "--benchmark_enable_random_interleaving=true",
                   "--benchmark_out_format=json", f"--benchmark_out={file}"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.PIPE) as run:
            done = 0
            for line in run.stdout:
                fifths = done * 5 // len(listed)
                done += line.split(" ")[0] in listed
                if done * 5 // len(listed) > fifths:
                    print(f" {done / len(listed):.0%}", end="", flush=True)
            said = run.stderr.read()
        print()
        if run.returncode != 0:
            sys.exit(f"bench: {program.name} failed: {said.strip()}")
        return json.loads(file.read_text(encoding="utf-8"))


def measure(program: Path, rounds: int, options: list[str]) -> dict:
    """All rounds as one report."""
    report = {}
    for number in range(1, rounds + 1):
        print(f"round {number} of {rounds}:", end="", flush=True)
        one = measure_round(program, options)
        if report:
            report["benchmarks"] += one["benchmarks"]
        else:
            report = one
    return report


def count_wrong(program: Path) -> dict:
    """How many pairs everyone answers wrongly, by names as the medians have."""
    done = subprocess.run([program, *PAIR_FILES], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"bench: {program.name} failed: {done.stderr.strip()}")
    return json.loads(done.stdout)


def move_scenes(programs: Path, quick: bool) -> dict:
    """What becomes of chapter 6's scenes, by names as the medians have."""
    found = {}
    for precision, parts in WORLD_PARTS.items():
        print(f"scenes in {precision}: {', '.join(parts)}", flush=True)
        program = programs / f"world-peers-{precision}"
        done = subprocess.run([program, *["--quick"][:quick], *parts],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"bench: {program.name} failed: {done.stderr.strip()}")
        found |= json.loads(done.stdout)
    return found


def write(folder: Path, report: dict, measured: dict) -> str:
    """All files; returns the table."""
    tables = bench_table.Tables(measured)
    peers = ", ".join(f"{library} ({measured[library]})" if library in measured else
                      f"{library} is not installed"
                      for library in bench_table.LIBRARIES)
    legend = LEGEND.format(**measured, bandwidth=tables.bandwidth(), peers=peers)
    parts = {"table": "all", "rotation": "rotation", "top": "top",
             **{part: part for part in ("pairs", "contacts", "growth", *WORLD_TABLES)}}
    rows = {name: tables.rows(part) for name, part in parts.items()}
    rows = {name: each for name, each in rows.items() if each}
    markdown = [bench_table.markdown(each) for each in rows.values()]
    files = {"bench.json": json.dumps(report, indent=1) + "\n",
             "results.json": json.dumps(measured, indent=1) + "\n",
             "table.md": "\n\n".join([*markdown, legend]),
             **{f"{name}.csv": bench_table.comma_separated(each)
                for name, each in rows.items() if name != "pairs"}}
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return files["table.md"]


def main() -> int:
    parser = argparse.ArgumentParser(prog="./timestep bench", usage=argparse.SUPPRESS,
                                     description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true",
                        help="only see that everything runs; the numbers mean nothing")
    parser.add_argument("--worlds", action="store_true",
                        help="measure chapter 6's scenes alone; all else as published")
    parser.add_argument("--publish", action="store_true",
                        help="keep the medians as bench/results.json, for the text")
    parser.add_argument("--program", type=Path, help=argparse.SUPPRESS,
                        default=ROOT / "build/release/bin/bench")
    parser.add_argument("--out", type=Path, default=ROOT / "out/bench")
    options = parser.parse_args()
    if options.quick and options.publish:
        parser.error("--quick measures nothing that could be published")

    programs = options.program.parent
    seconds = 0.0001 if options.quick else 0.02
    report = {"context": {}, "benchmarks": []}
    if not options.worlds:
        report = measure(options.program, 1 if options.quick else 7,
                         [SKIPPED, f"--benchmark_min_time={seconds}"])
    for precision in bench_table.PRECISIONS:
        times = measure(programs / f"world-times-{precision}", 1 if options.quick else 3,
                        [*["--quick"][:options.quick],
                         f"--benchmark_min_time={seconds}"])
        report["benchmarks"] += times["benchmarks"]

    measured = bench_table.results(report, machine())
    if options.worlds:
        published = json.loads(bench_table.PUBLISHED.read_text(encoding="utf-8"))
        measured = published | {"medians": published["medians"] | measured["medians"]}
    else:
        bench_table.add(measured["medians"],
                        count_wrong(options.program.with_name("pair-peers")))
    bench_table.add(measured["medians"], move_scenes(programs, options.quick))
    print(write(options.out, report, measured))
    if options.publish:
        shutil.copy(options.out / "results.json", bench_table.PUBLISHED)
    return 0


if __name__ == "__main__":
    sys.exit(main())
