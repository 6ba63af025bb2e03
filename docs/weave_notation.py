"""The table of a chapter's symbols: meaning, unit, and what carries them in the code.

    <!-- weave: notation -->

It is made of the chapter's notation.json and holds for every ```math block of the text:
a symbol without a row, a row without a formula, an identifier that its file does not
declare, and a unit that its doc comment contradicts are faults. docs/weave.md has the
form of the file.
"""
from __future__ import annotations

import json
import os
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from weave_code import blanked, closing
from weave_runs import WeaveError

FORMULA = re.compile(r"^```+math\n(.*?)^```+$", re.DOTALL | re.MULTILINE)
TAG = re.compile(r"\\tag\{([^{}]*)\}")
GREEK = ("alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa "
         "lambda mu nu xi pi rho sigma tau upsilon phi varphi chi psi omega Gamma Delta "
         "Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega ell").split()
LETTER = rf"(?:\\Delta\s*)?(?:\\(?:{'|'.join(GREEK)})(?![A-Za-z])|[A-Za-z])"
# Words and layout go first, then symbols, then every other command
TOKEN = re.compile(
    r"\\\\|\\(?:tag|begin|end|text|mathrm|operatorname)\s*\{[^{}]*\}"
    rf"|(?P<base>\\(?:hat|bar|tilde)\s*(?:\{{{LETTER}\}}|{LETTER})|{LETTER})"
    r"(?:_(?P<sub>\{(?:[^{}]|\{[^{}]*\})*\}|\\[a-z]+\{[^{}]*\}|\\?\w))?"
    r"|\\[A-Za-z]+(?:_\w)?")


def symbols(tex: str) -> list[tuple[str, str]]:
    """Every symbol of a formula: its letter, and the same with its subscript."""
    def bare(text: str) -> str:
        return re.sub(r"\\(?:text|mathrm)|[\s{}]", "", text)

    found = [(bare(m["base"]), bare(m["sub"] or "")) for m in TOKEN.finditer(tex)
             if m["base"]]
    return [(base, f"{base}_{sub}" if sub else base) for base, sub in found]


# --- identifiers ----------------------------------------------------------------------

@cache
def source_of(file: Path) -> str:
    if not file.is_file():
        raise WeaveError(f"notation.json: there is no file {file.name}")
    return file.read_text(encoding="utf-8")


def doc_above(source: str, start: int) -> str:
    """The doc comment on the lines above a declaration, and one behind its line."""
    before, line = source[:start].rpartition("\n")[0], source[start:].partition("\n")[0]
    above = re.search(r"(?:^[ \t]*///.*\n?)*\Z", before + "\n" if before else "",
                      re.MULTILINE)
    behind = re.search(r"///<.*", line)
    text = above[0] + (behind[0] if behind else "")
    return " ".join(re.sub(r"^\s*///<?|///<", " ", text, flags=re.MULTILINE).split())


def extent(code: str, start: int) -> int:
    """Where the declaration ends whose name is at `start`: its body goes with it."""
    for match in re.compile(r"[({;]").finditer(code, start):
        if match[0] == ";":
            return match.end()
        end = closing(code, match.start())
        if match[0] == "{" or code[end:].lstrip().startswith(";"):
            return end
        if code[end:].lstrip()[:1] == "{":
            return closing(code, code.index("{", end))
    return len(code)


def declarations(code: str, name: str, holder: bool) -> list[tuple[int, int]]:
    """Where a name stands, up to the end of its body; a type or function if `holder`."""
    name = re.escape(name)
    held = rf"\b(?:struct|class|using)\s+{name}\b|\b{name}(?=\s*\()"
    pattern = held if holder else rf"\b{name}\b"
    return [(m.start(), extent(code, m.start())) for m in re.finditer(pattern, code)]


def docs_of(file: Path, identifier: str) -> list[str]:
    """Comments that tell of an identifier: NAME, TYPE::MEMBER or FUNCTION(VARIABLE)."""
    source = source_of(file)
    code = blanked(source)
    parts = re.findall(r"\w+", identifier)
    if len(parts) > 1 and re.search(rf"\bnamespace\s+[\w:]*\b{parts[0]}\b", code):
        del parts[0]
    found, docs = [(0, len(code))], []
    for part in parts:
        found = [(start + a, start + b) for start, end in found
                 for a, b in declarations(code[start:end], part, part != parts[-1])]
        docs = [doc_above(source, start) for start, _ in found] + docs
    if not found:
        raise WeaveError(f"notation.json: {file.name} has no '{identifier}'")
    return [doc for doc in docs if doc]


def documented_units(doc: str, name: str) -> set[str]:
    """The units that a doc comment gives a name: `mass m [kg]`, `k = ρ A / 2 [kg/m]`."""
    word = rf"(?<!\w){re.escape(name).replace('_', '[_ ]')}"
    beside = re.findall(word + r"s?\s*\[([^\[\]]+)\]", doc)
    if beside or name == "a":  # which is an article as well
        return set(beside)
    return set(re.findall(word + r"\b[^\[\].;:]{0,40}\[([^\[\]]+)\]", doc))


