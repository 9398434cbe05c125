"""Every input ends soon: with an answer, or a refusal that has a forecast."""

import json
import math
import os
import resource
import sys
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import pytest
import sympy

from arrangement import Arrangement, InputError, OutOfReachError, counts, families
from arrangement.cli import main as arrangement_main
from arrangement.counts import whitney
from arrangement.counts.configuration import PRIME, configuration, is_generic
from arrangement.enumeration.choose import most_faces
from arrangement.library.files import table
from arrangement.numbers import budget
from equilibrium.cli.program import main as equilibrium_main
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.methods.compare import compare
from equilibrium.plane.states.contact_states import contact_states
from proofs_check.cli.program import main as proofs_check_main

#: No question may exceed these CPU seconds and megabytes. How
#: soon most are refused is measured, not tested.
SECONDS, MEGABYTES = 30, 500
PROGRAMS = {
    "arrangement": arrangement_main,
    "equilibrium": equilibrium_main,
    "proofs-check": proofs_check_main,
}
#: From this number on there are questions of more kinds.
MORE = 600
_FAMILIES = {
    "braid": ("n",),
    "coordinate": ("d",),
    "discriminantal": ("n", "d"),
    "generic": ("m", "d"),
    "ish": ("n",),
    "linial": ("type",),
    "near-pencil": ("m", "d"),
    "pencil": ("m", "d"),
    "random-integer": ("m", "d", "bound"),
    "random-sphere": ("m", "d", "bits"),
    "regular": ("planes",),
    "resonance": ("n",),
    "shi": ("type", "m"),
    "threshold": ("n",),
    "threshold-functions": ("n",),
    "type-b": ("n",),
    "type-d": ("n",),
}


_VIEWS = ["sphere", "planes", "cells", "lines", "stereographic", "gnomonic", "dual", "graph"]
_VIEWS_OF_GRASPS = ["grasp", "resist", "slice", "polar", "compare", "proof"]


