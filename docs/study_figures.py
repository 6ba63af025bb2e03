"""The diagrams of `./timestep study`: for each problem, error against cost.

    python3 docs/study_figures.py out/study/study.csv out/study/figures

A point is a method at one setting. A method's line joins its best ones; the grey band
is the front of all. What failed, or is off the scale, is a cross at the upper edge.
"""
from __future__ import annotations

import argparse
import hashlib
import importlib.util
import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import study_data  # noqa: E402
from study_data import Record  # noqa: E402
from weave_runs import WeaveError  # noqa: E402

# The colours, markers and dashes of common/graphics/palette.cpp
COLORS = ("#0072b2", "#d55e00", "#008f6b", "#c76699", "#de9600", "#3da1db", "#614590",
          "#7a6921")
MARKERS = ("o", "s", "^", "D", "*", "h", "v", "P")
MOST_NAMED = 8  # methods in the legend: of the front, then those closest to it
MOST_IN_PANEL = 4  # of them, where panels are small
FLOOR = 1e-18  # no error at all is drawn here


def methods_of(records: list[Record]) -> list[str]:
    return list(dict.fromkeys(record.method for record in records))


def distance_to_front(method: str, records: list[Record]) -> float:
    """The least factor by which a method's answers cost more than the cheapest that err
    no more."""
    def factor(record: Record) -> float:
        good = [r.cost for r in study_data.front(records) if r.error <= record.error]
        return record.cost / min(good, default=record.cost)

    own = [r for r in study_data.answers(records) if r.method == method]
    return min(map(factor, own), default=math.inf)


def methods_of_front(records: list[Record]) -> list[str]:
    """First the one that has the most decades of error to itself."""
    kept = study_data.front(records)
    decades = dict.fromkeys(methods_of(kept), 0.0)
    for record, before in zip(kept[1:], kept):
        decades[record.method] += math.log10(before.error / max(record.error, FLOOR))
    return sorted(decades, key=lambda method: -decades[method])


def looks(records: list[Record]) -> dict[str, dict]:
    """Colour, marker and line of the methods that are named; peers are dashed."""
    on_front = methods_of_front(records)
    rest = [m for m in methods_of(records) if m not in on_front]
    rest.sort(key=lambda method: distance_to_front(method, records))
    peers = {record.method for record in records if record.peer}
    named = [*on_front, *rest][:MOST_NAMED]
    return {method: {"color": COLORS[i], "marker": MARKERS[i],
                     "linestyle": "--" if method in peers else "-"}
            for i, method in enumerate(named)}


