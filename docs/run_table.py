"""What the tables.py of the chapters share: they run their chapter's program, and print
one of their tables as Markdown.
"""
from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Callable

PROGRAMS = Path(__file__).resolve().parent.parent / "build/release/bin"


def run(chapter: str, *arguments: object) -> dict:
    """The results of a headless run of a chapter's program; ends with its words if it fails."""
    done = subprocess.run([PROGRAMS / chapter, "--headless", "--results", "-",
                           *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"tables: {done.stderr.strip()}")
    return json.loads(done.stdout)


def metric(results: dict, method: str, name: str) -> float:
    """Of a run of several methods."""
    return float(results["metrics"][f"{method}/{name}"]["value"])


def main(tables: dict[str, Callable[[], str]]) -> int:
    """Prints the table that the command line names; the exit code."""
    if len(sys.argv) != 2 or sys.argv[1] not in tables:
        print(f"tables: name one of {', '.join(tables)}", file=sys.stderr)
        return 2
    print(tables[sys.argv[1]]())
    return 0