def _planes(source: Random) -> dict[str, Any]:
    """Return planes of a size that may be out of reach: few entries in all, so that they fit."""
    d = source.choice((1, 2, 3, 3, 4, 5, 8, 30, 200))
    m = min(source.choice((5, 20, 60, 300, 3000, 30_000)), 60_000 // d)
    bound = source.choice((1, 3, 1000, 10**9, 10**40))
    rows = [[source.randint(-bound, bound) for _ in range(d)] for _ in range(m)]
    for row in rows:
        row[0] = row[0] or 1
    found: dict[str, Any] = {"schema_version": 1, "planes": rows}
    if source.random() < 0.4:
        found["offsets"] = [source.randint(-bound, bound) for _ in range(m)]
    return found


def question(number: int, folder: Path) -> list[str]:
    """Return the words of a hostile question, the same for the same number."""
    source = Random(number)
    more = number >= MORE
    kind = source.randrange(4 + more)
    if kind == 4:
        size = str(10 ** source.randint(1, 9) * source.randint(1, 9))
        kept = str(folder / f"{number}.store")
        sweep = ["--elements", f"3..{size}", "--samples", "2", "--store", kept]
        asked = (
            [
                "proofs-check",
                "sweep",
                source.choice(("two-routes", "single-solution", "printed-detachment")),
                *sweep,
            ],
            ["arrangement", "make", "shi", "--type", f"{source.choice('ABCDEFG')}{size}"],
            [
                "arrangement",
                "make",
                "shi",
                "--type",
                source.choice(("E8", "F4", "G2")),
                "--m",
                size,
            ],
        )
        return source.choice(asked)
    if kind == 0:
        name = source.choice(sorted(_FAMILIES))
        size = [10 ** source.randint(1, 12) * source.randint(1, 9) for _ in range(3)]
        values = zip(_FAMILIES[name], size, strict=False)
        return ["arrangement", "make", name, *(w for k, v in values for w in (f"--{k}", str(v)))]
    if kind == 1:
        m = source.choice((3, 12, 100, 1000))
        contacts = [
            {
                "point": ["0", "1"] if source.random() < 0.5 else [str(source.randint(-9, 9)), "1"],
                "normal": source.choice([["0", "1"], ["1", "0"], ["3/5", "4/5"], ["-1", "0"]]),
                "friction": source.choice(["0", "1/2", "1" + "0" * 80]),
                "preload": source.choice(["0", "1", "1" + "0" * 70]),
            }
            for _ in range(m)
        ]
        path = folder / f"{number}.json"
        path.write_text(json.dumps({"schema_version": 1, "contacts": contacts}))
        commands = ("solve", "resisted", "resisted --margin", "solve --methods", "info --modes")
        command, *form = source.choice(commands).split()
        if more and source.random() < 0.3:
            picture = [str(path), "-o", str(folder / f"{number}.svg"), "--wrench", "1", "2", "3"]
            return ["equilibrium", "draw", "--view", source.choice(_VIEWS_OF_GRASPS), *picture]
        load = [] if command == "info" else ["--wrench", "1", "2", "3"]
        return ["equilibrium", command, str(path), *load, *form]
    path = folder / f"{number}.json"
    path.write_text(json.dumps(_planes(source)))
    command = source.choice(
        (
            "count",
            "faces",
            "identify",
            "draw --view lines",
            "draw --view dual",
            "convert",
        )
    )
    form = "chirotope"
    if more and source.random() < 0.7:
        command = source.choice(("convert", f"draw --view {source.choice(_VIEWS)}"))
        form = source.choice(sorted(n for n, form in table.FORMATS.items() if form.write))
    rest = {"draw": ["-o", str(folder / f"{number}.svg")], "convert": ["--to", form]}
    word, *view = command.split()
    return ["arrangement", word, *view, str(path), *rest.get(word, [])]


def asked(words: Sequence[str], seconds: int = SECONDS) -> tuple[int, float, float, str]:
    """Return the exit code, CPU seconds, megabytes, and the last line of stderr.

    A copy of this process answers, so that nothing is imported again. It may not eat the machine.
    """
    read, write = os.pipe()
    child = os.fork()
    if not child:
        code = 70
        try:
            for number, target in ((os.open(os.devnull, os.O_RDWR), 1), (write, 2)):
                os.dup2(number, target)
            sys.stdout, sys.stderr = (os.fdopen(n, "w", closefd=False) for n in (1, 2))
            held = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
            resource.setrlimit(resource.RLIMIT_AS, (held + 4 * 2**30,) * 2)
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
            code = PROGRAMS[words[0]](words[1:])
        except SystemExit as stop:
            code = stop.code if isinstance(stop.code, int) else 70
        finally:
            sys.stderr.flush()
            os._exit(code)
    os.close(write)
    with os.fdopen(read) as stream:
        said = stream.read()
    _, status, used = os.wait4(child, 0)
    peak = used.ru_maxrss - resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    last = said.strip().splitlines()[-1:] or [""]
    return os.waitstatus_to_exitcode(status), used.ru_utime, peak / 1024, last[0]


def check(number: int, folder: Path) -> None:
    words = question(number, folder)
    code, seconds, megabytes, said = asked(words)
    told = (number, words, code, seconds, megabytes, said)
    assert code in (0, 1, 2, 3), told
    assert megabytes < MEGABYTES, told
    assert code != 2 or said.startswith("error: "), told


@pytest.mark.parametrize("number", [2, 10, 11, 16, 29, 41, 586])
def test_a_hostile_question_is_answered_or_refused_soon(number: int, tmp_path: Path) -> None:
    check(number, tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("number", range(100, 1000, 60))
def test_hostile_questions_are_answered_or_refused_soon(number, tmp_path):
    check(number, tmp_path)


def test_no_limit_allows_work_without_a_finite_forecast():
    with pytest.raises(OutOfReachError):
        budget.check_cost("a list without an end", steps=math.inf)
    with budget.limit(math.inf):
        budget.check_cost("a list without an end", steps=math.inf)


@pytest.mark.parametrize("m", range(6))
@pytest.mark.parametrize("d", range(1, 5))
@pytest.mark.parametrize("affine", [False, True])
def test_the_bound_is_attained_in_general_position(m, d, affine):
    planes = families.generic(m, d, affine=affine)
    assert most_faces(m, planes.rank, planes.is_central) == len(planes.faces())


def test_list_refused_by_size_unless_limit_allows():
    planes = families.coordinate(5)
    with budget.limit(1e-6), pytest.raises(OutOfReachError, match="of the 243 faces") as refused:
        planes.faces()
    assert refused.value.f_vector == (1, 10, 40, 80, 80, 32)
    assert len(planes.faces()) == 243


def test_list_refused_by_a_bound_where_counting_takes_long(tmp_path, capsys):
    """Work that decides whether a list is made is within the limits of the list."""
    planes = families.resonance(6)
    with budget.limit(0.1):
        with pytest.raises(
            OutOfReachError, match=r"of the up to .* faces .* count them"
        ) as refused:
            planes.faces()
        assert refused.value.f_vector is None
    path = tmp_path / "planes.json"
    path.write_text(json.dumps(planes.to_dict()))
    assert arrangement_main(["count", str(path), "--json", "--limit", "0.3"]) == 0
    counted = json.loads(capsys.readouterr().out)
    assert counted["f_vector"] == [1, 57750, 700350, 2742180, 4695600, 3662064, 1066044]
    assert counted["engine"] == "none: counted by Zaslavsky's theorem, not enumerated"


def test_work_that_helps_to_decide_is_counted_with_the_rest():
    with budget.meter_steps(1000):
        with pytest.raises(budget.WorkOver), budget.at_most(100):
            budget.spend(101)
        with budget.at_most(100):
            budget.spend(99)
        assert budget.steps_spent() == 200
    with pytest.raises(budget.WorkOver), budget.limit(0.1), budget.at_most(100):
        budget.spend(11)


def test_larger_limit_lists_what_a_smaller_one_lists():
    """The bound alone refuses nothing: the pencil has far fewer faces than planes may have."""
    listed = []
    for k in range(60):
        with budget.limit(1e-6 * 1.3**k):
            try:
                listed.append(len(families.near_pencil(40).faces()))
            except OutOfReachError:
                listed.append(0)
    assert listed == sorted(listed)
    assert 0 < listed.count(0) < 30


def test_planes_of_independent_parts_are_counted_part_by_part():
    assert sum(counts.f_vector(families.coordinate(30))) == 3**30
    chi = counts.first_whitney_numbers(families.coordinate(200))
    assert chi == tuple((-1) ** k * math.comb(200, k) for k in range(201))
    pencil = [[1, 0], [0, 1], [1, 1]]
    blocks = [[0] * 2 * k + row + [0] * (38 - 2 * k) for k in range(20) for row in pencil]
    assert sum(counts.f_vector(Arrangement(blocks))) == 13**20
    assert sum(map(abs, counts.first_whitney_numbers(Arrangement(blocks)))) == 6**20
    skew = Arrangement(
        [[1, 1, 0, 0, 0], [1, -1, 0, 0, 0], [1, 0, 0, 0, 0], [0, 1, 1, 1, 1], [0, 1, 1, 1, 1]],
        [0, 0, 0, 1, 2],
    )
    assert [len(part) for part in counts.irreducible_factors(skew)] == [3, 2]
    assert counts.f_vector(skew) == skew.faces().f_vector


def test_a_basis_of_many_rows_is_found_where_they_span_little():
    parallel = Arrangement([[1, 0, 0]] * 2000, range(2000))
    assert counts.f_vector(parallel) == (0, 0, 2000, 2001)
    pencil = Arrangement([[1, k, 0] for k in range(300)])
    assert counts.f_vector(pencil) == (0, 1, 600, 600)


def test_one_plane_off_the_others_is_a_factor_of_its_own():
    flat = [[1, k, 0] for k in range(30)]
    assert [len(part) for part in counts.irreducible_factors(Arrangement([*flat, [0, 0, 1]]))] == [
        30,
        1,
    ]
    assert len(counts.irreducible_factors(Arrangement([*flat, [0, 0, 1], [0, 1, 1]]))) == 1
    second = Arrangement([flat[0], [0, 0, 1], *flat[1:]])  # not among those that are looked at
    assert [len(part) for part in counts.irreducible_factors(second)] == [1, 30]


def test_factors_that_only_a_prime_shows_are_none():
    planes = Arrangement([[1, 0], [0, 1], [PRIME, 1]])  # modulo the prime two of them coincide
    assert [len(part) for part in counts.irreducible_factors(planes)] == [3]


def test_a_larger_limit_allows_larger_pictures():
    with pytest.raises(
        OutOfReachError,
        match=r"^61 great circles in a picture; .* or more with arrangement.limit\(2\)$",
    ):
        budget.check_size(61, "great circles in a picture")
    with budget.limit(2):
        budget.check_size(61, "great circles in a picture")


def test_generic_planes_counted_without_flats(monkeypatch):
    """By binomials, where the largest minors say so; the lattice of smaller ones agrees."""
    for affine in (False, True):
        planes = families.generic(8, 5, affine=affine)
        by_flats = counts.intersection_lattice(planes).whitney_matrix
        assert counts.doubly_indexed_whitney_numbers(planes) == by_flats
        assert is_generic(configuration(planes))
    parallel = Arrangement([[1, k, k**2, k**3, k**4] for k in (0, 0, *range(1, 7))], range(8))
    assert not is_generic(configuration(parallel))
    monkeypatch.setattr(whitney, "intersection_lattice", None)
    f_vector = counts.f_vector(families.generic(20, 8, affine=True))
    assert sum(f_vector) == most_faces(20, 8, False) == 45_235_089


def test_flats_are_refused_as_soon_as_their_second_rank_is_known(tmp_path, capsys):
    with pytest.raises(OutOfReachError, match="flats of rank 2 and more of 40 planes"):
        counts.intersection_lattice(families.generic(40, 7))
    path = tmp_path / "planes.json"
    rows = [[i**k % 1009 for k in range(1, 6)] for i in range(1, 121)]
    path.write_text(json.dumps({"schema_version": 1, "planes": rows, "offsets": [1] * 120}))
    assert arrangement_main(["count", str(path)]) == 2
    assert "what covers 7,140 orbits of flats of rank 2" in capsys.readouterr().err


def test_the_memory_of_a_family_is_foreseen():
    """A plane takes more than its entries: measured 672 MB for 1.2 million in three dimensions."""
    with pytest.raises(OutOfReachError, match="710 MB"):
        families.shi("A3", 100_000)


def test_flats_of_a_high_rank_are_refused_before_any_is_made():
    rows = [[(i * i + j) % 7 - 3 + 9 * (i == j) for j in range(40)] for i in range(42)]
    with pytest.raises(OutOfReachError, match="flats of planes of rank 40"):
        counts.intersection_lattice(Arrangement(rows))


def test_regions_of_many_lines_are_counted_where_their_faces_are():
    lines = Arrangement([[k % 97 + 1, k] for k in range(1, 2001)], [k * k for k in range(2000)])
    with budget.meter_steps():  # as a command
        assert counts.region_count(lines) == counts.f_vector(lines)[-1] > 1_900_000


def test_refusals_name_what_allows_it_in_python_and_in_commands():
    many = families.generic(40, 7)
    with pytest.raises(OutOfReachError, match=r"or with arrangement\.limit\(\d+\) allows it"):
        counts.intersection_lattice(many)
    with budget.meter_steps(), pytest.raises(OutOfReachError, match=r"or --limit \d+ allows it"):
        counts.intersection_lattice(many)


def test_a_tuple_of_faces_asks_for_all_their_signs():
    faces = families.generic(6, 3).faces()
    with budget.limit(1e-5), pytest.raises(OutOfReachError, match="600 signs"):
        faces[:100]
    assert len(faces[:100]) == 100


def test_what_cannot_be_counted_is_not_to_be_counted_instead():
    planes = Arrangement([[1, k % 7919, k * k % 7907, k**3 % 7901] for k in range(20_000)])
    with pytest.raises(OutOfReachError, match=r"up to .* leave out planes: to count") as refused:
        planes.faces()
    assert refused.value.f_vector is None


def test_very_long_entries_counted_as_short_ones():
    """From 8,000 bits on FLINT finds their divisors."""
    short = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 1, 1], [2, 1, 3]]
    long = 10**2500
    scaled = Arrangement([[x * long * (k + 1) for x in row] for k, row in enumerate(short)])
    assert scaled == Arrangement(short)
    offsets = [long + k**3 for k in range(6)]
    counted = counts.f_vector(Arrangement([[x * long for x in row] for row in short], offsets))
    exact = Arrangement(short, [Fraction(b, long) for b in offsets])
    assert counted == exact.f_vector


