"""The page of the tour: one local HTML file, no network, for dark and light screens."""
from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape
from itertools import groupby

STYLE = """
:root { color-scheme: light dark; --ink: #1f2328; --soft: #59636e; --line: #d8dee4;
  --back: #ffffff; --card: #f6f8fa; --link: #0a58ca; --bad: #b42318; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6edf3; --soft: #9aa4af;
  --line: #30363d; --back: #0f1318; --card: #171c23; --link: #79b8ff;
  --bad: #ff8a7a; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 2rem 1.25rem 4rem;
  background: var(--back); color: var(--ink); font: 1rem/1.55 system-ui, sans-serif; }
h1, h2, h3 { line-height: 1.2; } h1 { margin-bottom: .25rem; }
h2 { margin-top: 3.5rem; padding-bottom: .4rem; border-bottom: 1px solid var(--line); }
a { color: var(--link); } nav a, .links a { margin-right: 1rem; white-space: nowrap; }
p.soft, caption, .links { color: var(--soft); }
article { margin: 1.5rem 0; padding: 1.25rem; background: var(--card);
  border: 1px solid var(--line); border-radius: .75rem; }
article h3 { margin: 0 0 .25rem; } article p.soft { margin: 1rem 0 .25rem; }
article p { margin: .25rem 0 1rem; }
img, video { display: block; width: 100%; height: auto; border-radius: .4rem; }
video { margin-top: 1rem; max-width: 45rem; }
.scroll { overflow-x: auto; } caption { text-align: left; padding: 1rem 0 .25rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .9rem .3rem 0; text-align: right; white-space: nowrap;
  border-bottom: 1px solid var(--line); } th:first-child { text-align: left; }
th { font-weight: 600; }
th small { display: block; font-weight: 400; color: var(--soft); }
pre { overflow-x: auto; padding: .7rem .9rem; background: var(--back);
  border: 1px solid var(--line); border-radius: .4rem; }
.dot { display: inline-block; width: .7em; height: .7em; margin-right: .45em;
  border-radius: 50%; } .failed { color: var(--bad); font-weight: 600; }
"""
HEADLINES = 6  # metrics in a table; the rest stands in results.json


@dataclass
class SceneResult:
    """A scene as the page shows it; paths are relative to the page."""

    chapter: dict  # of --list --json
    scene: dict  # of the same
    folder: str
    files: set[str]
    results: dict | None
    failure: str
    command: str


def number(value: object) -> str:
    """Four significant digits; a dash where there is no answer."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return "–" if value in (None, "nan") else escape(str(value))
    if not math.isfinite(value):
        return "–"
    if value == 0 or 1e-3 <= abs(value) < 1e6:
        return f"{value:,}" if isinstance(value, int) else f"{value:.4g}"
    mantissa, exponent = f"{value:.3e}".split("e")
    return f"{mantissa} × 10<sup>{int(exponent)}</sup>".replace("-", "−")


def sentence(text: str) -> str:
    return text[:1].upper() + text[1:]


def by_method(values: dict, methods: list[str]) -> tuple[list[str], dict]:
    """The names without a method's prefix, and {(method, name): {"value", "unit"}}."""
    names: list[str] = []
    cells = {}
    for key, value in values.items():
        prefix, _, rest = key.partition("/")
        of, name = ([prefix], rest) if rest and prefix in methods else (methods, key)
        if name not in names:
            names.append(name)
        for method in of:
            cells[method, name] = value if isinstance(value, dict) else {"value": value}
    return names, cells


def table(title: str, values: dict, methods: list[str], colors: dict) -> str:
    names, cells = by_method(values, methods)
    names = names[:HEADLINES]
    if not names:
        return ""

    def heading(name: str) -> str:
        unit = next((c.get("unit") for (_, n), c in cells.items() if n == name), "")
        words, below = escape(name.replace("_", " ")), escape(unit or "") or "&nbsp;"
        return f'<th scope="col">{words}<small>{below}</small></th>'

    def row(method: str) -> str:
        color = escape(colors.get(method, "gray"))
        dot = f'<span class="dot" style="background:{color}">'
        values = (cells.get((method, name), {}).get("value") for name in names)
        cells_html = "".join(f"<td>{number(value)}</td>" for value in values)
        return f'<tr><th scope="row">{dot}</span>{escape(method)}</th>{cells_html}</tr>'

    head = '<tr><th scope="col">method</th>' + "".join(map(heading, names)) + "</tr>"
    body = "".join(map(row, methods))
    return (f'<div class="scroll"><table><caption>{title}</caption>'
            f"<thead>{head}</thead><tbody>{body}</tbody></table></div>")