def top_of(records: list[Record]) -> float:
    """The largest error that is shown: ten times that of three quarters of all."""
    errors = sorted(max(r.error, FLOOR) for r in study_data.answers(records))
    return 10 * errors[len(errors) * 3 // 4] if errors else 1.0


def draw_method(axes, own: list[Record], look: dict, top: float, label: str) -> None:
    """Its best settings on a line, the others pale; single precision is hollow."""
    shown = [r for r in study_data.answers(own) if r.error <= top]
    best = study_data.front(shown)
    points = {id(record) for record in best}
    marker, color = look["marker"], look["color"]
    axes.plot([r.cost for r in best], [max(r.error, FLOOR) for r in best], color=color,
              linestyle=look["linestyle"], label=label, marker=marker, markersize=0.1)
    for record in shown:
        hollow = record.precision == "single"
        axes.plot(record.cost, max(record.error, FLOOR), marker, color=color,
                  markerfacecolor="none" if hollow else color, markersize=5,
                  alpha=1 if id(record) in points else 0.25)


def draw_failures(axes, own: list[Record], records: list[Record], color: str,
                  top: float) -> None:
    lost = [r for r in own if r.failed or r.error > top]
    costs = [study_data.cost_or_guess(record, records) for record in lost]
    costs = [cost for cost in costs if cost > 0]
    axes.plot(costs, [top] * len(costs), "x", color=color, alpha=0.6, markersize=6,
              clip_on=False, in_layout=False)


def draw_front(axes, records: list[Record]) -> None:
    kept = study_data.front(records)
    axes.plot([r.cost for r in kept], [max(r.error, FLOOR) for r in kept],
              color="#808080", linewidth=7, alpha=0.3, zorder=0)


def draw_problem(axes, records: list[Record]) -> dict[str, dict]:
    """All of one problem's records. Returns how the named methods look."""
    from figure_style import GRID

    named, top = looks(records), top_of(records)
    grey = {"color": GRID, "marker": ".", "linestyle": "-"}
    axes.set_xscale("log")
    axes.set_yscale("log")
    for method in methods_of(records):
        own = [record for record in records if record.method == method]
        look = named.get(method, grey)
        draw_method(axes, own, look, top, method)
        draw_failures(axes, own, records, look["color"], top)
    draw_front(axes, records)
    axes.set_ylim(top=top)
    unit = next((f" [{r.cells['unit']}]" for r in records if r.cells.get("unit")), "")
    metric = records[0].cells.get("metric") or "error"
    axes.set_ylabel(metric.replace("_", " ") + unit)
    axes.set_xlabel("time of a frame [µs]" if is_timed(records)
                    else "evaluations a second of the scene")
    return named


def is_timed(records: list[Record]) -> bool:
    return any(math.isfinite(study_data.number(r.cells.get("us_per_frame")))
               for r in records)


def draw_legend(axes, named: dict[str, dict], has_others: bool, **place) -> None:
    """On axes: one entry a named method, then what the other marks mean."""
    from figure_style import SOFT, GRID

    before = len(axes.get_legend_handles_labels()[1])
    for method, look in named.items():
        axes.plot([], [], label=method, markersize=5, **look)
    if has_others:
        axes.plot([], [], color=GRID, label="other methods")
    axes.plot([], [], "o", color=SOFT, markerfacecolor="none", label="hollow: single")
    axes.plot([], [], "x", color=SOFT, label="failed, or off the scale")
    axes.plot([], [], color="#808080", linewidth=7, alpha=0.3, label="front")
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[before:], labels[before:], **place)


def work_precision(records: list[Record], title: str = ""):
    """The diagram of one problem."""
    from figure_style import new_figure

    figure, axes = new_figure(figsize=(8.6, 4.6))
    named = draw_problem(axes, records)
    axes.set_title(title or records[0].problem)
    draw_legend(axes, named, len(named) < len(methods_of(records)), loc="upper left",
                bbox_to_anchor=(1.01, 1.02))
    return figure


def overview(panels: dict[str, list[Record]], columns: int = 3):
    """Small diagrams side by side, by their titles, each with a few names."""
    from figure_style import new_figure

    rows = math.ceil(len(panels) / columns)
    figure, grid = new_figure(rows, columns, figsize=(3.9 * columns, 3.7 * rows),
                              squeeze=False)
    for axes, (title, records) in zip(grid.flat, panels.items()):
        named = draw_problem(axes, records)
        axes.set_title(title)
        shown = list(named)[:MOST_IN_PANEL]
        lines = [axes.plot([], [], markersize=4, **named[method])[0] for method in shown]
        axes.legend(lines, shown, loc="lower left", fontsize=7).set_in_layout(False)
    for axes in list(grid.flat)[len(panels):]:
        axes.set_axis_off()
    return figure


def draw_all(file: Path, folder: Path) -> list[Path]:
    """A figure for each problem that has answers."""
    import figure_style

    records = study_data.read(file)
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for problem in study_data.problems(records):
        own = study_data.of_problem(records, problem)
        if not study_data.answers(own):
            continue
        digest = hashlib.sha256(repr(own).encode()).hexdigest()
        path = folder / f"{problem}.svg"
        path.write_text(figure_style.svg(work_precision(own), digest), encoding="utf-8")
        written.append(path)
    return written


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("csv", type=Path, help="what the study found")
    parser.add_argument("folder", type=Path, help="where the figures go")
    options = parser.parse_args()
    if importlib.util.find_spec("matplotlib") is None:
        print("no figures: install matplotlib to have them (python3-matplotlib)")
        return 0
    try:
        written = draw_all(options.csv, options.folder)
    except WeaveError as error:
        print(f"study_figures: {error}", file=sys.stderr)
        return 2
    print(f"{len(written)} figures in {options.folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
