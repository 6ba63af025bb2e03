"""Tables of chapter 6's scenes, by names as world-times and world-peers have them:

    {"stacks/pyramid/substeps/double": {"ns": …, "worst_depth": …, "drift": …,
                                        "energy_change": …, "stands": 1},
     "accuracy/substeps/double": {"ball_energy": …, "stop_error": …,
                                  "gas_energy_1_ms": …, "gas_energy_60_Hz": …},
     "simbench/rolling/substeps/double/10": {"error": …, "seconds": …}}

Shares are shares, lengths in m. An error of null is one of a run that failed.
"""
from __future__ import annotations

from table_cell import PRECISIONS, Cell, Error, Words

PARTS = ("stacks", "accuracy", "simbench")
STACKS = ("column", "pyramid", "pile")
# Who moves the scenes, in the order of the tables, and how the tables call them
MOVED_BY = {"worst_first": "`worst_first`",
            "sequential_impulses": "`sequential_impulses`",
            "substeps": "`substeps`", "lcp": "`lcp`",
            "Bullet": "Bullet", "Bullet_no_erp": "Bullet, ERP off",
            "ODE": "ODE", "ODE_no_erp": "ODE, ERP off", "ODE_world": "ODE, WorldStep"}
# Times over Bullet's (in single), measured once on another machine: Box3D and Jolt, each
# by its defaults, on a column, a pyramid and a pile of the same sizes
OVER_BULLET = {"Box3D": {"column": 0.0156 / 0.0190, "pyramid": 0.388 / 0.809,
                         "pile": 2.26 / 5.51},
               "Jolt": {"column": 0.0133 / 0.0190, "pyramid": 0.494 / 0.809,
                        "pile": 3.50 / 5.51}}
# SimBenchmark's scenes and what is varied in each; of that what takes too long
SIMBENCH = {"rolling": "iterations", "rolling_diagonal": "iterations",
            "bouncing": "dt [s]", "666": "dt [s]", "elastic_666": "dt [s]"}
LEFT_OUT = {"rolling": ["1000", "10000"], "rolling_diagonal": ["1000", "10000"],
            "bouncing": ["1e-05"], "666": ["0.0001"], "elastic_666": ["0.0001"]}


def value(medians: dict, name: str, key: str) -> float | None:
    return medians.get(name, {}).get(key)


def pair(medians: dict, name: str, key: str, spec: str, unit: float = 1) -> Cell:
    """In single and in double."""
    values = [value(medians, f"{name}/{p}", key) for p in PRECISIONS]
    return Cell(tuple(None if v is None else v * unit for v in values), spec)


def stack(medians: dict, scene: str, method: str) -> dict[str, Cell]:
    """What a step of a stack takes, and what becomes of the stack."""
    name, bullet = f"stacks/{scene}/{method}", f"stacks/{scene}/Bullet"

    def over(other: list[str], share: float = 1) -> Cell:
        own = [value(medians, f"{name}/{p}", "ns") for p in PRECISIONS]
        others = [value(medians, each, "ns") for each in other]
        return Cell(tuple(a / (b * share) if a and b else None
                          for a, b in zip(own, others)), ".2f")

    stands = [value(medians, f"{name}/{p}", "stands") for p in PRECISIONS]
    yes_or_no = tuple(None if s is None else "yes" if s else "no" for s in stands)
    return {"ms a step": pair(medians, name, "ns", ".3g", 1e-6),
            "time / Bullet's": over([f"{bullet}/{p}" for p in PRECISIONS]),
            **{f"time / {peer}'s": over([f"{bullet}/single"] * 2, shares[scene])
               for peer, shares in OVER_BULLET.items()},
            "worst penetration [mm]": pair(medians, name, "worst_depth", ".3g", 1e3),
            "drift [mm]": pair(medians, name, "drift", ".4g", 1e3),
            "energy [%]": pair(medians, name, "energy_change", "+.2g", 100),
            "stands at 60 s": Words(yes_or_no, "")}


def stacks(medians: dict) -> list[dict[str, Cell]]:
    return [{"scene": Cell((scene,), ""), "moved by": Words((label,), "")}
            | stack(medians, scene, method)
            for scene in STACKS for method, label in MOVED_BY.items()
            if any(f"stacks/{scene}/{method}/{p}" in medians for p in PRECISIONS)]


def accuracy(medians: dict) -> list[dict[str, Cell]]:
    """How far off scenes with an exact answer end."""
    columns = {"bouncing ball, energy [%]": "ball_energy",
               "sliding block, stop [%]": "stop_error",
               "elastic gas at 1 ms, energy [%]": "gas_energy_1_ms",
               "elastic gas at 1/60 s, energy [%]": "gas_energy_60_Hz"}
    return [{"moved by": Words((label,), "")}
            | {title: pair(medians, f"accuracy/{method}", key, "+.2g", 100)
               for title, key in columns.items()}
            for method, label in MOVED_BY.items()
            if any(f"accuracy/{method}/{p}" in medians for p in PRECISIONS)]


def simbench(medians: dict) -> list[dict[str, Cell]]:
    """SimBenchmark's errors, all in double, and the seconds that they took."""
    names = [name.split("/") for name in medians if name.startswith("simbench/")]
    shown = [m for m in MOVED_BY if any(n[2] == m for n in names)]
    rows = []
    for scene, varied in SIMBENCH.items():
        values = {n[4] for n in names if n[1] == scene}
        if not values:
            continue
        for each in sorted(values | set(LEFT_OUT[scene]), key=float):
            row = {"scene": Cell((scene,), ""), "varied": Words((varied,), ""),
                   "is": Words((each + (", left out" if each not in values else ""),), "")}
            for method in shown:
                found = medians.get(f"simbench/{scene}/{method}/double/{each}", {})
                row[MOVED_BY[method]] = Error((found.get("error"), found.get("seconds")),
                                              ".2g", ("error", "seconds"))
            rows.append(row)
    return rows


def rows(medians: dict, part: str) -> list[dict[str, Cell]]:
    return {"stacks": stacks, "accuracy": accuracy, "simbench": simbench}[part](medians)
