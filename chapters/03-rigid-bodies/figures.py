"""The figures of chapter 3. Each function draws the runs that runs.json lists for it."""
import work_figure
from figure_style import new_figure

SHOWN = ("listing_3", "explicit_gyroscopic", "implicit_gyroscopic", "explicit_rescaled_L",
         "momentum", "buss", "splitting", "discrete_moser_veselov", "rotor_splitting",
         "rotor_splitting_4", "rk4", "rkmk4")
FLOOR = 1e-16  # rounding to nothing is drawn here


def drift(runs):
    """Four errors of a free top over 100 s: three of them are blind to Listing 3."""
    run = runs["drift"]
    figure, panels = new_figure(2, 2, sharex=True, figsize=(10.4, 7.4))
    time = run.history["time"]
    places = sorted({round(1.15 ** k) for k in range(90) if 1.15 ** k < len(time)})
    columns = (("attitude_error_max", "attitude [rad]"), ("energy_error_max", "energy"),
               ("momentum_length_error_max", "length of L"),
               ("momentum_direction_error_max", "direction of L [rad]"))
    for axes, (column, title) in zip(panels.flat, columns):
        for method in SHOWN:
            worst = run.history[f"{method}/{column}"]
            axes.loglog([time[i] for i in places],
                        [max(worst[i], FLOOR) for i in places],
                        label=method, markevery=8, **run.look(method))
        axes.set_title(title)
        axes.set_ylim(FLOOR / 3, 30)
    for axes in panels[1]:
        axes.set_xlabel("time [s]")
    for row in panels:
        row[0].set_ylabel("largest error so far")
    panels[0][1].legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.02, 1))
    return figure


def shape(runs):
    """Attitude error after ten seconds against how far the body is from a ball."""
    first = next(iter(runs.values()))
    figure, axes = new_figure(figsize=(8.0, 4.8))
    for method in first.methods:
        points = sorted((run.results["parameters"]["i3"] - 1,
                         max(run.metric("attitude_error_max", method), FLOOR))
                        for run in runs.values())
        axes.loglog(*zip(*points), label=method, **first.look(method))
    axes.set_xlabel("(I₃ − I₁) / I₁: 0 is a ball, 1 a flat disc")
    axes.set_ylabel("largest attitude error in 10 s [rad]")
    axes.legend(fontsize=8)
    return figure


def draw_work(axes, runs):
    """Error against the time of a simulated second, a line a method, and the front."""
    work_figure.draw_work(axes, {
        method: [(run.results["cost"][f"{method}/wall_seconds"] * 1e5,
                  run.metric("attitude_error_max", method), run) for run in runs]
        for method in runs[0].methods})


def work(runs):
    """Attitude error of a free top in ten seconds against time, double and single."""
    figure, panels = new_figure(1, 2, sharey=True, figsize=(10.4, 5.0))
    for axes, sweep, title in zip(panels, ("work", "work-single"), ("double", "single")):
        draw_work(axes, [run for name, run in runs.items()
                         if name.split("@")[0] == sweep])
        axes.set_title(title)
        axes.set_xlabel("time for a simulated second [µs]")
    panels[0].set_ylabel("largest attitude error in 10 s [rad]")
    panels[1].legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.02, 1))
    return figure