def test_many_states_are_refused_from_some_of_the_planes(monkeypatch):
    """The faces of some planes are too many already: not all planes are counted."""
    counted = []
    f_vector = counts.f_vector
    monkeypatch.setattr(counts, "f_vector", lambda a: counted.append(len(a)) or f_vector(a))
    with pytest.raises(OutOfReachError, match=r"about .* choices of states of 120 contacts"):
        contact_states(random_grasp(120, 1))
    assert counted == [27, 80]


def test_resisted_set_refused_by_number_of_states(tmp_path, capsys):
    path = tmp_path / "grasp.json"
    for contacts, code in ((4, 0), (20, 2)):
        path.write_text(json.dumps(random_grasp(contacts, 3).with_preload(1).to_dict()))
        assert equilibrium_main(["resisted", str(path)]) == code
    assert "20 contacts, 14,593 choices of states: this would take" in capsys.readouterr().err


def test_all_methods_are_refused_where_floats_do_not_help():
    grasp = random_grasp(80, 1).with_friction(10**80)
    with pytest.raises(OutOfReachError, match="all methods on 80 contacts"):
        compare(grasp, [0, -1, 0])


def test_a_text_of_sage_is_refused_from_its_commas_and_brackets(tmp_path, capsys):
    text = "H.<x,y> = HyperplaneArrangements(QQ)\nA = H([{}])\n"
    path = tmp_path / "planes.sage"
    path.write_text(text.format("[(1, -2), 3], [0, 1, 1], " * 2))
    assert arrangement_main(["count", str(path), "--json"]) == 0
    assert '"distinct_planes": 2' in capsys.readouterr().out
    path.write_text(text.format("[(1, 2), 3], " * 200_001))
    assert arrangement_main(["count", str(path)]) == 2
    assert "a text of Sage with 1,400,014 comm" in capsys.readouterr().err


