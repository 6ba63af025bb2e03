"""Excerpts of C++ sources by the name of what they define, without a parser of C++."""
from __future__ import annotations

import re
import textwrap
from pathlib import Path

from weave_runs import WeaveError

# Comments, strings, characters and preprocessor lines: what must not be searched
HIDDEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\''
                    r'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.DOTALL | re.MULTILINE)


def blanked(source: str) -> str:
    """The source with everything hidden replaced by spaces, position for position."""
    return HIDDEN.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), source)


def closing(code: str, start: int) -> int:
    """Position after the bracket that closes the one at `start`."""
    depth = 0
    for i in range(start, len(code)):
        depth += (code[i] in "({") - (code[i] in ")}")
        if depth == 0:
            return i + 1
    raise WeaveError("brackets do not match")


def body_after(code: str, name_end: int) -> int | None:
    """Where the body of a function begins whose name ends at `name_end`."""
    after = closing(code, code.index("(", name_end))
    while True:
        between = re.compile(r"[\w\s:<>,&*\[\]\-]*").match(code, after)
        at = between.end()
        if at < len(code) and code[at] == "(":  # noexcept(…), an initialiser
            after = closing(code, at)
        elif code[at:at + 1] == "{" and re.search(r":[^{]*\w\s*$", code[after:at]):
            after = closing(code, at)  # an initialiser in braces
        else:
            return at if code[at:at + 1] == "{" else None


def declaration_start(code: str, name_start: int) -> int:
    """Where the declaration begins that the name at `name_start` belongs to."""
    before = max(code.rfind(c, 0, name_start) for c in ";{}") + 1
    labels = re.compile(r"(?:\s|\b(?:public|private|protected)\s*:)*")
    return labels.match(code, before).end()


def functions(code: str, name: str) -> list[tuple[int, int]]:
    found = []
    for match in re.finditer(rf"(?<![\w:.>]){re.escape(name)}\s*(?=\()", code):
        start = declaration_start(code, match.start())
        # A call has no type before its name, or an operator
        if not re.fullmatch(r"[\w\s:<>,&*\[\]]+[\s&*]", code[start:match.start()]) \
                or re.match(r"return\b|else\b", code[start:]):
            continue
        body = body_after(code, match.start())
        if body is not None:
            found.append((start, closing(code, body)))
    return found


def types(code: str, name: str) -> list[tuple[int, int]]:
    found = []
    pattern = rf"\b(?:struct|class|enum class|enum)\s+{re.escape(name)}\b[^;{{(]*(?={{)"
    for match in re.finditer(pattern, code):
        start = declaration_start(code, match.start())
        found.append((start, code.index(";", closing(code, match.end())) + 1))
    return found


def with_comment(source: str, start: int) -> int:
    """Moves `start` up to the first line of the doc comment above it."""
    line = source.rfind("\n", 0, start) + 1
    while line > 0:
        above = source.rfind("\n", 0, line - 1) + 1
        if not source[above:line].lstrip().startswith("///"):
            break
        line = above
    return line


def symbol(source: str, name: str, struct: bool, doc: bool) -> str:
    """The definition of a function or type; NAME#2 is the second of that name."""
    name, _, which = name.partition("#")
    found = (types if struct else functions)(blanked(source), name)
    if not found:
        kind = "type" if struct else "function"
        raise WeaveError(f"no {kind} '{name}' is defined there")
    if len(found) > 1 and not which:
        raise WeaveError(f"{len(found)} definitions of '{name}': write {name}#1 or …")
    if which and not 1 <= int(which) <= len(found):
        raise WeaveError(f"there are only {len(found)} definitions of '{name}'")
    start, end = found[int(which or 1) - 1]
    start = with_comment(source, start) if doc else source.rfind("\n", 0, start) + 1
    return textwrap.dedent(source[start:end])


def lines_between(source: str, first: str, last: str) -> str:
    """From the first line that matches `first` to the next one that matches `last`."""
    lines = source.splitlines()
    begin = next((i for i, line in enumerate(lines) if re.search(first, line)), None)
    if begin is None:
        raise WeaveError(f"no line matches '{first}'")
    end = next((i for i in range(begin, len(lines)) if re.search(last, lines[i])), None)
    if end is None:
        raise WeaveError(f"no line from there on matches '{last}'")
    return textwrap.dedent("\n".join(lines[begin:end + 1]))


def excerpt(path: Path, words: list[str]) -> str:
    """What a marker's words after the file's name ask for."""
    if not path.is_file():
        raise WeaveError(f"there is no file {path.name}")
    source = path.read_text(encoding="utf-8")
    doc = "+doc" in words
    words = [w for w in words if w != "+doc"]
    if len(words) == 3 and words[0] == "lines":
        return lines_between(source, words[1], words[2])
    if len(words) == 2 and words[0] == "struct":
        return symbol(source, words[1], struct=True, doc=doc)
    if len(words) == 1:
        return symbol(source, words[0], struct=False, doc=doc)
    raise WeaveError('code takes FILE NAME, FILE struct NAME or FILE lines "from" "to"')
