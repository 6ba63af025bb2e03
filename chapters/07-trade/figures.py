"""The figures of chapter 7: what the study found."""
from study_figures import overview as panels_of
from study_figures import work_precision


def work_orbit(runs):
    """Who is worth its cost on an eccentric orbit."""
    return work_precision(runs["study:orbit"], "an orbit: error against time")


def work_rope(runs):
    """Who is worth its cost on a stiff rope."""
    return work_precision(runs["study:rope"], "a stiff rope: error against time")


def work_blocks(runs):
    """Who is worth its cost on a stack of boxes."""
    return work_precision(runs["study:stack"], "a stack of boxes: error against time")


def overview(runs):
    """Every problem of the list side by side."""
    return panels_of({name.removeprefix("study:"): records
                      for name, records in runs.items()})
