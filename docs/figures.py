"""Brings a chapter's figures up to date: chapters/NN-name/figures/NAME.svg.

What a figure shows is drawn by the function of its name (dashes become underscores) in
the chapter's figures.py, from the runs that runs.json declares for it:

    def energy(runs: dict[str, Run]) -> Figure: …

In place of a run it may name what bench/results.json has of a kind, "bench:contacts/": the
medians by their whole names; or what study/results.csv has of a problem, "study:orbit".

A figure carries the digest of its runs and of that function, so that whether it is
fresh can be told without matplotlib.
"""
from __future__ import annotations

import ast
import hashlib
import importlib.util
import json
import sys
from pathlib import Path

import study_data
import weave_bench
from weave_runs import Chapter, WeaveError

sys.dont_write_bytecode = True

BENCH, STUDY = "bench:", "study:"


def source_of(file: Path, function: str) -> str:
    """The text of the function that draws a figure."""
    if not file.is_file():
        raise WeaveError(f"there is no {file.parent.name}/figures.py")
    text = file.read_text(encoding="utf-8")
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef) and node.name == function:
            return ast.get_source_segment(text, node)
    raise WeaveError(f"{file.parent.name}/figures.py has no function {function}")


def runs_of(chapter: Chapter, name: str) -> list[str]:
    if name not in chapter.figures:
        raise WeaveError(f"runs.json of {chapter.name} declares no figure '{name}'")
    return [run for one in chapter.figures[name] for run in
            ([one] if one.startswith((BENCH, STUDY)) else chapter.expand(one))]


def measured(chapter: Chapter, name: str) -> dict:
    """What the benchmarks measured under names that begin so."""
    start = name.removeprefix(BENCH)
    medians = weave_bench.results(chapter.folder.parent.parent)["medians"]
    found = {key: values for key, values in medians.items() if key.startswith(start)}
    if not found:
        raise WeaveError(f"bench/results.json has nothing of '{start}'")
    return found


def studied(chapter: Chapter, name: str) -> list[study_data.Record]:
    """What the study found of a problem."""
    records = study_data.published(chapter.folder.parent.parent)
    return study_data.of_problem(records, name.removeprefix(STUDY))


def data_of(chapter: Chapter, run: str):
    """What a figure's function gets under the name of a run, and a text that changes
    when it does."""
    if run.startswith(BENCH):
        medians = measured(chapter, run)
        return medians, json.dumps(medians)
    if run.startswith(STUDY):
        records = studied(chapter, run)
        return records, repr(records)
    return chapter.run(run), chapter.run(run).digest


def digest_of(chapter: Chapter, name: str, function: str) -> str:
    digest = hashlib.sha256(source_of(chapter.folder / "figures.py", function).encode())
    for run in runs_of(chapter, name):
        digest.update(f"{run} {data_of(chapter, run)[1]}".encode())
    return digest.hexdigest()


def is_fresh(svg: Path, digest: str) -> bool:
    mark = f"<!-- data: {digest} -->"
    return svg.is_file() and mark in svg.read_text(encoding="utf-8")


def draw(chapter: Chapter, name: str, function: str, digest: str) -> None:
    import figure_style

    file = chapter.folder / "figures.py"
    spec = importlib.util.spec_from_file_location("chapter_figures", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    runs = {run: data_of(chapter, run)[0] for run in runs_of(chapter, name)}
    figure = getattr(module, function)(runs)
    path = chapter.folder / "figures" / f"{name}.svg"
    path.parent.mkdir(exist_ok=True)
    path.write_text(figure_style.svg(figure, digest), encoding="utf-8")


def bring_up_to_date(chapter: Chapter, name: str, only_check: bool) -> str:
    """Draws a figure whose data have changed. Returns what is to be said of it."""
    function = name.replace("-", "_")
    digest = digest_of(chapter, name, function)
    if is_fresh(chapter.folder / "figures" / f"{name}.svg", digest):
        return ""
    if only_check:
        return "stale: its data have changed since it was drawn"
    if importlib.util.find_spec("matplotlib") is None:
        return "matplotlib is missing: figures are left as they are"
    draw(chapter, name, function, digest)
    return f"drew {chapter.name}/figures/{name}.svg"