def test_states_undecided_by_floats_refused_by_number(tmp_path, capsys):
    path = tmp_path / "grasp.json"
    words = ["resisted", str(path), "--wrench", "1", "2", "3", "--margin"]
    for contacts, codes in ((2, (0, 1)), (12, (2,))):
        grasp = random_grasp(contacts, 3).with_friction(10**80)
        path.write_text(json.dumps(grasp.to_dict()))
        assert equilibrium_main(words) in codes
    said = capsys.readouterr().err
    assert "3,309 choices of states of 12 contacts with huge or tiny numbers: this would" in said


@pytest.mark.parametrize(
    "words",
    [
        "resonance --n 30",
        "resonance --n 64",
        "threshold-functions --n 40",
        "shi --type 100000",
        "shi --type E8 --m 100000",
        "braid --n 100000",
        "pencil --m 1000000000",
        "random-integer --m 1000000000",
        "generic --m 5 --d 100000",
        "random-sphere --m 5 --bits 1000000",
        "regular --planes 100000",
        "separations --polytope permutohedron --n 15",
        "separations --polytope cube --n 40",
    ],
)
def test_members_out_of_reach_are_refused_before_they_are_made(words, capsys):
    assert arrangement_main(["make", *words.split()]) == 2
    out, said = capsys.readouterr()
    assert out == ""
    assert "this would take about" in said or "take fewer planes" in said


