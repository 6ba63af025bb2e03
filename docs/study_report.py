"""What follows a study: its diagrams and the ingredients.

    python3 docs/study_report.py --out out/study [--quick] [--publish]

Reads OUT/study.csv and writes OUT/figures and OUT/ingredients.json;
--publish keeps what the book is woven from: study/results.csv, study/ingredients.json,
and in study/machine.json where the times were taken.
"""
from __future__ import annotations

import argparse
import importlib.util
import json
import math
import os
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import study_data  # noqa: E402
import study_figures  # noqa: E402
from weave_runs import ROOT, WeaveError, machine  # noqa: E402


def measure_ingredients(program: Path, quick: bool) -> dict:
    done = subprocess.run([program, "--json", "-", *["--quick"][:quick]],
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise WeaveError(f"{program.name} failed: {done.stderr.strip()}")
    return {"machine": machine()} | json.loads(done.stdout)


def refuse_part(problem: dict, records: list[study_data.Record]) -> None:
    """Refuses records that are not all settings of a problem, or lack times."""
    own = [r for r in study_data.ours(records) if r.problem == problem["name"]]
    if len(own) != problem["cells"]:
        raise WeaveError("--publish keeps the whole study: of the settings of "
                         f"{problem['name']} it has {len(own)}, not {problem['cells']}")
    untimed = [r.key for r in own if not r.failed
               and not math.isfinite(study_data.number(r.cells.get("us_per_frame")))]
    if untimed:
        raise WeaveError(f"--publish keeps times, and {untimed[0]} has none")


def whole_study(program: Path, records: list[study_data.Record]) -> dict:
    """What the study's program says of itself; refuses records that are not all."""
    done = subprocess.run([program, "--list", "--json"], capture_output=True, text=True)
    if done.returncode != 0:
        raise WeaveError(f"{program.name} --list failed: {done.stderr.strip()}")
    listed = json.loads(done.stdout)
    for problem in listed["problems"]:
        refuse_part(problem, records)
    return listed


def put(file: Path, text: str) -> None:
    """Whole or not at all."""
    part = file.with_name(file.name + ".part")
    part.write_text(text, encoding="utf-8")
    os.replace(part, file)


def report(options: argparse.Namespace) -> None:
    out, file = options.out, options.out / "study.csv"
    records = study_data.read(file)
    if options.publish:
        listed = whole_study(options.program.parent / "study", records)
    if importlib.util.find_spec("matplotlib") is None:
        print("no figures: install matplotlib to have them (python3-matplotlib)")
    else:
        drawn = study_figures.draw_all(file, out / "figures")
        print(f"{len(drawn)} figures: {out / 'figures'}")

    found = measure_ingredients(options.program, options.quick)
    text = json.dumps(found, indent=1, ensure_ascii=False) + "\n"
    put(out / "ingredients.json", text)
    print(f"what each ingredient costs: {out / 'ingredients.json'}")
    if options.publish:
        made = {"machine": machine(), "compiler": listed["compiler"]}
        put(options.root / study_data.MACHINE, json.dumps(made, indent=1) + "\n")
        put(options.root / study_data.PUBLISHED, file.read_text(encoding="utf-8"))
        put(options.root / study_data.INGREDIENTS, text)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "out/study")
    parser.add_argument("--quick", action="store_true", help="time three runs, not 41")
    parser.add_argument("--publish", action="store_true",
                        help="keep what was found for the text")
    parser.add_argument("--program", type=Path, help=argparse.SUPPRESS,
                        default=ROOT / "build/release/bin/ingredients")
    parser.add_argument("--root", type=Path, help=argparse.SUPPRESS, default=ROOT)
    options = parser.parse_args()
    if options.quick and options.publish:
        parser.error("--quick measures nothing that could be published")
    try:
        report(options)
    except (OSError, WeaveError) as error:
        print(f"study_report: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
