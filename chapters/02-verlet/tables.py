"""The tables of chapter 2 that need more than one run: prints one of them as Markdown.

    python3 chapters/02-verlet/tables.py orders|evaluations
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

run = partial(run_table.run, "02-verlet")
TURN = 2 * math.pi


def orders() -> str:
    """Slopes of the pendulum's error against the step, and of what is kept as its rate."""
    steps = (3 / 64, 3 / 128, 3 / 256)
    runs = [run("--scene", "pendulum", "--method", "all", "--set", "gravity=1", "--set",
                "theta=1", "--set", "omega=0.5", "--duration", 3, "--dt", repr(step))
            for step in steps]
    methods = [m for m in runs[0]["method"].split(",") if m != "dormand_prince"]
    lines = ["| method | error at dt = 3/64 s [rad] | order from 3/64 to 3/128 "
             "| from 3/128 to 3/256 | order of the velocity it keeps |",
             "|---|---:|---:|---:|---:|"]
    for method in methods:
        errors = [metric(r, method, "state_error") for r in runs]
        kept = [metric(r, method, "kept_rate_error") for r in runs]
        slopes = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
        lines.append(f"| `{method}` | {written(errors[0], '.2e')} | {slopes[0]:.2f} | {slopes[1]:.2f} "
                     f"| {math.log2(kept[1] / kept[2]):.1f} |")
    return "\n".join(lines)


WANTED = (0.1, 0.01, 0.001)
MOST = 20_000  # steps an orbit


def evaluations() -> str:
    """Evaluations per orbit until the planet's error after ten orbits stays below."""
    methods = ("explicit_euler", "semi_implicit_euler", "modified_euler", "midpoint",
               "velocity_verlet", "position_verlet", "rk4", "yoshida4_kdk",
               "yoshida4_dkd", "dopri5")
    ladder = [round(25 * math.sqrt(2) ** k) for k in range(20)]
    found: dict[str, list] = {method: [None] * len(WANTED) for method in methods}
    for steps in (n for n in ladder if n <= MOST):
        open_methods = [m for m in methods if None in found[m]]
        results = run("--scene", "orbit", "--method", ",".join(open_methods),
                      "--dt", repr(TURN / steps), "--duration", repr(10 * TURN))
        alone = len(open_methods) == 1
        for method in open_methods:
            error = float(results["metrics"][
                "position_error_max" if alone else f"{method}/position_error_max"]["value"])
            cost = results["cost"][
                "force_evaluations" if alone else f"{method}/force_evaluations"]
            for i, limit in enumerate(WANTED):
                if error < limit and found[method][i] is None:
                    found[method][i] = cost / 10
    lines = ["| method | below " + " | below ".join(f"{w:g} a" for w in WANTED) + " |",
             "|---|" + "---:|" * len(WANTED)]
    for method in methods:
        cells = (f"{n:,.0f}" if n else f"more than {MOST:,}" for n in found[method])
        lines.append(f"| `{method}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(run_table.main({"orders": orders, "evaluations": evaluations}))
