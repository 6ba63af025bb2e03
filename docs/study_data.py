"""What `./timestep study` found, one record a setting: study.csv, as it is read here.

Costs are microseconds a frame of the scene; where no time was taken, force evaluations
or contact solves a second of it.
"""
from __future__ import annotations

import csv
import json
import math
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from weave_runs import ROOT, WeaveError

PUBLISHED = "study/results.csv"
INGREDIENTS = "study/ingredients.json"
MACHINE = "study/machine.json"
NEEDED = ("key", "problem", "method", "precision", "dt", "error")


@dataclass
class Record:
    """One method at one setting; `cells` is the row of the file as it is."""

    key: str
    problem: str
    method: str
    precision: str
    dt: float
    settings: dict[str, float]
    error: float  # [unit]; NaN if it failed
    cost: float  # NaN if it is not known
    peer: bool
    cells: dict[str, str] = field(repr=False, default_factory=dict)

    @property
    def failed(self) -> str:
        """Why there is no answer; empty if there is one."""
        lost = "" if math.isfinite(self.error) else "not finite"
        return self.cells.get("failed", "") or lost


def number(text: str | None) -> float:
    try:
        return float(text or "nan")
    except ValueError:
        raise WeaveError(f"'{text}' in the study's results is no number") from None


def settings_of(text: str) -> dict[str, float]:
    """iterations=10 substeps=4, by name."""
    pairs = (one.partition("=") for one in text.split())
    return {name: number(value) for name, _, value in pairs}


def evaluations_per_second(cells: dict[str, str]) -> float:
    """Of the scene's time."""
    seconds = number(cells.get("steps")) * number(cells.get("dt"))
    return number(cells.get("evaluations")) / seconds if seconds > 0 else math.nan


def record_of(cells: dict[str, str], cost: float) -> Record:
    return Record(key=cells["key"], problem=cells["problem"], method=cells["method"],
                  precision=cells["precision"], dt=number(cells["dt"]),
                  settings=settings_of(cells.get("settings") or ""),
                  error=abs(number(cells["error"])), cost=cost,
                  peer=cells.get("peer") in ("true", "1", "True"), cells=cells)


def read(file: Path) -> list[Record]:
    """In the order of the file."""
    if not file.is_file():
        raise WeaveError(f"there is no {file} (./timestep study --publish)")
    with file.open(newline="", encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    lacking = [name for name in NEEDED if rows and name not in rows[0]]
    if lacking:
        raise WeaveError(f"{file} has no column {lacking[0]}")
    timed = {row["problem"] for row in rows
             if math.isfinite(number(row.get("us_per_frame")))}
    return [record_of(row, number(row.get("us_per_frame")) if row["problem"] in timed
                      else evaluations_per_second(row)) for row in rows]


@cache
def read_once(file: Path, _changed: int) -> list[Record]:
    return read(file)


def published(root: Path = ROOT) -> list[Record]:
    """Read again only if the file has changed: a text asks many times."""
    file = root / PUBLISHED
    return read_once(file, file.stat().st_mtime_ns if file.is_file() else 0)


def problems(records: list[Record]) -> list[str]:
    return list(dict.fromkeys(record.problem for record in records))


def of_problem(records: list[Record], problem: str) -> list[Record]:
    found = [record for record in records if record.problem == problem]
    if not found:
        names = ", ".join(problems(records))
        raise WeaveError(f"the study has no problem '{problem}'; it has {names}")
    return found


def varied(records: list[Record]) -> list[str]:
    """The settings that are not the same for all that have them."""
    names = dict.fromkeys(name for record in records for name in record.settings)
    return [name for name in names
            if len({r.settings[name] for r in records if name in r.settings}) > 1]


def answers(records: list[Record]) -> list[Record]:
    """Those that did not fail and whose cost is known."""
    return [r for r in records if not r.failed and r.cost > 0]


def front(records: list[Record]) -> list[Record]:
    """Those that no other beats in both cost and error, the cheapest first."""
    best, kept = math.inf, []
    for record in sorted(answers(records), key=lambda r: (r.cost, r.error)):
        if record.error < best:
            best, kept = record.error, [*kept, record]
    return kept


def ours(records: list[Record]) -> list[Record]:
    """What can be chosen here: without the libraries beside us."""
    return [record for record in records if not record.peer]


def cost_or_guess(record: Record, records: list[Record]) -> float:
    """The cost; of what failed, by the steps of its method's nearest answer in dt."""
    if record.cost > 0:
        return record.cost
    alike = [r for r in answers(records) if r.method == record.method]
    same = [r for r in alike if r.settings == record.settings
            and r.precision == record.precision] or alike
    if not same:
        return math.nan
    nearest = min(same, key=lambda r: abs(math.log(r.dt / record.dt)))
    return nearest.cost * nearest.dt / record.dt


def ingredients(root: Path = ROOT) -> dict:
    file = root / INGREDIENTS
    if not file.is_file():
        raise WeaveError(f"there is no {INGREDIENTS} (./timestep study --publish)")
    return json.loads(file.read_text(encoding="utf-8"))
