"""Runs a chapter's extremes and prints the table of outcomes as Markdown.

Each row of chapters/NN-name/extremes.json is one run in both precisions: its `args`,
the `metric` that judges it, and two limits: up to `accurate` the run counts as accurate,
up to `bounded` as bounded (wrong, but within sight), beyond as exploded. A run whose
numbers cease to be finite must say so itself: "overflows", and so must a method that
finds no next step: "stops". `expect` has the verdicts that are published; any other
verdict is one line on standard error and exit code 1.
"""
from __future__ import annotations

import argparse
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PRECISIONS = ("double", "single")


@dataclass
class Outcome:
    verdict: str
    number: str


def measure(program: Path, row: dict, precision: str) -> Outcome:
    """Runs one extreme and judges it."""
    command = [str(program), "--headless", "--results", "-", "--precision", precision,
               *row["args"]]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    if done.returncode == 2:
        return Outcome("refused", "")
    if done.returncode != 0:
        said = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
        return Outcome("crashed", said[-1])

    results = json.loads(done.stdout)
    if "failed" in results:
        failed = results["failed"]
        verdict = "stops" if "no solution" in failed["what"] else "overflows"
        return Outcome(verdict, f"step {failed['step']}")
    metric = results["metrics"][row["metric"]]
    size = abs(float(metric["value"]))
    verdict = ("accurate" if size <= row["accurate"] else
               "bounded" if size <= row["bounded"] else "explodes")
    return Outcome(verdict, f"{size:.2g} {metric['unit']}".strip())


def cell(outcome: Outcome) -> str:
    return f"{outcome.verdict}: {outcome.number}" if outcome.number else outcome.verdict


def table(rows: list[dict], outcomes: list[list[Outcome]]) -> str:
    lines = ["| extreme | judged by | double | single | what to do |",
             "|---|---|---|---|---|"]
    for row, pair in zip(rows, outcomes):
        metric = row["metric"].replace("_", " ")
        cells = [row["what"], metric, *map(cell, pair), row["remedy"]]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def surprises(rows: list[dict], outcomes: list[list[Outcome]]) -> list[str]:
    return [f"{row['what']}, {precision}: {outcome.verdict}, published {expected}"
            for row, pair in zip(rows, outcomes)
            for precision, outcome, expected in zip(PRECISIONS, pair, row["expect"])
            if outcome.verdict != expected]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("chapter", help="such as 01-particles")
    parser.add_argument("--method", help="only the rows that name this method")
    parser.add_argument("--every", type=int, default=1, metavar="N",
                        help="only one row of N: for the sanitizers, which take long")
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin")
    options = parser.parse_args()
    file = ROOT / "chapters" / options.chapter / "extremes.json"
    program = options.bin / options.chapter
    for needed in (file, program):
        if not needed.is_file():
            print(f"extremes: there is no {needed}", file=sys.stderr)
            return 2
    rows = [row for row in json.loads(file.read_text(encoding="utf-8"))
            if options.method is None or options.method in row["args"]][::options.every]

    jobs = [(row, precision) for row in rows for precision in PRECISIONS]
    with ThreadPoolExecutor(2) as pool:
        flat = list(pool.map(lambda job: measure(program, *job), jobs))
    outcomes = [flat[i:i + 2] for i in range(0, len(flat), 2)]

    print(table(rows, outcomes))
    wrong = surprises(rows, outcomes)
    for line in wrong:
        print(f"extremes: {line}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
