"""Markdown tables of results: a row for each method, or for each run.

    <!-- weave: table throw rows=methods columns="position_error:.2e:error,…" -->

A column is metric:format:heading; *1000 after the metric scales it; {unit} and {run}
may stand in a heading. With several runs and rows=methods every column comes once for
each.
"""
from __future__ import annotations

import re
from dataclasses import dataclass

from weave_runs import Run, WeaveError, look_up, written


@dataclass
class Column:
    path: str
    spec: str
    heading: str
    scale: float

    def cell(self, run: Run, method: str) -> str:
        value, _ = value_and_unit(run, self.path, method)
        if isinstance(value, str):
            return written(value, "")
        unscaled = value is None or self.scale == 1
        return written(value if unscaled else value * self.scale, self.spec)

    def title(self, run: Run, label: str, method: str) -> str:
        _, unit = value_and_unit(run, self.path, method)
        return self.heading.replace("{unit}", unit).replace("{run}", label)


def value_and_unit(run: Run, path: str, method: str) -> tuple[object, str]:
    """A metric or cost of one method, or any value of the results by its path."""
    parts = (run.results["metrics"], run.results["cost"])
    for part, key in ((p, k) for p in parts for k in (f"{method}/{path}", path)):
        if key in part:
            found = part[key]
            unit = found.get("unit", "") if isinstance(found, dict) else ""
            return look_up(found, ""), unit
    try:
        return look_up(run.results, path), ""
    except KeyError:
        raise WeaveError(f"the results of '{run.name}' hold no '{path}'") from None


def columns_of(text: str) -> list[Column]:
    columns = []
    for one in filter(None, (part.strip() for part in text.split(","))):
        path, _, rest = one.partition(":")
        spec, _, heading = rest.partition(":")
        path, _, scale = path.partition("*")
        heading = heading or path.replace("_", " ") + " [{unit}]"
        columns.append(Column(path, spec or ".3g", heading, float(scale or 1)))
    if not columns:
        raise WeaveError('a table needs columns="metric:format:heading,…"')
    return columns


def markdown(head: list[str], rows: list[list[str]]) -> str:
    def line(cells: list[str]) -> str:
        return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"

    rule = "|---|" + "---:|" * (len(head) - 1)
    return "\n".join([line(head), rule, *map(line, rows)])


def label_of(run: Run) -> str:
    """What a sweep's run is told apart by, else its name."""
    return re.sub(r"^.*@", "", run.name)


def table(runs: list[Run], options: dict[str, str]) -> str:
    columns = columns_of(options.get("columns", ""))
    labels = options.get("labels", "").split(",") if "labels" in options else \
        [label_of(run) for run in runs]
    if len(labels) != len(runs):
        raise WeaveError(f"{len(labels)} labels for {len(runs)} runs")
    first = runs[0]
    if options.get("rows", "methods") == "runs":
        method = first.methods[0]
        head = ["run", *(c.title(first, "", method) for c in columns)]
        rows = [[label, *(c.cell(run, run.methods[0]) for c in columns)]
                for run, label in zip(runs, labels)]
        return markdown(head, rows)
    if options.get("rows", "methods") != "methods":
        raise WeaveError("rows= is methods or runs")
    each = [(run, label, c) for c in columns for run, label in zip(runs, labels)]
    titles = (c.title(run, label, first.methods[0]) for run, label, c in each)
    head = ["method", *titles]
    rows = [[f"`{method}`", *(c.cell(run, method) for run, _, c in each)]
            for method in first.methods]
    return markdown(head, rows)
