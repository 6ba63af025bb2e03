"""The figures of chapter 6: what the benchmarks measured."""
from figure_style import SOFT, new_figure

FLOOR = 1e-18  # less, and no error at all, is drawn here
SIMBENCH = {
    "rolling": ("rolling, pulled along an axis", "mean squared error [m²/s²]"),
    "rolling_diagonal": ("rolling, pulled askew", "mean squared error [m²/s²]"),
    "bouncing": ("bouncing, e = 1", "mean squared error [J²]"),
    "666": ("216 balls at rest", "mean squared overlap [m²]"),
    "elastic_666": ("216 balls, e = 1", "mean squared error [J²]"),
}

# The label, colour, marker and line of each method
MOVED_BY = {
    "substeps": ("substeps", "#0072b2", "o", "-"),
    "sequential_impulses": ("sequential impulses", "#009e73", "s", "-"),
    "worst_first": ("worst first", "#56b4e9", "v", "-"),
    "Bullet": ("Bullet", "#d55e00", "^", "-"),
    "Bullet_no_erp": ("Bullet, ERP off", "#d55e00", "X", ":"),
    "ODE": ("ODE", "#cc79a7", "D", "-"),
    "ODE_no_erp": ("ODE, ERP off", "#cc79a7", "P", ":"),
}
STACKS = {"column": "column of 10", "pyramid": "pyramid of 210", "pile": "pile of 1,000"}
ON_STACKS = {"lcp": ("LCP", "#b08900", "*", ""),
             "ODE_world": ("ODE, WorldStep", "#cc79a7", "h", "")}


def simbench_points(medians, scene, method):
    """(seconds, error) from few iterations or long steps on; an error of None failed."""
    start = f"simbench/{scene}/{method}/double/"
    found = [(float(name.removeprefix(start)), values["seconds"], values["error"])
             for name, values in medians.items() if name.startswith(start)]
    found.sort(reverse=not scene.startswith("rolling"))
    return [(seconds, error) for _, seconds, error in found]


def draw_simbench(axes, medians, scene):
    """A line a method, from its coarsest setting to its finest. What failed is a pale mark
    on the upper edge. Returns whether there are any."""
    errors, failed = [], []
    for method, (_, color, marker, line) in MOVED_BY.items():
        points = simbench_points(medians, scene, method)
        shown = [(max(s, 1e-3), max(e, FLOOR)) for s, e in points if e is not None]
        failed += [(max(s, 1e-3), color, marker) for s, e in points if e is None]
        errors += [error for _, error in shown]
        if shown:
            axes.loglog(*zip(*shown), color=color, marker=marker, linestyle=line,
                        markersize=5)
    top = 100 * max(errors)
    for seconds, color, marker in failed:
        axes.plot(seconds, top / 3, color=color, marker=marker, alpha=0.5)
    axes.set_ylim(min(errors) / 10, top)
    return bool(failed)


def simbench(runs):
    """SimBenchmark's errors against the time that they took."""
    medians = runs["bench:simbench/"]
    figure, panels = new_figure(3, 2, figsize=(10.4, 11.0))
    some_failed = False
    for axes, (scene, (title, error)) in zip(panels.flat, SIMBENCH.items()):
        some_failed |= draw_simbench(axes, medians, scene)
        axes.set_title(title)
        axes.set_ylabel(error)
        axes.set_xlabel("processor time [s]")
    legend = panels[2][1]
    legend.set_axis_off()
    for label, color, marker, line in MOVED_BY.values():
        legend.plot([], [], color=color, marker=marker, linestyle=line, label=label)
    if some_failed:
        legend.plot([], [], color=SOFT, marker="o", alpha=0.5, linestyle="none",
                    label="pale, at the upper edge: failed")
    legend.legend(loc="center left", fontsize=11)
    return figure


def stacks(runs):
    """Worst penetration of three stacks against the time of a step; hollow: it fell."""
    medians = runs["bench:stacks/"]
    shown = {m: look for m, look in (MOVED_BY | ON_STACKS).items() if "no_erp" not in m}
    figure, panels = new_figure(1, 3, sharey=True, figsize=(11.4, 4.4))
    for axes, (scene, title) in zip(panels, STACKS.items()):
        for method, (_, color, marker, _) in shown.items():
            found = medians.get(f"stacks/{scene}/{method}/double", {})
            if "ns" in found and "worst_depth" in found:
                face = color if found.get("stands", 1) else "none"
                axes.loglog(found["ns"] * 1e-6, found["worst_depth"] * 1e3, marker,
                            color=color, markerfacecolor=face, markersize=9)
        axes.set_title(title)
        axes.set_xlabel("time of a step [ms]")
    panels[0].set_ylabel("worst penetration in 10 s [mm]")
    for label, color, marker, _ in shown.values():
        panels[2].plot([], [], marker, color=color, label=label)
    panels[2].plot([], [], "o", color=SOFT, markerfacecolor="none",
                   label="hollow: down at 60 s")
    panels[2].legend(loc="upper left", bbox_to_anchor=(1.02, 1))
    return figure
