"""The tables of chapter 3 that need more than one run: prints one of them as Markdown.

    python3 chapters/03-rigid-bodies/tables.py orders|normalise
"""
from __future__ import annotations

import math
import sys
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "docs"))
import run_table  # noqa: E402  (after the path to it)
from run_table import metric  # noqa: E402
from weave_runs import written  # noqa: E402

run = partial(run_table.run, "03-rigid-bodies")


def orders() -> str:
    """Attitude errors of the free top after ten seconds, their slope, and what is kept."""
    rates = (30, 60, 120)
    runs = [run("--scene", "torque-free", "--method", "all", "--dt", repr(1 / rate),
                "--duration", 10) for rate in rates]
    lines = ["| method | 30 Hz [rad] | 60 Hz [rad] | 120 Hz [rad] | order "
             "| energy, 60 Hz | L, 60 Hz |", "|---|---:|---:|---:|---:|---:|---:|"]
    for method in runs[0]["method"].split(","):
        errors = [metric(r, method, "attitude_error") for r in runs]
        slope = math.log2(errors[1] / errors[2])
        kept = [written(metric(runs[1], method, name), ".0e")
                for name in ("energy_error_max", "momentum_error_max")]
        cells = [written(e, ".1e") for e in errors] + [f"{slope + 0.0:.1f}"] + kept
        lines.append(f"| `{method}` | " + " | ".join(cells) + " |")
    return "\n".join(lines).replace(" -0.0 ", " 0.0 ")


def normalise() -> str:
    """What add-and-normalise loses on a ball in a second, measured and by its formula."""
    lines = ["| |ω| dt [rad] | turned in a second [rad] | lost, measured [rad] "
             "| lost, 2 atan(|ω| dt / 2) [rad] | exponential map loses [rad] |".replace(
                 "|ω|", "ω"), "|---:|---:|---:|---:|---:|"]
    for angle in (0.01, 0.03, 0.1, 0.3):
        omega = 60 * angle
        results = run("--scene", "torque-free", "--method", "listing_3,constant_omega",
                      "--set", "i1=1", "--set", "i2=1", "--set", "i3=1",
                      "--set", "omega1=0", "--set", "omega2=0",
                      "--set", f"omega3={omega!r}", "--duration", 1)
        lost = [metric(results, m, "attitude_error")
                for m in ("listing_3", "constant_omega")]
        formula = 60 * (angle - 2 * math.atan(angle / 2))
        lines.append(f"| {angle} | {omega:g} | {written(lost[0], '.3e')} "
                     f"| {written(formula, '.3e')} | {written(lost[1], '.0e')} |")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(run_table.main({"orders": orders, "normalise": normalise}))
