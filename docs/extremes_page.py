"""The published outcomes of all chapters' extremes, and the page that collects them.

A chapter's extremes.json says what is run, extremes_results.json what came out. The page
docs/extremes.md has a matrix of kinds of extreme by chapters, then a table for each kind.
"""
from __future__ import annotations

import difflib
import json
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = "docs/extremes.md"
BEGIN, END = "<!-- extremes -->", "<!-- /extremes -->"

# Each verdict has a sign of its own, so that none needs a colour, and comes from good to bad
SIGNS = {"accurate": "●", "bounded": "○", "explodes": "✕", "overflows": "⊗", "stops": "■",
         "refused": "–"}
KINDS = {
    "step": "The time step, at and beyond its limit",
    "spin": "Spin",
    "drag": "Drag and damping",
    "friction": "Friction of 0, and without limit",
    "restitution": "Restitution from 0 to 1",
    "mass": "Masses and their ratios",
    "size": "Sizes and speeds",
    "origin": "Far from the origin",
    "shape": "Needles, plates and slivers",
    "overlap": "Touching, deep, and all in one place",
    "tunnelling": "Fast bodies and thin walls",
    "iterations": "One sweep, and a thousand",
    "many": "Many bodies",
    "long": "Long runs",
    "sensitive": "Motions that no one can foresee",
    "frame": "Slow frames",
    "rest": "Nothing happens",
    "input": "What cannot be",
}

SOLVERS = "06-impulses"  # whose methods are compared in a matrix of their own


class PublishError(Exception):
    """What is wrong, in one line."""


@dataclass
class Extreme:
    """One row with what came out of it, in double and in single."""

    chapter: Path
    row: dict
    outcomes: list[str]

    @property
    def verdicts(self) -> list[str]:
        return [outcome.partition(":")[0] for outcome in self.outcomes]


# --- files ----------------------------------------------------------------------------

def find_chapters(root: Path, names: list[str]) -> list[Path]:
    """The folders of these chapters, or of all that have extremes."""
    found = {file.parent.name: file.parent
             for file in sorted(root.glob("chapters/*/extremes.json"))}
    for name in names:
        if name not in found:
            near = difflib.get_close_matches(name, found, 1, 0)
            raise PublishError(f"no chapter '{name}' has extremes; the nearest is {near[0]}")
    return [found[name] for name in names] if names else list(found.values())


def rows_of(folder: Path) -> list[dict]:
    return json.loads((folder / "extremes.json").read_text(encoding="utf-8"))


def published(folder: Path) -> dict[str, list[str]]:
    """The outcomes by what is extreme; none where nothing has been published."""
    file = folder / "extremes_results.json"
    return json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}


def publish(folder: Path, outcomes: dict[str, list[str]]) -> None:
    """A line for each extreme, so that a change of one is a change of one line."""
    lines = [f" {json.dumps(what, ensure_ascii=False)}: "
             f"{json.dumps(pair, ensure_ascii=False)}" for what, pair in outcomes.items()]
    text = "{\n" + ",\n".join(lines) + "\n}\n"
    (folder / "extremes_results.json").write_text(text, encoding="utf-8")


def load(root: Path) -> list[Extreme]:
    """Every extreme with its published outcome."""
    extremes = []
    for folder in find_chapters(root, []):
        outcomes, rows = published(folder), rows_of(folder)
        if [row["what"] for row in rows] != list(outcomes):
            raise PublishError(f"{folder.name}: its extremes are not those that are "
                               "published (./timestep extremes publishes them)")
        extremes += [Extreme(folder, row, outcomes[row["what"]]) for row in rows]
    return extremes


# --- what must hold -------------------------------------------------------------------

def faults(extremes: list[Extreme]) -> list[str]:
    """Rows of no known kind, verdicts of no known word, failures without advice."""
    found = []
    for each in extremes:
        where, row = f"{each.chapter.name}: {each.row['what']}", each.row
        if row.get("kind") not in KINDS:
            found.append(f"{where}: no kind '{row.get('kind')}' ({', '.join(KINDS)})")
        found += [f"{where}: {outcome}" for outcome, verdict
                  in zip(each.outcomes, each.verdicts) if verdict not in SIGNS]
        fails = any(verdict != "accurate" for verdict in each.verdicts)
        if fails and re.match(r"nothing\b|$", row["remedy"]):
            found.append(f"{where}: it fails, and nothing says what to do")
    return found


# --- the page -------------------------------------------------------------------------

def counted(extremes: list[Extreme]) -> Counter:
    """How many runs, of both precisions, ended in each verdict."""
    return Counter(verdict for each in extremes for verdict in each.verdicts)


def number_of(chapter: Path) -> int:
    return int(chapter.name[:2])


def where_it_breaks(chapter: Path, text: str) -> str:
    return f"[{text}](../chapters/{chapter.name}/README.md#where-it-breaks)"


