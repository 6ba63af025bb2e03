"""The tables of chapter 5 that need more than one run: prints one of them as Markdown.

    python3 chapters/05-penetration/tables.py pop|growth
"""
from __future__ import annotations

import sys
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "docs"))
import run_table  # noqa: E402  (after the path to it)
from weave_runs import written  # noqa: E402

pile = partial(run_table.run, "05-penetration", "--scene", "overlap-recovery")
GRAVITY = 9.81


def number(results: dict, name: str) -> float:
    return float(results["metrics"][name]["value"])


def pop() -> str:
    """Baumgarte's speed of one box at five steps, and how high it carries the box."""
    run = partial(pile, "--preset", "resting", "--method", "baumgarte",
                  "--duration", 0.5)
    lines = ["| dt [s] | speed, measured [m/s] | by (5.4) [m/s] | good for a rise of [cm] "
             "| hop over the floor under gravity [cm] |", "|---|---:|---:|---:|---:|"]
    for rate in (30, 60, 120, 240, 480):
        free = run("--dt", repr(1 / rate))
        p = free["parameters"]
        speed = number(free, "speed_max")
        formula = p["beta"] * rate * (p["overlap"] * p["size"] - p["slop"])
        heavy = run("--dt", repr(1 / rate), "--set", f"gravity={GRAVITY}")
        cells = (written(speed, ".3g"), written(formula, ".3g"),
                 written(100 * speed ** 2 / (2 * GRAVITY), ".3g"),
                 written(100 * number(heavy, "hop_max"), ".2g"))
        lines.append(f"| 1/{rate} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def growth() -> str:
    """What one step leaves in piles of more and more boxes."""
    sweeps = (50, 200, 800)
    lines = ["| boxes | " + " | ".join(f"{n} sweeps [mm]" for n in sweeps) + " |",
             "|---|" + "---:|" * len(sweeps)]
    for boxes in (5, 10, 20):
        left = [1000 * number(pile("--method", "linear_projection", "--duration", 0.017,
                                   "--set", f"boxes={boxes}", "--set", f"iterations={n}",
                                   "--set", "slop=0", "--set", "gravity=0"),
                              "penetration") for n in sweeps]
        lines.append(f"| {boxes} | " + " | ".join(written(x, ".2g") for x in left)
                     + " |")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(run_table.main({"pop": pop, "growth": growth}))
