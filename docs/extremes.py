"""Runs the chapters' extremes, and compares what comes out with what is published.

    extremes.py [CHAPTER…]              run them, and name what is no longer as published
    extremes.py --publish [CHAPTER…]    run them, and publish what comes out
    extremes.py --published CHAPTER     print the published table, and run nothing
    extremes.py --page [--check]        write docs/extremes.md of all that is published

Each row of chapters/NN-name/extremes.json is one run in both precisions: its `args`, the
`kind` of extreme that it is, the `metric` that judges it, and two limits: up to `accurate`
the run counts as accurate, up to `bounded` as bounded (wrong, but within sight), beyond as
exploded. A run whose numbers cease to be finite must say so itself: "overflows", and so
must a method that finds no next step: "stops". What came out stands beside it, in
extremes_results.json: a verdict and a number of two digits for each precision. Any other
verdict or number is one line on standard error and exit code 1.
"""
from __future__ import annotations

import argparse
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import extremes_page
from extremes_page import ROOT, PublishError, find_chapters, published, rows_of

PRECISIONS = ("double", "single")
LONGEST = 120  # [s] of one run


def measure(program: Path, row: dict, precision: str) -> str:
    """Runs one extreme and judges it: "bounded: 0.3 m"."""
    command = [str(program), "--headless", "--results", "-", "--precision", precision,
               *row["args"]]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST,
                              stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        raise PublishError(f"{row['what']}: not done after {LONGEST} s") from None
    if done.returncode == 2:
        return "refused"
    if done.returncode != 0:
        said = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
        return f"crashed: {said[-1]}"
    return judge(json.loads(done.stdout), row)


def judge(results: dict, row: dict) -> str:
    if "failed" in results:
        failed = results["failed"]
        verdict = "stops" if "no solution" in failed["what"] else "overflows"
        return f"{verdict}: step {failed['step']}"
    metric = results["metrics"].get(row["metric"])
    if metric is None:
        raise PublishError(f"{row['what']}: there is no metric {row['metric']}")
    size = abs(float(metric["value"]))
    verdict = ("accurate" if size <= row["accurate"] else
               "bounded" if size <= row["bounded"] else "explodes")
    return f"{verdict}: {size:.2g} {metric['unit']}".strip()


def measure_all(program: Path, rows: list[dict]) -> dict[str, list[str]]:
    jobs = [(row, precision) for row in rows for precision in PRECISIONS]
    with ThreadPoolExecutor(2) as pool:
        flat = list(pool.map(lambda job: measure(program, *job), jobs))
    return {row["what"]: flat[2 * i:2 * i + 2] for i, row in enumerate(rows)}


def table(rows: list[dict], outcomes: dict[str, list[str]]) -> str:
    lines = ["| extreme | judged by | double | single | what to do |",
             "|---|---|---|---|---|"]
    for row in rows:
        metric = row["metric"].replace("_", " ")
        cells = [row["what"], metric, *outcomes[row["what"]], row["remedy"]]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def changes(old: dict[str, list[str]], new: dict[str, list[str]]) -> list[str]:
    """A line for each outcome that is not as published."""
    found = [f"{what}: not published yet" for what in new if what not in old]
    return found + [f"{what}, {precision}: {is_now}, published {was}"
                    for what in new if what in old
                    for precision, is_now, was in zip(PRECISIONS, new[what], old[what])
                    if is_now != was]


def run_chapter(folder: Path, options: argparse.Namespace) -> int:
    """Runs a chapter's extremes; returns how many outcomes are not as published."""
    program = options.bin / folder.name
    if not program.is_file():
        raise PublishError(f"there is no {program} (./timestep test builds it)")
    rows = chosen(folder, options)
    outcomes = measure_all(program, rows)
    if not options.publish:
        print(table(rows, outcomes))
    changed = changes(published(folder), outcomes)
    for line in changed:
        print(f"extremes: {folder.name}: {line}", file=sys.stderr)
    if options.publish:
        extremes_page.publish(folder, outcomes)
        print(f"{folder.name}: {len(outcomes)} extremes published, "
              f"{len(changed)} outcomes changed")
    return len(changed)


def chosen(folder: Path, options: argparse.Namespace) -> list[dict]:
    return [row for row in rows_of(folder)
            if options.method is None or options.method in row["args"]][::options.every]


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("chapters", nargs="*", metavar="CHAPTER",
                        help="such as 01-particles; all without one")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--publish", action="store_true", help="write what comes out")
    what.add_argument("--published", action="store_true", help="run nothing")
    what.add_argument("--page", action="store_true", help="write docs/extremes.md alone")
    parser.add_argument("--check", action="store_true",
                        help="with --page: write nothing, and say whether it is stale")
    parser.add_argument("--method", help="only the rows that name this method")
    parser.add_argument("--every", type=int, default=1, metavar="N",
                        help="only one row of N: for the sanitizers, which take long")
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin")
    options = parser.parse_args()
    if options.publish and (options.method or options.every != 1):
        parser.error("--publish takes whole chapters")
    if options.check and not options.page:
        parser.error("--check goes with --page")
    return options


def main() -> int:
    options = parse()
    if options.page:
        return extremes_page.bring_up_to_date(ROOT, options.check)
    folders = find_chapters(ROOT, options.chapters)
    if options.published:
        for folder in folders:
            print(table(chosen(folder, options), published(folder)))
        return 0
    changed = sum(run_chapter(folder, options) for folder in folders)
    if options.publish:
        return extremes_page.bring_up_to_date(ROOT, check=False)
    return 1 if changed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except PublishError as problem:
        print(f"extremes: {problem}", file=sys.stderr)
        sys.exit(2)
