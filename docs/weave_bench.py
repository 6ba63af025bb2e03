"""What `./timestep bench --publish` measured last, as tables and in sentences.

    <!-- weave: bench particles -->
    <!-- weave: measured kepler/rk4/alone ns .2f over=kepler/rk4/GSL -->

bench/bench_table.py has the form of bench/results.json, which both are made of.
"""
from __future__ import annotations

import json
import sys
from pathlib import Path

from weave_marker import Place
from weave_runs import ROOT, WeaveError, written

sys.path.append(str(ROOT / "bench"))
import bench_table  # noqa: E402


def results(root: Path) -> dict:
    file = root / "bench/results.json"
    if not file.is_file():
        raise WeaveError(f"there is no bench/{file.name} (./timestep bench --publish)")
    return json.loads(file.read_text(encoding="utf-8"))


def table(root: Path, place: Place) -> str:
    parts = ", ".join(bench_table.PARTS)
    part = place.word(1, f"one of {parts}")
    if part not in bench_table.PARTS:
        raise WeaveError(f"bench has {parts}, not '{part}'")
    rows = bench_table.Tables(results(root)).rows(part)
    if not rows:
        raise WeaveError(f"bench/results.json has nothing of '{part}'")
    return bench_table.markdown(rows)


def number(root: Path, place: Place) -> str:
    """A median, over=NAME as a multiple of another; or machine, compiler, a library."""
    measured = results(root)
    name = place.word(1, "a name")
    if isinstance(measured.get(name), str):
        return measured[name]

    key = place.word(2, "what of it: ns, million_per_second, …")
    tables = bench_table.Tables(measured)
    if "over" in place.options:
        value = tables.ratio(name, place.options["over"], key)
    else:
        value = tables.value(name, key)
    if value is None:
        raise WeaveError(f"bench/results.json has no {key} of '{name}'")
    return written(value * (place.scale or 1), place.format(".3g"))
