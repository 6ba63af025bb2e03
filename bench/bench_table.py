"""What the benchmarks measured: as numbers by name, and as tables of ratios.

results() takes the medians out of what Google Benchmark wrote:

    {"machine": …, "compiler": …, "Odeint": …, "GSL": …, "Bullet": …, "ODE": …,
     "FCL": …,
     "medians": {"particles/rk4/swarm/double/4096": {"ns": …, "million_per_second": …},
                 "bandwidth/triad/double/1000000/2": {"GB_per_second": …},
                 "kepler/rk4/alone": {"ns": …, "energy_error": …},
                 "rotation/momentum/single/1000": {"million_per_second": …, "ns": …},
                 "top/momentum/single": {"attitude_error_1_s": …, "energy_change": …,
                                         "flips": …, "flips_energy_change": …},
                 "contacts/hull32/depth/gjk_epa/double": {"ns": …, "wrong": …,
                                                          "error": …, "worst_error": …},
                 "growth/depth/sat/64": {"ns": …, "edge_pairs": …},
                 "pairs/geometry_public/Bullet": {"asked": …, "off_6": …, "off_9": …,
                         "wrong_side": …, "no_answer": …, "no_end": …}}}

The last, which counts answers to the pairs of a truth file, is pair-peers' own: no time.
world_table.py has the names of chapter 6's scenes.

bench/results.json is such a file: what `./timestep bench --publish` measured last. The
text quotes it.
"""
from __future__ import annotations

import csv
import io
import math
from collections import defaultdict
from pathlib import Path
from statistics import median

import world_table
from table_cell import PRECISIONS, Answer, Cell, rounded

PUBLISHED = Path(__file__).resolve().parent / "results.json"
UNITS = {"items_per_second": ("million_per_second", 1e-6),
         "bytes_per_second": ("GB_per_second", 1e-9),
         **{key: (key, 1) for key in (
             "energy_error", "kept", "attitude_error_1_s", "attitude_error_10_s",
             "attitude_error_100_s", "energy_change", "flips", "flips_energy_change",
             "wrong", "error", "worst_error", "edge_pairs")}}
LIBRARIES = ("Odeint", "GSL", "Bullet", "ODE", "FCL")
PARTS = ("particles", "kepler", "all", "rotation", "top", "pairs", "contacts", "growth",
         *world_table.PARTS)
PAIR_FILES = ("geometry_public", "robustness_public")
WITHOUT_GYROSCOPIC_TERM = "constant_omega"
# Who takes the same step, or one of the same order
PEERS = {
    "semi_implicit_euler": {"Odeint": ["symplectic_euler"]},
    "semi_implicit_euler_drift_kick": {"Odeint": ["symplectic_euler"]},
    "velocity_verlet": {"Odeint": ["velocity_verlet"]},
    "yoshida4_kdk": {"Odeint": ["symplectic_rkn_sb3a_mclachlan"]},
    "yoshida4_dkd": {"Odeint": ["symplectic_rkn_sb3a_mclachlan"]},
    "rk4": {"Odeint": ["runge_kutta4", "runge_kutta4_classic"], "GSL": ["rk4"]},
    "dopri5": {"Odeint": ["runge_kutta_dopri5"], "GSL": ["rkf45"]},
}
# What is asked of the random pairs of chapter 4, in the order of the table's rows
QUESTIONS = ("sphere_box", "box_box", "hull32", "hull1000",
             "boolean", "distance", "depth", "manifold")
# Who answers, in the order of its columns
ANSWERED_BY = {
    "formula or SAT": ("closed_form/double", "sat/double"),
    "GJK and EPA": ("gjk_epa/double",),
    "the same, warm": ("gjk_epa_warm/double",),
    "libccd, EPA": ("libccd_epa/double",), "libccd, MPR": ("libccd_mpr/double",),
    "FCL": ("FCL/double",), "FCL, signed": ("FCL_signed/double",),
    "Bullet, GJK": ("Bullet/single", "Bullet/double"),
    "Bullet, boxes": ("Bullet_boxes/single", "Bullet_boxes/double"),
}


