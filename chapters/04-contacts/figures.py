"""The figures of chapter 4: what the benchmarks measured."""
from figure_style import SOFT, new_figure

FLOOR = 1e-16  # no error at all is drawn here
PAIRS = {"sphere_box": "sphere and box", "box_box": "two boxes",
         "hull32": "hulls of 32 vertices", "hull1000": "hulls of 1,000 vertices"}

# The label, colour and marker of each way to a depth
ANSWERS = {
    "gjk_epa/double": ("GJK and EPA", "#0072b2", "o"),
    "gjk_epa/single": ("the same in single", "#56b4e9", "o"),
    "closed_form/double": ("formula", "#009e73", "P"),
    "sat/double": ("SAT", "#009e73", "s"),
    "libccd_epa/double": ("libccd, EPA", "#d55e00", "^"),
    "libccd_mpr/double": ("libccd, MPR", "#d55e00", "v"),
    "FCL/double": ("FCL", "#cc79a7", "<"),
    "FCL_signed/double": ("FCL, signed", "#cc79a7", ">"),
    "Bullet/single": ("Bullet, GJK", "#b08900", "D"),
    "Bullet_boxes/single": ("Bullet, boxes", "#b08900", "X"),
}


def pairs_work(runs):
    """Mean error of a depth against its time, a mark a library."""
    medians = runs["bench:contacts/"]
    figure, panels = new_figure(2, 2, sharey=True, figsize=(10.4, 7.4))
    for axes, (pairs, title) in zip(panels.flat, PAIRS.items()):
        for answer, (label, color, marker) in ANSWERS.items():
            measured = medians.get(f"contacts/{pairs}/depth/{answer}")
            if measured:
                axes.loglog(measured["ns"] / 1000, max(measured["error"], FLOOR),
                            marker, color=color, markersize=9)
        axes.axhline(0.01, color=SOFT, linewidth=1, linestyle="dotted",
                     label="1 %: wrong beyond")
        axes.set_title(title)
        axes.set_ylim(FLOOR / 3, 1)
    for axes in panels[1]:
        axes.set_xlabel("time of a depth [µs]")
    for row in panels:
        row[0].set_ylabel("mean error, share of the depth")
    for label, color, marker in ANSWERS.values():
        panels[0][1].plot([], [], marker, color=color, label=label)
    panels[0][1].legend(loc="upper left", bbox_to_anchor=(1.02, 1))
    return figure


GROWTH = {"depth/sat": ("depth, SAT", "#009e73", "s"),
          "depth/gjk_epa": ("depth, GJK and EPA", "#0072b2", "o"),
          "distance/gjk_epa": ("distance, GJK", "#56b4e9", "D")}


def pairs_growth(runs):
    """Time against the number of vertices of each of two hulls."""
    medians = runs["bench:growth/"]
    figure, axes = new_figure()
    for what, (label, color, marker) in GROWTH.items():
        points = sorted((int(name.split("/")[3]), values["ns"] / 1000)
                        for name, values in medians.items()
                        if name.startswith(f"growth/{what}/"))
        axes.loglog(*zip(*points), marker=marker, color=color, label=label)
        first, time = points[2]
        power = 2 if what == "depth/sat" else 0.5
        guide = [(n, time * (n / first) ** power) for n, _ in points[2:]]
        axes.loglog(*zip(*guide), color=SOFT, linewidth=1, linestyle="dotted")
    axes.plot([], [], color=SOFT, linewidth=1, linestyle="dotted",
              label="n², and √n")
    axes.set_xlabel("vertices of a hull")
    axes.set_ylabel("time of an answer [µs]")
    axes.legend()
    return figure