# --- the table ------------------------------------------------------------------------

@dataclass
class Row:
    """A symbol of notation.json."""

    symbol: str
    meaning: str
    unit: str
    identifiers: list[str]  # "common/physics/forces.hpp weight(m)"
    equations: list[str] | None = None  # where it means this, if elsewhere not

    def covers(self, token: tuple[str, str], tag: str) -> bool:
        base, full = symbols(self.symbol)[0]
        return (full == token[1] or full == base == token[0]) \
            and (self.equations is None or tag in self.equations)

    def files(self, root: Path) -> list[tuple[Path, str]]:
        return [(root / file, name) for file, _, name in
                (identifier.partition(" ") for identifier in self.identifiers)]

    def unit_faults(self, root: Path) -> list[str]:
        faults = []
        for file, identifier in self.files(root):
            name = re.findall(r"\w+", identifier)[-1]
            units = (documented_units(doc, name) for doc in docs_of(file, identifier))
            units = next(filter(None, units), set())
            if units and self.unit not in units:
                faults.append(f"{self.symbol} in [{self.unit}], but {identifier} of "
                              f"{file.name} is in [{', '.join(sorted(units))}]")
        return faults


def read_rows(file: Path) -> tuple[list[Row], set[str]]:
    """The rows, and the symbols of mathematics that need none."""
    if not file.is_file():
        raise WeaveError(f"there is no {file.name}")
    try:
        data = json.loads(file.read_text(encoding="utf-8"))
        rows = [Row(**row) for row in data["symbols"]]
    except ValueError as error:
        raise WeaveError(f"{file.name}: {error}") from None
    except (KeyError, TypeError):
        raise WeaveError(f'{file.name} needs "symbols", each with symbol, meaning, unit '
                         "and identifiers") from None
    empty = next((row for row in rows if not symbols(row.symbol)), None)
    if empty:
        raise WeaveError(f"{file.name}: '{empty.symbol}' is no symbol")
    return rows, set(data.get("known", []))


def formulas(text: str) -> list[tuple[str, list[tuple[str, str]]]]:
    """The tag and the symbols of every displayed formula."""
    found = []
    for match in FORMULA.finditer(text):
        tag = TAG.search(match[1])
        found.append((tag[1] if tag else "", symbols(match[1])))
    return found


def in_short(tags: list[str]) -> str:
    """Numbers of equations in order, neighbours as a range: 1.3–1.5, 1.11."""
    numbers = sorted({tuple(map(int, tag.split("."))) for tag in tags if tag})
    runs: list[list[tuple[int, ...]]] = []
    for number in numbers:
        if runs and runs[-1][-1] == (*number[:-1], number[-1] - 1):
            runs[-1].append(number)
        else:
            runs.append([number])
    ends = ([run[0], run[-1]] if len(run) > 1 else run for run in runs)
    return ", ".join("–".join(".".join(map(str, end)) for end in pair) for pair in ends)


def faults_of(rows: list[Row], known: set[str], text: str, root: Path) -> list[str]:
    shown = formulas(text)
    faults = [fault for row in rows for fault in row.unit_faults(root)]
    for tag, tokens in shown:
        bare = {full for base, full in tokens if base not in known
                and not any(row.covers((base, full), tag) for row in rows)}
        faults += [f"({tag}) has {name}, which has no row" for name in sorted(bare)]
    used = [(token, tag) for tag, tokens in shown for token in tokens]
    for row in rows:
        where = {tag for token, tag in used if row.covers(token, tag)}
        wrong = sorted(set(row.equations or []) - where)
        faults += [f"{row.symbol} is not in ({tag})" for tag in wrong]
        faults += [] if where else [f"{row.symbol} is in no formula"]
    bases = {base for (base, _), _ in used}
    return faults + [f"{name} is in no formula" for name in sorted(known - bases)]


def table(page: Path, text: str, root: Path) -> str:
    """The Markdown table of a chapter's symbols."""
    rows, known = read_rows(page.parent / "notation.json")
    faults = faults_of(rows, known, text, root)
    if faults:
        raise WeaveError("notation.json: " + "; ".join(dict.fromkeys(faults)))
    lines = ["| symbol | meaning | unit | in the code | equations |",
             "|---|---|---|---|---|"]
    for row in rows:
        code = ", ".join(f"[`{name}`]({os.path.relpath(file, page.parent)})"
                         for file, name in row.files(root))
        tags = [tag for tag, tokens in formulas(text)
                if any(row.covers(token, tag) for token in tokens)]
        lines.append(f"| ${row.symbol}$ | {row.meaning} | {row.unit} | {code or '–'} "
                     f"| {in_short(tags)} |")
    return "\n".join(lines)
