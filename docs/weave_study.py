"""What `./timestep study --publish` found last, as tables and in sentences.

    <!-- weave: study front orbit rows=6 -->
    <!-- weave: study ingredients -->
    <!-- weave: study guide chapters/07-trade/guide.json -->
    <!-- weave: studied orbit@1e-3 us_per_frame .2f over=orbit@1e-6 -->

Times are ratios: to the cheapest of the table, or over another key. A choice is one of
our own settings; other libraries are in the diagrams.
"""
from __future__ import annotations

import json
import math
from pathlib import Path

import study_data
from study_data import Record
from weave_marker import Place
from weave_runs import WeaveError, written
from weave_table import markdown

TABLES = ("front", "tried", "ingredients", "guide")
INGREDIENT = "ingredients/"


def step_text(dt: float) -> str:
    """1/60 where it is one over a whole number, else six digits."""
    over = 1 / dt if dt > 0 else math.nan
    whole = math.isfinite(over) and over > 1.5 and abs(over - round(over)) < 1e-9 * over
    return f"1/{round(over)}" if whole else written(dt, ".6g")


def settings_text(record: Record, names: list[str]) -> str:
    """Of those names."""
    each = (f"{name.replace('_', ' ')} {record.settings[name]:g}"
            for name in names if name in record.settings)
    return ", ".join(each) or "–"


def over_cheapest(cost: float, least: float) -> str:
    ratio = float(f"{cost / least:.3g}")  # three digits
    return written(ratio, ",.0f" if ratio >= 1000 else ".3g")


def thinned(rows: list, most: int) -> list:
    """At most so many, evenly chosen, the first and the last among them."""
    if len(rows) <= most:
        return rows
    if most < 2:
        raise WeaveError("rows= is a whole number, 2 or more")
    return [rows[round(i * (len(rows) - 1) / (most - 1))] for i in range(most)]


def error_heading(records: list[Record]) -> str:
    """With its unit, if it has one."""
    return next((f"error [{r.cells['unit']}]" for r in records if r.cells.get("unit")),
                "error")


def front(records: list[Record], most: int) -> str:
    kept = thinned(study_data.front(study_data.ours(records)), most)
    if not kept:
        raise WeaveError(f"nothing of '{records[0].problem}' has an answer with a cost")
    names = study_data.varied(records)
    head = ["method", "precision", "dt [s]", "settings", error_heading(kept), "time"]
    return markdown(head, [
        [f"`{r.method}`", r.precision, step_text(r.dt), settings_text(r, names),
         written(r.error, ".1e"), over_cheapest(r.cost, kept[0].cost)] for r in kept])


def tried(records: list[Record]) -> str:
    """A row a method: how many settings, how many failed, and its best."""
    answers = study_data.answers(records)
    least = min((r.cost for r in answers), default=math.nan)
    rows = []
    for method in dict.fromkeys(r.method for r in records):
        own = [r for r in records if r.method == method]
        failed = sum(bool(r.failed) for r in own)
        best = min((r for r in answers if r.method == method),
                   key=lambda r: (r.error, r.cost), default=None)
        rows.append([f"`{method}`", str(len(own)), str(failed),
                     *(["–", "–", "–"] if best is None else
                       [written(best.error, ".1e"), step_text(best.dt),
                        over_cheapest(best.cost, least)])])
    return markdown(["method", "settings", "failed",
                     f"least {error_heading(answers)}", "at dt [s]", "time"], rows)


def error_text(error: float, unit: str) -> str:
    return f"{written(error, '.2g' if 0.01 <= error < 1000 else '.1e')} {unit}"


def ingredients(root: Path) -> str:
    """A row an ingredient and scene."""
    head = ["ingredient", "scene", "needed?", "with / without", "error with",
            "error without", "cost [ns]", "of the step with it"]
    rows = []
    for row in study_data.ingredients(root)["rows"]:
        share = round(row["ns_more"] / row["ns_with"] * 100)
        rows.append([row["ingredient"], row["scene"], "yes" if row["matters"] else "no",
                     f"{row['with']} / {row['without']}",
                     error_text(row["error_with"], row["unit"]),
                     error_text(row["error_without"], row["unit"]),
                     written(float(f"{row['ns_more']:.2g}"), "+,.3g"),
                     f"{written(share, '+d')} %" if share else "0 %"])
    return markdown(head, rows)


