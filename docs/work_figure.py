"""Work and precision: what an answer costs against how wrong it is, for the figures."""
from __future__ import annotations

import math


def front(points: list[tuple]) -> list[tuple]:
    """Of (cost, error) pairs those that no other beats in both."""
    best, kept = math.inf, []
    for cost, error in sorted(points):
        if error < best:
            best, kept = error, [*kept, (cost, error)]
    return kept


def draw_work(axes, points: dict[str, list[tuple]]) -> None:
    """A line for each method's points (cost, error, run), and the front of them all. Errors
    of 1 and more are marks on the upper edge."""
    kept = []
    for method, three in points.items():
        usable = [(c, e) for c, e, _ in three if 0 < e < 1]
        kept += usable
        failed = [(c, 1) for c, e, _ in three if not e < 1]
        look = three[0][2].look(method)
        axes.loglog(*zip(*usable) if usable else ([], []), label=method, markersize=4,
                    **look)
        axes.plot(*zip(*failed) if failed else ([], []), linestyle="none",
                  marker=look["marker"], color=look["color"], markersize=3, alpha=0.5)
    axes.plot(*zip(*front(kept)), color="0.5", linewidth=7, alpha=0.3, zorder=0,
              label="front")
    axes.set_ylim(1e-13, 2)