def tables(result: SceneResult) -> str:
    if not result.results:
        return ""
    offered = {m["name"]: m.get("color", "gray") for m in result.scene["methods"]}
    used = result.results.get("method", "")
    used = used if isinstance(used, list) else used.split(",")
    methods = [m for m in used if m] or list(offered)
    return (table("What came out", result.results.get("metrics", {}), methods, offered)
            + table("What it cost", result.results.get("cost", {}), methods, offered))


def media(result: SceneResult) -> str:
    alt = escape(f"{result.scene['name']}: {result.scene['summary']}")
    html = ""
    if "filmstrip.png" in result.files:
        path = f"{result.folder}/filmstrip.png"
        html += f'<a href="{path}"><img src="{path}" alt="{alt}" loading="lazy"></a>'
    if "movie.mp4" in result.files:
        html += (f'<video controls muted loop playsinline preload="metadata" '
                 f'src="{result.folder}/movie.mp4" aria-label="{alt}"></video>')
    return html


def divergence(result: SceneResult) -> str:
    """What the scene shows where a method has no answer: that it failed, and when."""
    failed = (result.results or {}).get("failed", {})
    parts = []
    for key, what in failed.items():
        if key.endswith("what"):
            method, time = key[:-4].rstrip("/"), failed.get(key[:-4] + "time")
            when = f"{number(time)} s ({escape(str(what))})"
            parts.append(f"{escape(method) or 'it'} failed at {when}")
    return f'<p class="failed">{"; ".join(parts)}</p>' if parts else ""


def article(result: SceneResult) -> str:
    failure = f'<p class="failed">Failed: {escape(result.failure)}</p>'
    names = ("results.json", "trajectory.csv", "history.csv")
    links = "".join(f'<a href="{result.folder}/{name}">{name}</a>'
                    for name in names if name in result.files)
    shown = failure if result.failure else media(result)
    return (f'<article id="{result.folder.replace("/", "-")}">'
            f"<h3>{escape(result.scene['name'])}</h3>"
            f"<p>{escape(sentence(result.scene['summary']))}</p>"
            f"{shown}{divergence(result)}{tables(result)}"
            '<p class="soft">Again:</p>'
            f"<pre><code>{escape(result.command)}</code></pre>"
            f'<div class="links">{links}</div></article>')


def chapter_section(name: str, results: list[SceneResult]) -> str:
    title = escape(f"{int(name[:2])}. {results[0].chapter['title']}")
    return (f'<section id="{name}"><h2>{title}</h2>'
            f'<p><a href="../chapters/{name}/README.md">Read the chapter</a></p>'
            + "".join(map(article, results)) + "</section>")


STUDY = ('<a href="study/front.md">What no other setting beats</a>'
         '<a href="study/study.csv">The quick study</a>')


def page(results: list[SceneResult]) -> str:
    groups = groupby(results, key=lambda r: r.chapter["chapter"])
    chapters = [(name, list(of)) for name, of in groups]
    links = "".join(f'<a href="#{name}">{escape(of[0].chapter["title"])}</a>'
                    for name, of in chapters)
    sections = "".join(chapter_section(name, of) for name, of in chapters)
    failed = sum(bool(r.failure) for r in results)
    note = f'<p class="failed">{failed} of {len(results)} scenes failed.</p>'
    return ('<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>Timestep: the tour</title><style>{STYLE}</style></head><body>"
            "<h1>Timestep: the tour</h1>"
            '<p class="soft">Every chapter, as this machine has just computed it.</p>'
            f"<nav>{links}{STUDY}</nav>{note if failed else ''}{sections}</body></html>\n")
