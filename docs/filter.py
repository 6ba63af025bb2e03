"""Doxygen's input filter for Markdown as repository hosts understand it.

`$…$` and ```math blocks become Doxygen's. Headings get the anchors that a host gives
them, with the page's folder before, as Doxygen's anchors are shared by all pages. Links
to sources, which are no pages of the book, lead from its folder to the repository.
"""
from __future__ import annotations

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TO_ROOT = "../../.."  # from build/docs/html

PARTS = re.compile(
    r"^```+math\n(?P<display>.*?)^```+$"
    r"|(?P<code>^(?P<fence>```+|~~~+).*?^(?P=fence)[`~]*$"
    r"|(?P<ticks>`+)(?!`).+?(?P=ticks)(?!`))"
    r"|(?<![\\$\w])\$(?P<inline>[^\s$](?:[^$]*[^\s$\\])?)\$(?![\w$])"
    r"|(?P<marker><!--\s*/?weave\b.*?-->)"
    r"|^##+ +(?P<heading>[^\n]+)$"
    r"|(?<!!)\[(?P<text>[^\[\]]*)\]\((?P<link>[^()\s:]+)\)",
    re.DOTALL | re.MULTILINE)


def anchor(file: Path, heading: str) -> str:
    """The page's folder, then the heading as repository hosts write it in links."""
    words = re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
    return f"at-{file.parent.name if file.parent != ROOT else 'home'}-{words}"


def linked(file: Path, link: str) -> str:
    path, _, heading = link.partition("#")
    target = Path(os.path.normpath(file.parent / path)) if path else file
    if heading:
        return "#" + anchor(target, heading)
    if path.endswith(".md"):
        return link
    return f"{TO_ROOT}/{Path(os.path.relpath(target, ROOT)).as_posix()}"


def converted(text: str, file: Path) -> str:
    def replace(match: re.Match) -> str:
        if match["marker"]:  # Doxygen would take the space after it as well
            return ""
        if match["display"] is not None:
            return f"\\f[\n{match['display']}\\f]"
        if match["inline"] is not None:
            return f"\\f${match['inline']}\\f$"
        if match["heading"]:
            return f"{match[0]} {{#{anchor(file, match['heading'])}}}"
        if match["link"]:
            return f"[{match['text']}]({linked(file, match['link'])})"
        return match[0]

    return PARTS.sub(replace, text)


if __name__ == "__main__":
    page = Path(sys.argv[1]).resolve()
    sys.stdout.reconfigure(encoding="utf-8")
    print(converted(page.read_text(encoding="utf-8"), page), end="")