def title_of(chapter: Path) -> str:
    """As its text's first line has it, without what follows a colon."""
    line = (chapter / "README.md").read_text(encoding="utf-8").partition("\n")[0]
    return re.sub(r"^# \d+\. ", "", line).partition(":")[0]


def chapters_of(extremes: list[Extreme]) -> list[Path]:
    return list(dict.fromkeys(each.chapter for each in extremes))


def table(head: list[str], rows: list[list[str]], left: int = 1) -> str:
    """`left` columns are words; the others are numbers."""
    rule = ["---"] * left + ["---:"] * (len(head) - left)
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [head, rule, *rows])


def summary(extremes: list[Extreme]) -> str:
    """A row for each chapter, and one for all."""
    def row(name: str, some: list[Extreme]) -> list[str]:
        counts = counted(some)
        return [name, str(len(some)), *(str(counts[verdict]) for verdict in SIGNS)]

    head = ["chapter", "extremes", *(f"{sign} {verdict}" for verdict, sign in SIGNS.items())]
    rows = [row(where_it_breaks(chapter, f"{number_of(chapter)} {title_of(chapter)}"),
                [each for each in extremes if each.chapter == chapter])
            for chapter in chapters_of(extremes)]
    return table(head, [*rows, row("all", extremes)])


def matrix(columns: dict[str, list[Extreme]]) -> str:
    """Kinds by columns: how many runs of those extremes ended how."""
    rows = []
    for kind, title in KINDS.items():
        of_kind = [counted([each for each in some if each.row["kind"] == kind])
                   for some in columns.values()]
        cells = [" ".join(f"{counts[verdict]}\u00a0{sign}"
                          for verdict, sign in SIGNS.items() if counts[verdict])
                 for counts in of_kind]
        if any(cells):
            rows.append([f"[{title}](#{heading_link(title)})", *cells])
    return table(["kind", *columns], rows)


def by_chapter(extremes: list[Extreme]) -> dict[str, list[Extreme]]:
    return {f"chapter {number_of(chapter)}":
            [each for each in extremes if each.chapter == chapter]
            for chapter in chapters_of(extremes)}


def by_method(extremes: list[Extreme], chapter: str) -> dict[str, list[Extreme]]:
    """Of one chapter, by the method whose name begins the row."""
    columns: dict[str, list[Extreme]] = {}
    for each in extremes:
        method, comma, _ = each.row["what"].partition(",")
        if each.chapter.name == chapter and comma and method in each.row["args"]:
            columns.setdefault(f"`{method}`", []).append(each)
    return columns


def heading_link(title: str) -> str:
    """As repository hosts link to a heading."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def shown(outcome: str) -> str:
    verdict, colon, number = outcome.partition(":")
    return f"{SIGNS[verdict]} {verdict}{colon}{number}"


def section(kind: str, extremes: list[Extreme]) -> str:
    rows = [[where_it_breaks(each.chapter, str(number_of(each.chapter))),
             each.row["what"], each.row["metric"].replace("_", " "),
             *map(shown, each.outcomes), each.row["remedy"]]
            for each in extremes if each.row["kind"] == kind]
    head = ["chapter", "extreme", "judged by", "double", "single", "what to do"]
    return f"## {KINDS[kind]}\n\n{table(head, rows, left=len(head))}"


def solvers(extremes: list[Extreme]) -> list[str]:
    columns = by_method(extremes, SOLVERS)
    return ["## Kinds of extreme, by solver",
            f"Of chapter {int(SOLVERS[:2])} alone:", matrix(columns)] if columns else []


def generated(extremes: list[Extreme]) -> str:
    legend = ", ".join(f"{sign} {verdict}" for verdict, sign in SIGNS.items())
    kinds = [kind for kind in KINDS if any(e.row["kind"] == kind for e in extremes)]
    return "\n\n".join([
        BEGIN,
        f"{len(extremes)} extremes, each in double and in single precision, are "
        f"{2 * len(extremes)} runs: {legend}.",
        summary(extremes), "## Kinds of extreme, by chapter", matrix(by_chapter(extremes)),
        *solvers(extremes), *(section(kind, extremes) for kind in kinds), END])


def bring_up_to_date(root: Path, check: bool) -> int:
    """Writes the page, or says that it is stale; returns the exit code."""
    extremes = load(root)
    wrong = faults(extremes)
    file = root / PAGE
    old = file.read_text(encoding="utf-8")
    if old.count(BEGIN) != 1 or old.count(END) != 1:
        raise PublishError(f"{PAGE} needs the lines {BEGIN} and {END}")
    if not wrong:
        before, after = old.partition(BEGIN)[0], old.partition(END)[2]
        new = before + generated(extremes) + after
        if check and new != old:
            wrong.append(f"{PAGE} is stale (./timestep extremes brings it up to date)")
        elif new != old:
            file.write_text(new, encoding="utf-8")
            print(f"wrote {PAGE}: {len(extremes)} extremes")
    for fault in wrong:
        print(f"extremes: {fault}")
    return 1 if wrong else 0
