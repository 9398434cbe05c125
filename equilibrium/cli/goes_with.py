"""Which options go with what: one table for all commands, and how others are refused."""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from functools import partial

from equilibrium.model.errors import GraspError

#: What a command is about.
GRASP, ASSEMBLY, MANY = SUBJECTS = "one body", "an assembly", "a file of many grasps"
#: Forms of `solve`, `resisted` and `info` that no option names.
FULL_MODEL = "the verdict of the full model"
LOAD, WHOLE_SET = "a load (--wrench, --force or --weight)", "the whole set"
PARAMETER, FRICTION, BEST = "--parameter", "--friction", "--best-direction"
DESCRIPTION, REPORT = "the description", "the report"

#: For the options of a command the subjects and the forms that they go with. Where an option names
#: no subject it goes with each, and so with forms; options that are not here go with everything.
GOES_WITH: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    "solve": {
        "wrench force weight at": (GRASP, MANY),
        "on": (ASSEMBLY,),
        "wrenches output jobs dask": (MANY,),
        "methods round_normals as_given": (GRASP, ASSEMBLY),
        "as_printed": (GRASP,),
        "cone": (GRASP, FULL_MODEL, "--methods"),
        "shorten": (GRASP, FULL_MODEL),
        "certificate time_limit max_displacement robust all": (GRASP, ASSEMBLY, FULL_MODEL),
    },
    "resisted": {
        "on": (ASSEMBLY,),
        "along": (ASSEMBLY, "--along"),
        "wrench": (GRASP,),
        "force weight at": (GRASP, LOAD, "--margin", PARAMETER, FRICTION, BEST),
        "best_direction": (GRASP, BEST),
        "smallest": (GRASP, "--smallest"),
        "slice": (GRASP, "--slice"),
        "search": (GRASP, "--search"),
        "candidates": (GRASP, LOAD),
        "base": (GRASP, LOAD, "--smallest", BEST),
        "torque_length": (GRASP, "--smallest"),
        "origin": (GRASP, "--slice"),
        "rays max_magnitude": (GRASP, "--search"),
        "also": (GRASP, "--margin"),
        "contacts": ("--margin",),
        "tolerance": ("--margin", "--search", PARAMETER, FRICTION),
        "max_displacement": (LOAD, "--along", "--margin", "--smallest", "--slice", WHOLE_SET, BEST),
    },
    "info": {
        "wrench force weight output": (GRASP, REPORT),
        "at": (GRASP,),
        "norm torque_length torque cone": ("--force-closure",),
        "count time_limit": ("--modes",),
        "preload": (DESCRIPTION, REPORT, "--force-closure"),
    },
    "verify": {"wrench force weight at preload cone": (GRASP,)},
    "draw": {"wrench force weight at origin": (GRASP,)},
}
#: Of more forms only the one that an option does not go with is named.
_MOST_NAMED = 2
_REMEDIES = {
    ("on", GRASP): "a grasp takes --wrench F_X F_Y TAU",
    ("along", GRASP): "a grasp takes --wrench F_X F_Y TAU",
    ("output", GRASP): "--certificate OUT.json writes the proof, `equilibrium draw` a picture",
    ("preload", "--modes"): "modes do not depend on it",
}


def is_set(arguments: argparse.Namespace, option: str) -> bool:
    """Return whether an option was written."""
    value = getattr(arguments, option)
    return not (value is None or value is False or value == [] or (option, value) == ("jobs", 1))


def check_options(
    arguments: argparse.Namespace, command: str, subject: str | None, form: str | None = None
) -> None:
    """Refuse options that do not go with the subject, or with the form of a command.

    Raises:
        GraspError: one of them is set.
    """
    for mine, word in ((subject, "is for"), (form, "goes with")):
        for options, goes_with in GOES_WITH[command].items():
            allowed = [x for x in goes_with if (x in SUBJECTS) == (mine is subject)]
            if mine is None or not allowed or mine in allowed:
                continue
            for option in filter(partial(is_set, arguments), options.split()):
                how = f"{word} {' or '.join(allowed)}, not {word.split()[-1]} {mine}"
                if len(allowed) > _MOST_NAMED:
                    how = f"does not go with {mine}"
                remedy = _REMEDIES.get((option, mine), "leave it out" * (mine is subject))
                raise GraspError(f"--{option.replace('_', '-')} {how}{remedy and '; '}{remedy}")