def results(report: dict, machine: str) -> dict:
    values = defaultdict(lambda: defaultdict(list))
    for run in sorted(report["benchmarks"], key=lambda run: run["family_index"]):
        for key, (name, scale) in UNITS.items():
            if key in run:
                values[run["name"]][name].append(float(run[key]) * scale)
    medians = {name: {key: rounded(median(each)) for key, each in one.items()}
               for name, one in values.items()}
    for one in medians.values():
        if "million_per_second" in one:
            one["ns"] = rounded(1e3 / one["million_per_second"])
    context = {key: report["context"][key] for key in ("compiler", *LIBRARIES)
               if key in report["context"]}
    return {"machine": machine, **context, "medians": medians}


def add(medians: dict, more: dict) -> None:
    """What other programs found, beside what was measured under the same names."""
    for name, values in more.items():
        medians.setdefault(name, {}).update(
            {key: None if v is None else rounded(v) for key, v in values.items()})


class Tables:
    """The tables of one measurement: rows of cells by their heading."""

    def __init__(self, measured: dict) -> None:
        self.medians = measured["medians"]
        names = [name.split("/") for name in self.medians]
        self.methods = list(dict.fromkeys(n[1] for n in names if "whole" in n))
        self.questions = sorted({"/".join(n[1:3]) for n in names if n[0] == "contacts"},
                                key=lambda each: [*map(QUESTIONS.index,
                                                       each.split("/"))])
        self.sizes = sorted({int(n[3]) for n in names if n[0] == "growth"})
        self.turning = list(dict.fromkeys(n[1] for n in names if n[0] == "top"))
        self.answering = list(dict.fromkeys(n[2] for n in names if n[0] == "pairs"))

    def value(self, name: str, key: str) -> float | None:
        return self.medians.get(name, {}).get(key)

    def ratio(self, a: str, b: str, key: str) -> float | None:
        above, below = self.value(a, key), self.value(b, key)
        return above / below if above and below else None

    def speed(self, method: str, form: str, count: int) -> Cell:
        names = [f"particles/{method}/{form}/{p}/{count}" for p in PRECISIONS]
        return Cell(tuple(self.value(n, "million_per_second") for n in names), ",.4g")

    def over_by_hand(self, method: str) -> Cell:
        swarm, by_hand = ([f"particles/{method}/{form}/{p}/4096" for p in PRECISIONS]
                          for form in ("swarm", "by_hand"))
        return Cell(tuple(self.ratio(*names, "ns") for names in zip(swarm, by_hand)),
                    ".2f")

    def over_bandwidth(self, method: str, kernel: str) -> Cell:
        """What a swarm moves, over what the memory gives for as many numbers."""
        def share(precision: str) -> float | None:
            swarm = f"particles/{method}/swarm/{precision}/1000000"
            kept = self.value(swarm, "kept") or 0
            given = f"bandwidth/{kernel}/{precision}/1000000/{kept:.0f}"
            return self.ratio(swarm, given, "GB_per_second")

        return Cell(tuple(map(share, PRECISIONS)), ".2f")

    def particles(self, method: str) -> dict[str, Cell]:
        at_least = 1 if f"particles/{method}/whole/double/1" in self.medians else 4096
        return {
            "in cache, whole [10⁶/s]": self.speed(method, "whole", at_least),
            "in cache, swarm [10⁶/s]": self.speed(method, "swarm", 4096),
            "time / by hand": self.over_by_hand(method),
            "in memory, whole [10⁶/s]": self.speed(method, "whole", 1000000),
            "in memory, swarm [10⁶/s]": self.speed(method, "swarm", 1000000),
            "bandwidth / triad's": self.over_bandwidth(method, "triad"),
            "bandwidth / update's": self.over_bandwidth(method, "update")}

    def kepler(self, method: str) -> dict[str, Cell]:
        whole, alone = f"kepler/{method}/whole", f"kepler/{method}/alone"
        row = {"Kepler, whole [ns]": Cell((self.value(whole, "ns"),), ",.1f"),
               "Kepler, alone [ns]": Cell((self.value(alone, "ns"),), ",.1f"),
               "energy error": Cell((self.value(whole, "energy_error"),), ".1e")}
        for library in ("Odeint", "GSL"):
            peer = self.fastest(library, PEERS.get(method, {}).get(library, []))
            error = self.value(peer, "energy_error")
            row |= {library: Cell((peer.split("/")[1] if peer else None,), ""),
                    f"time / {library}'s": Cell(
                        (self.ratio(alone, peer, "ns"),), ".2f"),
                    f"{library}'s energy error": Cell((error,), ".1e")}
        return row

    def fastest(self, library: str, steppers: list[str]) -> str:
        names = (f"kepler/{stepper}/{library}" for stepper in steppers)
        return min((name for name in names if name in self.medians),
                   key=lambda name: self.value(name, "ns"), default="")

    def bodies(self, method: str, count: int, key: str, spec: str) -> Cell:
        names = [f"rotation/{method}/{p}/{count}" for p in PRECISIONS]
        return Cell(tuple(self.value(name, key) for name in names), spec)

    def rotation(self, method: str) -> dict[str, Cell]:
        """What a step of a body takes, beside those with which others step as many."""
        def over(other: str, count: int) -> Cell:
            return Cell(tuple(self.ratio(f"rotation/{method}/{p}/{count}",
                                         f"rotation/{other}/{p}/{count}", "ns")
                              for p in PRECISIONS), ".2f")

        return {"1,000 bodies [ns]": self.bodies(method, 1000, "ns", ".1f"),
                "100,000 bodies [ns]": self.bodies(method, 100000, "ns", ".1f"),
                "time / without gyroscopic term": over(WITHOUT_GYROSCOPIC_TERM, 100000),
                "time / Bullet's bodies": over("Bullet_bodies", 100000),
                "time / Bullet's world": over("Bullet_world", 100000),
                "time / ODE's": over("ODE", 100000)}

    def top(self, method: str) -> dict[str, Cell]:
        """What becomes of a free top, and of a body spun about its middle axis."""
        def of(key: str, spec: str, unit: float = 1) -> Cell:
            values = [self.value(f"top/{method}/{p}", key) for p in PRECISIONS]
            return Cell(tuple(None if v is None else v * unit for v in values), spec)

        return {**{f"attitude error, {time} s [°]":
                   of(f"attitude_error_{time}_s", ".3g", math.degrees(1))
                   for time in (1, 10, 100)},
                "energy, 100 s": of("energy_change", "+.1e"),
                "flips, 60 s": of("flips", ".0f"),
                "energy of the flipping, 60 s": of("flips_energy_change", "+.1e")}

    def pairs(self, method: str) -> dict[str, Cell]:
        """How many of the exact pairs, and of those that broke others, go wrong."""
        def of(key: str) -> Cell:
            names = [f"pairs/{file}/{method}" for file in PAIR_FILES]
            return Cell(tuple(self.value(name, key) for name in names), ".0f")

        return {"asked": of("asked"),
                "off by 10⁻⁶": of("off_6"), "off by 10⁻⁹": of("off_9"),
                "wrong side": of("wrong_side"),
                "no answer": of("no_answer"), "no end": of("no_end")}

    def contacts(self, question: str) -> dict[str, Cell]:
        """What an answer takes each, and ours over those that are used most."""
        def answer(methods: tuple[str, ...]) -> Answer:
            names = [f"contacts/{question}/{method}" for method in methods]
            name = next((n for n in names if n in self.medians), "")
            return Answer((self.value(name, "ns"), self.value(name, "wrong")), ",.0f",
                          ("ns", "wrong"))

        row = {heading: answer(methods) for heading, methods in ANSWERED_BY.items()}
        ns = {heading: cell.values[0] for heading, cell in row.items()}

        def over(ours: str, peer: str) -> Cell:
            both = ns[ours] and ns[peer]
            return Cell((ns[ours] / ns[peer] if both else None,), ".2f")

        def over_bullet(ours: str, peer: str) -> Cell:
            both = [answer(tuple(method.replace("double", precision)
                                 for method in ANSWERED_BY[ours])).values[0]
                    for precision in PRECISIONS]
            return Cell(tuple(each / ns[peer] if each and ns[peer] else None
                              for each in both), ".2f")

        return row | {"warm / cold": over("the same, warm", "GJK and EPA"),
                      "GJK and EPA / libccd's": over("GJK and EPA", "libccd, EPA"),
                      "GJK and EPA / Bullet's": over_bullet("GJK and EPA", "Bullet, GJK"),
                      "SAT / Bullet's boxes": over_bullet("formula or SAT",
                                                          "Bullet, boxes")}

    def growth(self, vertices: int) -> dict[str, Cell]:
        """What hulls of so many vertices take."""
        def of(what: str, key: str = "ns") -> Cell:
            return Cell((self.value(f"growth/{what}/{vertices}", key),), ",.0f")

        return {"distance, GJK [ns]": of("distance/gjk_epa"),
                "depth, GJK and EPA [ns]": of("depth/gjk_epa"),
                "depth, SAT [ns]": of("depth/sat"),
                "pairs of edges": of("depth/sat", "edge_pairs")}

    def rows_not_by_method(self, part: str) -> list[dict[str, Cell]]:
        if part == "growth":
            return [{"vertices": Cell((n,), ",.0f")} | self.growth(n)
                    for n in self.sizes]
        return [{"pairs": Cell((each.split("/")[0],), ""),
                 "asked for": Cell((each.split("/")[1],), "")} | self.contacts(each)
                for each in self.questions]

    def rows(self, part: str) -> list[dict[str, Cell]]:
        """A row a method of one of PARTS, if there is anything. "all" is what has a
        row for every method that moves particles."""
        if part in ("contacts", "growth"):
            return self.rows_not_by_method(part)
        if part in world_table.PARTS:
            return world_table.rows(self.medians, part)
        columns = {"particles": [self.particles], "kepler": [self.kepler],
                   "all": [self.particles, self.kepler],
                   "rotation": [self.rotation], "top": [self.top],
                   "pairs": [self.pairs]}[part]
        methods = {"rotation": self.turning, "top": self.turning,
                   "pairs": self.answering}.get(part, self.methods)
        rows = []
        for method in methods:
            cells = {}
            for of in columns:
                cells |= of(method)
            if any(str(cell) != "–" for cell in cells.values()):
                rows.append({"method": Cell((method,), "")} | cells)
        return rows

    def bandwidth(self) -> str:
        """A line on what the memory gave, for as many numbers as a swarm's x and v."""
        def of(kernel: str, share: float = 1) -> Cell:
            names = [f"bandwidth/{kernel}/{p}/1000000/2" for p in PRECISIONS]
            given = [self.value(name, "GB_per_second") for name in names]
            return Cell(tuple(None if g is None else g * share for g in given), ".1f")

        return (f"GB/s in memory: triad {of('triad')} ({of('triad', 3 / 4)} as STREAM "
                f"counts, which leaves out that a line is read before it is written), "
                f"update in place {of('update')}.")


def markdown(rows: list[dict[str, Cell]]) -> str:
    lines = [list(rows[0]), ["---"] + ["---:"] * (len(rows[0]) - 1),
             *(list(map(str, row.values())) for row in rows)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def comma_separated(rows: list[dict[str, Cell]]) -> str:
    """A column for each precision, numbers as they are."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    head = []
    for heading, cell in rows[0].items():
        both = len(cell.values) == 2
        head += [f"{heading}, {p}" for p in cell.parts] if both else [heading]
    writer.writerow(head)
    writer.writerows([value for cell in row.values() for value in cell.values]
                     for row in rows)
    return text.getvalue()
