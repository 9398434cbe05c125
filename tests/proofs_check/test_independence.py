"""The implementations of a claim run no code in common beside numbers, planes and the model."""

import sys
from collections.abc import Iterator
from functools import cache
from itertools import islice
from pathlib import Path
from random import Random
from types import CodeType, FrameType
from typing import Any

import pytest

from proofs_check.claims import entries, registry
from proofs_check.statements.statement import Claim

ROOT = Path(__file__).resolve().parent.parent.parent
PACKAGES = ("arrangement", "equilibrium", "proofs_check")
#: What each implementation may use: numbers, the data of arrangements and grasps, instances, lines
#: of progress, errors, and answers that name what is there.
COMMON = (
    "arrangement/console/",
    "arrangement/errors.py",
    "arrangement/hints.py",
    "arrangement/numbers/",
    "arrangement/planes/planes.py",
    "equilibrium/model/",
    "proofs_check/instances/",
)
#: What else the implementations of some claims share, whole files or functions, and why.
SHARED: list[tuple[str, str, str]] = [
    (
        "single-solution vertical-limit-every-friction",
        "proofs_check/routes/oracle.py: union",
        "Joins closed intervals; each implementation finds its own.",
    ),
    (
        "euler dual-edge-and-face-bounds dual-bipartite-bounds",
        "proofs_check/claims/dual.py: _vef",
        "Names three of the numbers of faces, which are enumerated and counted.",
    ),
    (
        "dual-planar-3-connected sphere-dual-weights hamming-edges",
        "proofs_check/routes/dual_graph.py: from_signs _bits _flags",
        "Makes the graph of sign vectors; faces and covectors give these.",
    ),
    (
        "hamming-edges",
        "proofs_check/claims/dual.py: _hamming",
        "The quantity of the claim, of the graphs of faces and of covectors.",
    ),
    (
        "hamming-edges",
        "proofs_check/routes/dual_graph.py: distances DualGraph.neighbours",
        "Lengths of paths, of the graphs of faces and of covectors.",
    ),
    (
        "algorithm-2-sound algorithm-2-complete all-stick-listed",
        "proofs_check/routes/oracle.py: Question.to_dict",
        "Writes the question down for the solver, and for its steps.",
    ),
    (
        "algorithm-2-sound algorithm-2-complete all-stick-listed",
        "arrangement/library/files/json_files.py: check_all check_keys check_list",
        "Reads the contacts of the question.",
    ),
    (
        "algorithm-2-null-space",
        "proofs_check/routes/oracle.py: all_states Reading.states",
        "Lists all 4^m choices of states; each implementation decides them.",
    ),
    (
        "census-types",
        "proofs_check/claims/others.py: _census_planes",
        "The arrangements of the census, whose isomorphism classes are told apart in two ways.",
    ),
    (
        "census-types",
        "arrangement/library/census/catalogue.py",
        "The arrangements of the census, whose isomorphism classes are told apart in two ways.",
    ),
    (
        "simplicial-catalogue",
        "proofs_check/claims/others.py: _vectors",
        "Counts incidences, which the lattice and the great circles find.",
    ),
    (
        "slip-states-in-space slip-states-of-two-bodies slip-states-of-a-stack",
        "proofs_check/claims/space.py: _slip_arrangement",
        "The planes whose faces are listed and counted.",
    ),
    (
        "slip-states-of-a-stack",
        "proofs_check/claims/space.py: _product",
        "Multiplies the numbers of both bodies, which are listed and counted.",
    ),
    (
        "stacks-are-decided-apart",
        "proofs_check/claims/space.py: _apart",
        "Writes down the question of each body.",
    ),
    (
        "leaves-do-not-grow planar-verdicts-embed",
        "proofs_check/routes/oracle.py: Question.to_dict",
        "Writes the question down for the solver.",
    ),
    (
        "leaves-do-not-grow",
        "proofs_check/claims/space.py: _verdict",
        "Has the certificate made, whose leaves are counted in two ways.",
    ),
    (
        "planar-verdicts-embed",
        "proofs_check/claims/space.py: _in_space",
        "Puts the contacts into space.",
    ),
]
#: Claims of which one solver makes the value and its certificate, and the code that checks this.
#: Their implementations may share all of `arrangement` and `equilibrium`.
CERTIFIED = {
    "sphere-dual-convex": "proofs_check/routes/rivin.py",
    "leaves-do-not-grow": "proofs_check/routes/leaves.py",
    "more-edges-hold-no-less": "equilibrium/certificate/checker.py",
    "planar-verdicts-embed": "equilibrium/certificate/checker.py",
}


