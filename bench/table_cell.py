"""Cells of the benchmarks' tables: how a measured number is written."""
from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "docs"))
from weave_runs import written  # noqa: E402

PRECISIONS = ("single", "double")


def rounded(value: float) -> float:
    return float(f"{value:.4g}")


@dataclass(frozen=True)
class Cell:
    """One number, or one for each precision. What was not measured is None."""

    values: tuple[float | str | None, ...]
    spec: str
    parts: tuple[str, str] = PRECISIONS  # what two values are

    def __str__(self) -> str:
        texts = [f"`{value}`" if isinstance(value, str) else written(value, self.spec)
                 for value in self.values]
        return "–" if set(texts) == {"–"} else " / ".join(texts)


class Words(Cell):
    """Text that is no name."""

    def __str__(self) -> str:
        texts = [value or "–" for value in self.values]
        return "–" if set(texts) == {"–"} else " / ".join(texts)


class Answer(Cell):
    """Nanoseconds, and in brackets how many of a thousand are wrong, if any."""

    def __str__(self) -> str:
        ns, wrong = self.values
        if ns is None:
            return "–"
        return written(ns, self.spec) + (f" ({wrong:.0f})" if wrong else "")


class Error(Cell):
    """An error and, in brackets, the seconds that it took to get there."""

    def __str__(self) -> str:
        error, seconds = self.values
        if seconds is None:
            return "–"
        return f"{'fails' if error is None else written(error, self.spec)} ({seconds:.2g})"
