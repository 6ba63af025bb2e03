"""The figures of chapter 2. Each function draws the runs that runs.json lists for it."""
import math

from figure_style import new_figure
from work_figure import draw_work

TWINS = ("stormer_verlet", "leapfrog", "stormer_verlet_naive_start", "dormand_prince")


def orders(runs):
    """Error against the step on the pendulum: a panel for each order, equal slopes in it."""
    first = next(iter(runs.values()))
    figure, panels = new_figure(1, 3, sharey=True, figsize=(9.6, 4.6))
    groups = {"first order": ("explicit_euler", "semi_implicit_euler", "modified_euler",
                              "semi_implicit_euler_drift_kick", "implicit_euler"),
              "second order": ("velocity_verlet", "position_verlet", "midpoint", "heun",
                               "implicit_midpoint", "implicit_trapezoid"),
              "fourth and fifth": ("rk4", "yoshida4_kdk", "yoshida4_dkd", "dopri5")}
    steps = [run.results["dt"] for run in runs.values()]
    for axes, (title, methods) in zip(panels, groups.items()):
        for method in methods:
            errors = [run.metric("state_error", method) for run in runs.values()]
            axes.loglog(steps, errors, label=method, **first.look(method))
        axes.set_title(title)
        axes.set_xlabel("step dt [s]")
        axes.legend(loc="lower right", fontsize=8)
    panels[0].set_ylabel("error after 3 s [rad]")
    return figure


def energy(runs):
    """Energy error of a pendulum over a thousand swings, logarithmic in both directions."""
    run = runs["energy"]
    figure, axes = new_figure(figsize=(8.4, 4.6))
    time = run.history["time"]
    period = run.metric("period", run.methods[0])
    for method in run.methods:
        # The worst so far, at places that are even on a logarithmic axis
        worst = run.history[f"{method}/energy_error_max"]
        places = sorted({round(1.12 ** k) for k in range(90) if 1.12 ** k < len(time)})
        axes.loglog([time[i] / period for i in places], [worst[i] for i in places],
                    label=method, markevery=9, **run.look(method))
    axes.set_xlim(0.06, 1000)
    axes.set_ylim(1e-5, 10)
    axes.set_xlabel("swings")
    axes.set_ylabel("largest energy error so far")
    axes.legend(ncols=2, fontsize=8, loc="lower right")
    return figure


def stability(runs):
    """Growth of the amplitude per step, a row a method, over omega dt."""
    stiff = runs["stiff"]
    every = [run for name, run in runs.items() if name != "stiff"]
    methods = [m for m in every[0].methods if m not in TWINS]
    z = [run.metric("omega_dt", methods[0]) for run in every]
    growth = [[math.log10(max(run.metric("spectral_radius", m), 1e-9)) for run in every]
              for m in methods]
    # Rounding decides about a radius of one: what is within it counts as one
    growth = [[0 if abs(g) < 1e-12 else g for g in row] for row in growth]
    figure, axes = new_figure(figsize=(8.4, 5.2))
    half = (z[1] - z[0]) / 2
    edges = [z[0] - half] + [x + half for x in z]
    image = axes.pcolormesh(edges, range(len(methods) + 1), growth, cmap="PuOr_r",
                            vmin=-0.3, vmax=0.3, rasterized=False)
    for row, method in enumerate(methods):
        limit = stiff.metric("stability_limit", method)
        if limit < edges[-1]:
            axes.plot([limit] * 2, [row, row + 1], color="black", linewidth=3)
    axes.set_xlim(edges[0], edges[-1])
    axes.set_yticks([row + 0.5 for row in range(len(methods))], methods, fontsize=8)
    axes.invert_yaxis()
    axes.grid(False)
    axes.set_xlabel("ω dt")
    bar = figure.colorbar(image, ax=axes, extend="both")
    bar.set_label("log10 of the growth of the amplitude in a step")
    return figure


def drag(runs):
    """Error against the step with drag: two Verlets of first order, two of second."""
    first = next(iter(runs.values()))
    figure, axes = new_figure()
    steps = [run.results["dt"] for run in runs.values()]
    for method in first.methods:
        errors = [run.metric("state_error_max", method) for run in runs.values()]
        axes.loglog(steps, errors, label=method, **first.look(method))
    axes.set_xlabel("step dt [s]")
    axes.set_ylabel("largest error, in amplitudes")
    axes.legend()
    return figure


def measured(runs, sweep, price):
    """Each method's points (cost of an orbit, error, run) in a sweep."""
    points = {}
    for name, run in runs.items():
        if name.split("@")[0] != sweep:
            continue
        for method in run.methods:
            key = price if len(run.methods) == 1 else f"{method}/{price}"
            error = run.metric("position_error_max", method)
            points.setdefault(method, []).append((run.results["cost"][key] / 10, error, run))
    return points


def work(runs):
    """Error on an orbit against evaluations and against time, in double and in single."""
    figure, panels = new_figure(2, 2, sharey=True, figsize=(9.6, 9.6))
    prices = (("force_evaluations", 1, "evaluations of the force an orbit"),
              ("wall_seconds", 1e6, "time of an orbit [µs]"))
    for row, (price, scale, label) in zip(panels, prices):
        for axes, suffix, title in zip(row, ("", "-single"), ("double", "single")):
            points = {**measured(runs, "work" + suffix, price),
                      **measured(runs, "adaptive" + suffix, price)}
            draw_work(axes, {method: [(c * scale, e, run) for c, e, run in three]
                             for method, three in points.items()})
            axes.set_title(title)
            axes.set_xlabel(label)
        row[0].set_ylabel("largest error in ten orbits, in semi-major axes")
    panels[0][1].legend(fontsize=8, loc="lower left")
    return figure