@pytest.mark.parametrize(
    ("planes", "code"),
    [
        ([[k % 7919 + 1, k, k * k % 7907] for k in range(60_000)], 2),
        ([[k % 919 + 1, k, k * k % 907] for k in range(300)], 0),
        ([[int(i == j) for j in range(30)] for i in range(30)], 0),
        ([[1, 2, 3]] * 20_000, 0),
        ([[f"{k + 1}" * 20_000, 1, k * k] for k in range(5)], 0),
    ],
    ids=["60,000 planes", "300 planes", "30 coordinates", "equal rows", "20,000 digits"],
)
def test_planes_are_counted_or_refused_from_their_flats(planes, code, tmp_path, capsys):
    path = tmp_path / "planes.json"
    path.write_text(json.dumps({"schema_version": 1, "planes": planes}))
    assert arrangement_main(["count", str(path)]) == code
    assert (code == 2) == ("this would take about" in capsys.readouterr().err)


def test_more_coordinates_than_a_file_may_name_are_refused(tmp_path):
    equations = [f"x{i} - 2*x{i + 1} = 1" for i in range(1, 1001)]
    symbols = sympy.symbols("a:1001")
    wide = {"schema_version": 1, "planes": [["1"] * 1001]}
    matrix = tmp_path / "matrix.txt"
    matrix.write_text(" ".join(["1"] * 1001))
    for make in (
        lambda: table.read_arrangement(wide),
        lambda: table.read_arrangement(str(matrix)),
        lambda: Arrangement.from_equations(equations),
        lambda: Arrangement.from_equations([sympy.Eq(symbols[0], 1)], symbols),
    ):
        with pytest.raises(InputError, match=r"1,001 coordinates; at most 1,000 .*limit\(2\)"):
            make()
    with budget.limit(2):
        assert table.read_arrangement(wide).dimension == 1001
