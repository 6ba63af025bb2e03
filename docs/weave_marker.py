"""The markers in a text: finding them, and reading what they ask for."""
from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from weave_runs import WeaveError

BLOCKS = ("code", "table", "output", "figure", "picture", "notation", "bench",
          "study")
INLINE = ("value", "timing", "machine", "measured", "studied")
OPTION = re.compile(r"(rows|columns|labels|over)=(.*)", re.DOTALL)
# Fenced and inline code is passed over; a marker without its other end is an error
MARKER = re.compile(
    r"(?P<skip>^(?P<fence>```+|~~~+).*?^(?P=fence)[`~]*$|`[^`\n]+`)"
    r"|(?P<join>(?<=\S)\n[ \t]*)?"
    r"(?P<head><!--\s*weave:\s*(?P<words>(?:(?!-->).)*?)\s*-->)"
    r"(?P<old>(?:(?!<!--\s*weave:).)*?)<!--\s*/weave\s*-->"
    r"|(?P<lone><!--\s*/?weave\b)", re.DOTALL | re.MULTILINE)


@dataclass
class Place:
    """One marker: where it stands, its words, and what stands there now."""

    file: Path
    line: int
    words: list[str]
    options: dict[str, str]
    old: str

    @property
    def kind(self) -> str:
        return self.words[0]

    def word(self, index: int, what: str) -> str:
        if len(self.words) <= index:
            raise WeaveError(f"{self.kind} needs {what}")
        return self.words[index]

    def format(self, default: str) -> str:
        return next((w for w in self.words[3:] if w[0] != "*"), default)

    @property
    def scale(self) -> float | None:
        return next((float(w[1:]) for w in self.words[3:] if w[0] == "*"), None)


def parse(file: Path, match: re.Match) -> Place:
    """The place that a match of MARKER stands for."""
    text = match.string
    if match["lone"]:
        raise WeaveError("a marker without its other end")
    try:
        words = shlex.split(match["words"])
    except ValueError as error:
        raise WeaveError(f"{error} in '{match['words']}'") from None
    options = dict(OPTION.fullmatch(w).groups() for w in words if OPTION.fullmatch(w))
    words = [word for word in words if not OPTION.fullmatch(word)]
    if not words or words[0] not in BLOCKS + INLINE:
        raise WeaveError(f"a marker is one of {', '.join(BLOCKS + INLINE)}")
    start = match.start("head")
    begins = not text[text.rfind("\n", 0, start) + 1:start].strip()
    if words[0] in INLINE and begins and not match["join"]:
        raise WeaveError("a comment cannot begin a paragraph: put a word before it")
    return Place(file, line_of(match), words, options, match["old"])


def line_of(match: re.Match) -> int:
    start = match.start("head") if match["head"] else match.start()
    return match.string.count("\n", 0, start) + 1


def replace_all(file: Path, fill: Callable[[Place], str],
                complain: Callable[[int, str], None]) -> str:
    """The file's text with every marker filled; faults are told with their line.

    A comment that begins a line ends its paragraph: such a line is joined to the one
    before it.
    """
    text = file.read_text(encoding="utf-8")

    def replace(match: re.Match) -> str:
        if match["skip"]:
            return match[0]
        try:
            place = parse(file, match)
            join = match["join"] or ""
            before = " " if join and place.kind in INLINE else join
            return before + match["head"] + fill(place) + "<!-- /weave -->"
        except WeaveError as error:
            complain(line_of(match), str(error))
            return match[0]

    return MARKER.sub(replace, text)
