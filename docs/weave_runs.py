"""The runs that a chapter's text and figures quote, declared in its runs.json.

    {"runs": {"throw": ["--scene", "projectile", "--method", "all"],
              "steps": {"args": ["--scene", "spring"], "sweep": {"--dt": [0.1, 0.05]}}},
     "commands": {"extremes": ["bin/extremes", "--markdown"]},
     "figures": {"order": ["steps"]}}

A command is an executable of the build, or python3 with a script of the repository.
A sweep declares one run for each value: steps@0.1, steps@0.05. What a run printed is
kept under build/weave, by the digest of the executable and its arguments.
"""
from __future__ import annotations

import csv
import hashlib
import json
import math
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LINES = {"solid": "-", "dashed": "--", "dotted": ":"}
MARKERS = {"circle": "o", "square": "s", "triangle": "^", "diamond": "D", "cross": "x",
           "plus": "P", "star": "*", "ring": "h"}


class WeaveError(Exception):
    """What is wrong with a marker or a declaration, in one line."""


@dataclass
class Run:
    """What one run of a chapter's executable wrote."""

    name: str
    results: dict
    folder: Path
    listing: dict  # of --list --json

    @property
    def methods(self) -> list[str]:
        used = self.results["method"]
        return used if isinstance(used, list) else used.split(",")

    def metric(self, name: str, method: str = "") -> float:
        metrics = self.results["metrics"]
        key = f"{method}/{name}" if f"{method}/{name}" in metrics else name
        return float(look_up(metrics, key))

    def look(self, method: str) -> dict:
        """Matplotlib's colour, marker and line style of a method."""
        scenes = {scene["name"]: scene for scene in self.listing["scenes"]}
        scene = scenes[self.results["scene"]]
        style = next(m for m in scene["methods"] if m["name"] == method)
        return {"color": style["color"], "marker": MARKERS[style["marker"]],
                "linestyle": LINES[style["dash"]]}

    @cached_property
    def history(self) -> dict[str, list]:
        return columns_of(self.folder / "history.csv")

    @cached_property
    def trajectory(self) -> dict[str, list]:
        return columns_of(self.folder / "trajectory.csv")

    @property
    def digest(self) -> str:
        """Of all that repeats bit for bit: everything but the cost."""
        lasting = {k: v for k, v in self.results.items() if k != "cost"}
        return hashlib.sha256(json.dumps(lasting, sort_keys=True).encode()).hexdigest()


