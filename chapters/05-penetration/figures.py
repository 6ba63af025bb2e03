"""The figures of chapter 5. Each function draws the runs that runs.json lists for it."""
from figure_style import SOFT, new_figure

FLOOR = 1e-9  # what is less is drawn here


def residual(runs):
    """Deepest penetration after one step against the sweeps of that step."""
    figure, panels = new_figure(1, 2, sharey=True, figsize=(10.4, 4.6))
    shown = (("sweeps-corner", "a box in a corner"), ("sweeps-pile", "a pile of ten"))
    for axes, (sweep, title) in zip(panels, shown):
        of_scene = [run for name, run in runs.items() if name.startswith(sweep)]
        for method in of_scene[0].methods:
            points = [(run.results["parameters"]["iterations"],
                       max(run.metric("penetration", method), FLOOR))
                      for run in of_scene]
            axes.loglog(*zip(*points), label=method, **of_scene[0].look(method))
        axes.set_title(title)
        axes.set_xlabel("sweeps over all contacts")
    panels[0].set_ylabel("deepest penetration after one step [m]")
    panels[0].set_ylim(FLOOR / 3, 1)
    panels[1].legend(loc="lower left")
    return figure


def pop(runs):
    """Largest kinetic energy against what is left, a marker a beta."""
    first = next(iter(runs.values()))
    figure, axes = new_figure(figsize=(8.4, 4.8))
    for method in first.methods:
        points = [(run.metric("penetration", method),
                   run.metric("kinetic_energy_max", method)) for run in runs.values()]
        shown = [(max(left, 1e-4), energy) for left, energy in points]
        axes.loglog(*zip(*shown), label=method, **first.look(method))
        for run, point in zip(runs.values(), shown):
            if method == "baumgarte":
                axes.annotate(f"β = {run.results['parameters']['beta']:g}", point,
                              textcoords="offset points", xytext=(8, 3), fontsize=8)
    needed = first.metric("energy_needed", first.methods[0])
    axes.axhline(needed, color=SOFT, linewidth=1, linestyle="dotted",
                 label="what it takes to lift the pile out")
    axes.set_xlim(right=0.4)
    axes.set_xlabel("deepest penetration after a quarter of a second [m]")
    axes.set_ylabel("largest kinetic energy [J]")
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure
