"""How every figure looks: one style for print, dark and light screens.

Figures are SVG with a transparent background and text as text. Ink and grid are colours
that the figure's own style sheet switches with the reader's colour scheme; methods keep
the colours, markers and dashes that they have in the pictures.
"""
from __future__ import annotations

import io
import re

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (after the choice of a back end)
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

INK, SOFT, GRID = "#1b1f24", "#5b646e", "#d3d9df"
DARK = {INK: "#e6edf3", SOFT: "#a3adb8", GRID: "#3a424b"}
FONTS = "system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', Arial, sans-serif"

matplotlib.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "timestep",
    "figure.figsize": (7.2, 4.2), "figure.constrained_layout.use": True,
    "font.family": "DejaVu Sans", "font.size": 10, "axes.titlesize": 11,
    "axes.titleweight": "bold", "axes.titlelocation": "left",
    "text.color": INK, "axes.labelcolor": INK, "axes.titlecolor": INK,
    "axes.edgecolor": SOFT, "xtick.color": SOFT, "ytick.color": SOFT,
    "xtick.labelcolor": INK, "ytick.labelcolor": INK,
    "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "axes.axisbelow": True,
    "grid.color": GRID, "grid.linewidth": 0.6,
    "lines.linewidth": 1.8, "lines.markersize": 6,
    "legend.frameon": False, "legend.fontsize": 9,
})


def new_figure(rows: int = 1, columns: int = 1, **more) -> tuple[Figure, Axes]:
    """An empty figure; with several rows or columns, an array of axes."""
    figure, axes = pyplot.subplots(rows, columns, **more)
    figure.patch.set_alpha(0)
    for one in figure.axes:
        one.patch.set_alpha(0)
    return figure, axes


def in_the_dark(color: str) -> str:
    """Ink and grid turn light, other colours a quarter of the way to white."""
    parts = (int(color[i:i + 2], 16) for i in (1, 3, 5))
    lighter = "".join(f"{round(part + (255 - part) / 4):02x}" for part in parts)
    return DARK.get(color, f"#{lighter}")


def colour_scheme(colors: list[str]) -> str:
    """The style sheet that lets colours follow the reader's colour scheme."""
    light = "".join(f"--{color[1:]}:{color};" for color in colors)
    dark = "".join(f"--{color[1:]}:{in_the_dark(color)};" for color in colors)
    return (f"<style>svg{{{light}}}"
            f"@media (prefers-color-scheme:dark){{svg{{{dark}}}}}"
            f"text{{font-family:{FONTS} !important}}</style>")


def svg(figure: Figure, digest: str) -> str:
    """The figure as the same text every time, with the digest of its data."""
    file = io.StringIO()
    figure.savefig(file, format="svg", transparent=True,
                   metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
    text = file.getvalue()
    text = re.sub(r"<metadata>.*?</metadata>\s*", "", text, flags=re.DOTALL)
    hexadecimal = re.compile(r"(?<=: )#[0-9a-f]{6}\b")
    colors = sorted(set(hexadecimal.findall(text)))
    text = hexadecimal.sub(lambda m: f"var(--{m[0][1:]}, {m[0]})", text)
    start = text.index("<svg")
    end = text.index(">", start) + 1
    head = f'<?xml version="1.0" encoding="utf-8"?>\n<!-- data: {digest} -->\n'
    lines = (head + text[start:end] + colour_scheme(colors) + text[end:]).splitlines()
    return "\n".join(line.rstrip() for line in lines) + "\n"
