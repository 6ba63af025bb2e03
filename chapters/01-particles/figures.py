"""The figures of chapter 1. Each function draws the runs that runs.json lists for it."""
from figure_style import new_figure


def throw_error(runs):
    """Height above the exact flight over time: two straight lines, and zero."""
    run = runs["throw"]
    figure, axes = new_figure()
    time = run.history["time"]
    for method in run.methods:
        height, exact = (run.history[f"{method}/{name}"] for name in ("y", "y_exact"))
        error = [y - e for y, e in zip(height, exact)]
        axes.plot(time, error, label=method, markevery=12, **run.look(method))
    axes.set_xlabel("time [s]")
    axes.set_ylabel("height above the exact flight [m]")
    axes.legend()
    return figure


def order(runs):
    """Error against the step, both logarithmic: slope 1 for all three."""
    first = next(iter(runs.values()))
    figure, axes = new_figure()
    steps = [run.results["dt"] for run in runs.values()]
    for method in first.methods:
        errors = [run.metric("position_error", method) for run in runs.values()]
        axes.loglog(steps, errors, label=method, **first.look(method))
    axes.loglog(steps, [20 * h for h in steps], color="0.5", linestyle=":", label="slope 1")
    axes.set_xlabel("step dt [s]")
    axes.set_ylabel("error after 4 s [m]")
    axes.legend()
    return figure


def spring_energy(runs):
    """Energy over time on a spring, logarithmic: growth is a straight line."""
    run = runs["spring"]
    figure, axes = new_figure()
    for method in run.methods:
        energy = run.history[f"{method}/energy_ratio"]
        axes.semilogy(run.history["time"], energy, label=method, markevery=60,
                      **run.look(method))
    axes.set_xlabel("time [s]")
    axes.set_ylabel("energy / energy at the start")
    axes.legend()
    return figure


def drag(runs):
    """Velocity over time in linear drag for three steps on either side of the limits."""
    figure, axes = new_figure()
    looks = [("o", "-"), ("s", "--"), ("^", ":")]
    for run, (marker, line) in zip(runs.values(), looks):
        z = run.results["parameters"]["linear_drag"] * run.results["dt"]
        axes.plot(run.trajectory["time"], run.trajectory["vx"], marker=marker,
                  linestyle=line, label=f"c dt / m = {z:.1f}")
    axes.axhline(0, color="0.5", linewidth=0.8)
    axes.set_ylim(-4, 4)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("velocity [m/s]")
    axes.legend()
    return figure


def frame_drops(runs):
    """Energy over the wall clock, with a frame of a quarter second after every second."""
    run = runs["frame-drops"]
    figure, axes = new_figure()
    for method in run.methods:
        energy = run.history[f"{method}/energy_ratio"]
        axes.semilogy(run.history["time"], energy, label=method, markevery=24,
                      **run.look(method))
    axes.set_xlabel("wall clock [s]")
    axes.set_ylabel("energy / energy at the start")
    axes.legend()
    return figure


def clock(runs):
    """How far each clock is off, in single precision, over an hour."""
    run = runs["clock-single"]
    figure, axes = new_figure()
    minutes = [t / 60 for t in run.history["time"]]
    stride = max(1, len(minutes) // 600)
    for method in run.methods:
        error = run.history[f"{method}/clock_error"]
        axes.plot(minutes[::stride], error[::stride], label=method, markevery=60,
                  **run.look(method))
    axes.set_xlabel("time [min]")
    axes.set_ylabel("clock error [s]")
    axes.legend()
    return figure