#: What an implementation of this name runs: files, or functions of them.
RUNS = {
    "adding": ["proofs_check/claims/equations.py: _add_equations"],
    "brute_force": ["proofs_check/routes/bodies.py"],
    "certificates": ["equilibrium/certificate/checker.py: check"],
    "checker": ["equilibrium/certificate/checker.py: check"],
    "chi": ["arrangement/counts/"],
    "circles": ["arrangement/enumeration/great_circles/"],
    "codes": ["proofs_check/claims/others.py: _by_codes"],
    "covectors": ["proofs_check/routes/dual_graph.py: from_covectors"],
    "criterion": ["arrangement/duals/inscribed/report.py: Inscribability.verify"],
    "cycles": ["proofs_check/claims/sphere.py: _weights_by_hand"],
    "elimination": ["proofs_check/routes/oracle.py: project"],
    "enumeration": ["arrangement/enumeration/"],
    "faces": [
        "arrangement/enumeration/",
        "equilibrium/methods/weak_strong.py: weak_strong",
        "equilibrium/modes.py",
    ],
    "flow": ["proofs_check/claims/sphere.py: _weights_by_flows"],
    "generators": [
        "proofs_check/routes/leaves.py: leaf_count",
        "proofs_check/routes/contact_modes.py: mode_counts",
    ],
    "hand": ["proofs_check/claims/space.py: _boxed_by_hand"],
    "isomorphism": ["proofs_check/claims/others.py: _by_isomorphism"],
    "lattice": ["arrangement/counts/lattice.py"],
    "linear_program": ["equilibrium/methods/"],
    "linear_programs": ["arrangement/numbers/linear/programs.py"],
    "method": ["equilibrium/methods/grasp_robustness.py"],
    "minors": ["proofs_check/routes/rigid_loads.py: within_bound"],
    "networkx": ["proofs_check/claims/dual.py: _planar_by_networkx"],
    "null_space": ["equilibrium/core/contact_program.py"],
    "planes": ["proofs_check/claims/sphere.py: _edge_counts_by_supports"],
    "qhull": ["arrangement/duals/inscribed/hull.py"],
    "regions": ["arrangement/enumeration/"],
    "solver": ["equilibrium/decide/"],
    "solvers": ["equilibrium/decide/"],
    "states": ["proofs_check/routes/oracle.py: stable"],
    "steps": ["arrangement/enumeration/paper_steps.py", "proofs_check/instances/grasps.py"],
    "substitution": ["proofs_check/claims/tables.py: _by_substitution"],
    "theorem": ["arrangement/counts/"],
    "writing": ["proofs_check/routes/oracle.py: Systems.rows"],
}


def caches() -> Iterator[Any]:
    for name, module in list(sys.modules.items()):
        if name.split(".")[0] in PACKAGES:
            for value in list(vars(module).values()):
                if hasattr(value, "cache_clear"):
                    yield value


def third(claim: Claim) -> Any:
    """Return what the third case is about, made anew, so that nothing of it is computed."""
    source = next(iter(claim.all_sources(0)))
    found = (case for case in source.cases(Random(0)) if claim.includes(case.subject))
    return list(islice(found, 3))[-1].subject


@cache
def called(id: str, route: int) -> frozenset[CodeType]:
    """Return the code of the packages that an implementation runs."""
    claim = CLAIMS[id]
    for kept in caches():
        kept.cache_clear()
    codes, subject = set(), third(claim)

    def note(frame: FrameType, event: str, _: object) -> None:
        if event == "call":
            codes.add(frame.f_code)

    sys.setprofile(note)
    try:
        claim.routes[route].compute(subject)
    finally:
        sys.setprofile(None)
    folders = tuple(f"{ROOT / name}/" for name in PACKAGES)
    return frozenset(code for code in codes if code.co_filename.startswith(folders))


def file_of(code: CodeType) -> str:
    return Path(code.co_filename).relative_to(ROOT).as_posix()


CLAIMS = {claim.id: claim for claim in registry() if not claim.large}


@pytest.mark.parametrize("id", CLAIMS)
def test_implementations_share_what_is_argued(id):
    argued = {}
    for ids, place, _ in SHARED:
        if id in ids.split():
            file, _, names = place.partition(": ")
            argued.setdefault(file, set()).update(names.split())
    first, second = (called(id, route) for route in (0, 1))
    common = (*COMMON, "arrangement/", "equilibrium/") if id in CERTIFIED else COMMON
    found = {}
    for code in first & second:
        if not (file := file_of(code)).startswith(common):
            name = code.co_qualname.split(".<locals>")[0]
            found.setdefault(file, set()).update([name] if argued.get(file, True) else [])
    assert found == argued
    assert id not in CERTIFIED or CERTIFIED[id] in map(file_of, second)


def runs(id: str, route: int, word: str) -> bool:
    """Return whether an implementation runs what the word of a name stands for."""
    places = [place.partition(": ") for place in RUNS[word]]
    return any(
        file_of(code).startswith(file) and name in ("", code.co_qualname)
        for code in called(id, route)
        for file, _, name in places
    )


@pytest.mark.parametrize("id", entries())
def test_exchanged_names_of_implementations_are_noticed(id):
    """The word of a name is in its text and not in the other; so is what it runs."""
    (one, text), (two, other) = entries()[id][1]["routes"].items()
    for word, own, others in ((one, text, other), (two, other, text)):
        assert word.replace("_", " ") in own.lower()
        assert word.replace("_", " ") not in others.lower()
    if id in CLAIMS:
        assert runs(id, 0, one)
        assert runs(id, 1, two)
        assert not (runs(id, 0, two) and runs(id, 1, one))