def cheapest(records: list[Record], problem: str, most: float) -> Record | None:
    """Of our settings for the problem, the one that errs by no more."""
    own = study_data.ours(study_data.of_problem(records, problem))
    return next((r for r in study_data.front(own) if r.error <= most), None)


def guide(root: Path, file: str) -> str:
    """A row a kind of scene: the cheapest that is good enough, and the price of more."""
    head = ["scene", "good enough", "method", "precision", "dt [s]", "settings",
            "error", "ten times better costs"]
    rows, records = [], study_data.published(root)
    for wish in json.loads((root / file).read_text(encoding="utf-8")):
        problem, most = wish["problem"], wish["error"]
        found = cheapest(records, problem, most)
        if found is None:
            raise WeaveError(f"{file}: nothing of '{problem}' errs by {most:g} or less")
        better = cheapest(records, problem, most / 10)
        names = study_data.varied(study_data.of_problem(records, problem))
        rows.append([wish["scene"], wish["good enough"], f"`{found.method}`",
                     found.precision, step_text(found.dt), settings_text(found, names),
                     error_text(found.error, found.cells.get("unit", "")).strip(),
                     "–" if better is None else f"× {over_cheapest(better.cost, found.cost)}"])
    return markdown(head, rows)


def table(root: Path, place: Place) -> str:
    what = place.word(1, f"one of {', '.join(TABLES)}")
    if what not in TABLES:
        raise WeaveError(f"study has {', '.join(TABLES)}, not '{what}'")
    if what == "ingredients":
        return ingredients(root)
    if what == "guide":
        return guide(root, place.word(2, "a file"))
    problem = place.word(2, "a problem")
    records = study_data.of_problem(study_data.published(root), problem)
    rows = place.options.get("rows", "1000")
    if not rows.isdigit():
        raise WeaveError("rows= is a whole number, 2 or more")
    return front(records, int(rows)) if what == "front" else tried(records)


# --- in a sentence ----------------------------------------------------------------------

def ingredient_row(root: Path, key: str) -> dict:
    """ingredients/NAME, of the scene that requires it, or ingredients/NAME/not."""
    name, _, which = key.removeprefix(INGREDIENT).partition("/")
    for row in study_data.ingredients(root)["rows"]:
        if row["ingredient"] == name and row["matters"] == (which != "not"):
            return row
    raise WeaveError(f"{study_data.INGREDIENTS} has no ingredient '{name}'")


def record_at(root: Path, key: str) -> Record:
    """A record by its key, or PROBLEM@ERROR: the cheapest that errs no more."""
    records = study_data.published(root)
    problem, at, error = key.partition("@")
    if not at:
        found = next((r for r in records if r.key == key), None)
        if found is None:
            raise WeaveError(f"{study_data.PUBLISHED} has no '{key}'")
        return found
    found = cheapest(records, problem, study_data.number(error))
    if found is None:
        raise WeaveError(f"nothing of '{problem}' errs by {error} or less")
    return found


def value_at(root: Path, key: str, name: str) -> object:
    """A field as a number where it is one, else as text."""
    if key.startswith(INGREDIENT):
        row = ingredient_row(root, key)
        if name not in row:
            raise WeaveError(f"an ingredient has no '{name}'")
        return row[name]
    record = record_at(root, key)
    if name in record.settings:
        return record.settings[name]
    if name == "dt":
        return step_text(record.dt)
    if name == "settings":
        alike = study_data.of_problem(study_data.published(root), record.problem)
        return settings_text(record, study_data.varied(alike))
    if name == "method":
        return f"`{record.method}`"
    if name not in record.cells:
        raise WeaveError(f"{study_data.PUBLISHED} has no column '{name}'")
    text = record.cells[name]
    try:
        return float(text)
    except ValueError:
        return text


def number(root: Path, place: Place) -> str:
    """A field of a record; over=KEY divides by the same of another. Or machine."""
    key = place.word(1, "a key")
    if key == "machine":
        return study_data.ingredients(root)["machine"]
    name = place.word(2, "a field")
    value = value_at(root, key, name)
    if isinstance(value, str):
        return value
    if "over" in place.options:
        value /= value_at(root, place.options["over"], name)
    return written(value * (place.scale or 1), place.format(".3g"))