def columns_of(path: Path) -> dict[str, list]:
    """A CSV file's columns by name; numbers where they are numbers."""
    def number(text: str) -> float | str:
        try:
            return float(text)
        except ValueError:
            return text

    if not path.is_file():
        raise WeaveError(f"the run wrote no {path.name}")
    with path.open(newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    return {name: [number(row[i]) for row in rows] for i, name in enumerate(head)}


def look_up(node: object, path: str) -> object:
    """The value at a path such as metrics.drift: names joined by dots or slashes, which
    the names may contain as well. An object with a "value" stands for that value."""
    if not path:
        return node["value"] if isinstance(node, dict) and "value" in node else node
    if isinstance(node, list):
        node = {str(i): item for i, item in enumerate(node)}
    if isinstance(node, dict):
        for key in sorted(node, key=len, reverse=True):
            if path == key or path.startswith((key + ".", key + "/")):
                try:
                    return look_up(node[key], path[len(key) + 1:])
                except KeyError:
                    continue
    raise KeyError(path)


@cache
def file_digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def execute(command: list[str], what: str) -> str:
    run = subprocess.run(command, capture_output=True, text=True, cwd=ROOT,
                         stdin=subprocess.DEVNULL)
    if run.returncode != 0:
        said = (run.stderr.strip() or "nothing said").splitlines()[-1]
        raise WeaveError(f"{what} failed with exit code {run.returncode}: {said}")
    return run.stdout


class Chapter:
    """A chapter's declared runs, commands and figures."""

    def __init__(self, folder: Path, build: Path, store: Path) -> None:
        self.name, self.folder = folder.name, folder
        self.build, self.store = build, store
        file = folder / "runs.json"
        declared = json.loads(file.read_text()) if file.is_file() else {}
        self.commands: dict = declared.get("commands", {})
        self.figures: dict = declared.get("figures", {})
        self.sweeps: dict[str, list[str]] = {}
        self.runs: dict[str, list[str]] = {}
        for name, run in declared.get("runs", {}).items():
            self._declare(name, run)
        self._loaded: dict[str, Run] = {}

    def _declare(self, name: str, run: list | dict) -> None:
        if isinstance(run, list):
            self.runs[name] = [str(word) for word in run]
            return
        (option, values), = run["sweep"].items()
        self.sweeps[name] = [f"{name}@{value}" for value in values]
        for value in values:
            self.runs[f"{name}@{value}"] = [*map(str, run["args"]), option, str(value)]

    def expand(self, name: str) -> list[str]:
        """The run of that name, or all runs of the sweep of that name."""
        if name not in self.runs and name not in self.sweeps:
            raise WeaveError(f"runs.json of {self.name} declares no run '{name}'")
        return self.sweeps.get(name, [name])

    def program(self, relative: str = "") -> Path:
        path = self.build / (relative or f"bin/{self.name}")
        if not path.is_file():
            raise WeaveError(f"{path} is not built (./timestep test builds it)")
        return path

    @cached_property
    def listing(self) -> dict:
        return json.loads(execute([str(self.program()), "--list", "--json"], self.name))

    def run(self, name: str) -> Run:
        if name not in self._loaded:
            self._loaded[name] = self.run_with(name, self.runs[self.expand(name)[0]])
        return self._loaded[name]

    def run_with(self, name: str, arguments: list[str], fresh: bool = False) -> Run:
        """Runs the executable, or takes what the same run has written before."""
        program = self.program()
        key = hashlib.sha256(json.dumps([file_digest(program), arguments]).encode())
        folder = self.store / key.hexdigest()[:24]
        if fresh or not (folder / "results.json").is_file():
            self._compute(program, name, arguments, folder)
        results = json.loads((folder / "results.json").read_text())
        return Run(name, results, folder, self.listing)

    def _compute(self, program: Path, name: str, arguments: list[str],
                 folder: Path) -> None:
        self.store.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self.store) as scratch:
            printed = execute([str(program), *arguments, "--headless", "--results", "-",
                               "--out", scratch], f"run '{name}'")
            (Path(scratch) / "results.json").write_text(printed)
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(scratch, folder)

    def output(self, name: str) -> str:
        """What a declared command prints."""
        if name not in self.commands:
            raise WeaveError(f"runs.json of {self.name} declares no command '{name}'")
        first, *arguments = map(str, self.commands[name])
        files = [self.program(), *sorted(self.folder.glob("*.json"))]
        if first == "python3":
            files.append(self.folder.parent.parent / arguments.pop(0))
            command = [sys.executable, str(files[-1]), *arguments]
        else:
            files.append(self.program(first))
            command = [str(files[-1]), *arguments]
        key = hashlib.sha256(json.dumps([*map(file_digest, files), arguments]).encode())
        kept = self.store / f"{key.hexdigest()[:24]}.txt"
        if not kept.is_file():
            printed = execute(command, f"command '{name}'")
            self.store.mkdir(parents=True, exist_ok=True)
            kept.write_text(printed, encoding="utf-8")
        return kept.read_text(encoding="utf-8").strip("\n")


def machine() -> str:
    """The processor that timings were taken on."""
    info = Path("/proc/cpuinfo")
    text = info.read_text() if info.is_file() else ""
    names = re.findall(r"model name\s*: (.*)", text)
    name = names[0] if names else platform.processor() or platform.machine()
    return f"{name}, {os.cpu_count()} threads, {platform.system()}"


NOT_FINITE = {"nan": math.nan, "inf": math.inf, "-inf": -math.inf}
SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def written(value: object, spec: str) -> str:
    """A number as a reader writes it: 1.2 × 10⁻⁵, − for a minus, – for no answer."""
    value = NOT_FINITE.get(value, value) if isinstance(value, str) else value
    if value is None or isinstance(value, float) and math.isnan(value):
        return "–"
    if isinstance(value, float) and math.isinf(value):
        return "∞" if value > 0 else "−∞"
    try:
        text = format(value, spec)
    except (TypeError, ValueError):
        raise WeaveError(f"cannot write {value!r} with the format '{spec}'") from None
    mantissa, e, exponent = text.partition("e")
    if e and exponent.lstrip("+-").isdigit():
        power = f" × 10{str(int(exponent)).translate(SUPERSCRIPT)}"
        text = mantissa + (power if int(exponent) else "")
    return "−" + text[1:] if text.startswith("-") else text
