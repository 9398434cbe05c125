"""The verified program beside engines and counts, where `make formal` has built it."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from itertools import islice
from pathlib import Path
from random import Random
from typing import Any

import pytest

from arrangement import Arrangement, InputError, OutOfReachError, counts
from arrangement.counts.completeness import certify_complete
from arrangement.library import census, families
from arrangement.library.census import tables
from arrangement.library.published import published_counts
from arrangement.numbers.budget import limit
from arrangement.numbers.exact import primitive, sign_text, to_text
from arrangement.planes import proved
from arrangement.planes.proved import proved_f_vector, proved_whitney_numbers

PROGRAM = proved.program()
built = pytest.mark.skipif(PROGRAM is None, reason="`make formal` has not built the program")


def arrangements(seed: str, largest: int = 6) -> Iterator[Arrangement]:
    """Yield arrangements forever: degenerate ones, empty ones, huge entries."""
    source = Random(seed)
    while True:
        d, m = source.randrange(0, largest + 2), source.randrange(0, largest + 1)
        m = 0 if d == 0 else min(m, 10 - d)
        bound = source.choice([1, 1, 2, 5, 1000, 10 ** source.randrange(4, 300)])
        rank = source.randrange(1, d + 1) if d else 0
        rows: list[list[int]] = []
        while len(rows) < m:
            row = [source.randint(-bound, bound) if j < rank else 0 for j in range(d)]
            row = [source.choice([-2, 1]) * x for x in source.choice(rows)] if (
                rows and source.random() < 0.15
            ) else row  # fmt: skip
            if any(row):
                rows.append(row)
        offsets = [source.randint(-bound, bound) for _ in rows] if source.random() < 0.6 else None
        if offsets and source.random() < 0.5:
            offsets = [source.choice([-1, 0, 1]) for _ in rows]
        yield Arrangement(rows, offsets, dimension=d)


def certificate(planes: Arrangement) -> dict[str, Any]:
    """Return the certificate that the engine's list of faces is complete."""
    listed = [[sign_text(f.signs), list(map(to_text, f.witness))] for f in planes.faces()]
    rows = {
        "planes": [list(map(to_text, n)) for n in planes.normals],
        "offsets": list(map(to_text, planes.offsets)),
        "dimension": planes.dimension,
    }
    document = {"certificate": "all faces", "planes": {"schema_version": 1, **rows}}
    return {"schema_version": 1, **document, "faces": listed}


def answers(documents: Iterable[Any], folder: Path, *options: str) -> list[str]:
    """Return what the program says of documents, or of bytes."""
    paths = []
    for i, one in enumerate(documents):
        paths.append(folder / f"{i}.json")
        paths[-1].write_bytes(one if isinstance(one, bytes) else json.dumps(one).encode())
    done = subprocess.run([PROGRAM or "", *options, *paths], capture_output=True, text=True)
    assert not done.stderr
    assert done.returncode in (0, 1, 2)
    return done.stdout.splitlines()


def assert_malformed(
    good: dict[str, Any], changes: list[Any], said: str, folder: Path, *options: str
) -> None:
    """Check what is said of a document, and that it is malformed with each of the changes."""
    bad = [change if isinstance(change, bytes) else {**good, **change} for change in changes]
    first, *rest = answers([good, *bad], folder, *options)
    assert first == said
    assert [line.partition(":")[0] for line in rest] == ["malformed"] * len(changes)


@cache
def cases(seed: str, number: int) -> tuple[list[Arrangement], list[dict[str, Any]]]:
    all_planes = list(islice(arrangements(seed), number))
    return all_planes, [certificate(planes) for planes in all_planes]


@cache
def forgeries(seed: str, number: int) -> list[dict[str, Any]]:
    source, forged = Random(seed), []
    usable = (planes for planes in arrangements(seed, 4) if len(planes) and planes.dimension)
    for i, planes in enumerate(islice(usable, number)):
        document = certificate(planes)
        FORGERS[i % len(FORGERS)](document, source)
        forged.append(document)
    return forged


def check_agreement(seed: str, number: int, folder: Path) -> None:
    all_planes, certificates = cases(seed, number)
    documents = [one["planes"] for one in certificates]
    found = {
        option: [
            [int(word) for word in line.removeprefix("counted:").split()]
            for line in answers(documents, folder, f"--{option}")
        ]
        for option in ("faces", "regions", "polynomial")
    }
    read = [json.loads(line)["planes"] for line in answers(certificates, folder, "--question")]
    said = answers(certificates, folder)
    for i, planes in enumerate(all_planes):
        f_vector = planes.faces().f_vector
        assert f_vector == counts.f_vector(planes)
        whitney = list(counts.first_whitney_numbers(planes))
        padded = [*found["faces"][i], *[0] * planes.dimension]
        assert tuple(padded[: planes.dimension + 1])[::-1] == f_vector
        assert sum(padded) == sum(f_vector)
        assert found["regions"][i] == [f_vector[-1]]
        padded = [*found["polynomial"][i], *[0] * planes.rank]
        assert padded[: len(whitney)] == whitney
        assert not any(padded[len(whitney) :])
        assert said[i] == "accepted: all faces"
        assert [primitive(tuple(map(int, row))) for row in read[i]] == list(planes.integer_planes)


Forger = Callable[[dict[str, Any], Random], None]


def _repeated(document: dict[str, Any], source: Random) -> None:
    """One face twice, in place of another: the number is right."""
    faces = document["faces"]
    first, second = source.sample(range(len(faces)), 2)
    faces[first] = faces[second]


def _left_out(document: dict[str, Any], source: Random) -> None:
    del document["faces"][source.randrange(len(document["faces"]))]


def _wrong_sign(document: dict[str, Any], source: Random) -> None:
    face = source.choice(document["faces"])
    at = source.randrange(len(face[0]))
    face[0] = face[0][:at] + source.choice("+-0".replace(face[0][at], "")) + face[0][at + 1 :]


def _swapped(document: dict[str, Any], source: Random) -> None:
    first, second = source.sample(document["faces"], 2)
    first[1], second[1] = second[1], first[1]


def _other_planes(document: dict[str, Any], source: Random) -> None:
    row = source.choice(document["planes"]["planes"])
    row[:] = [to_text(-int(x)) for x in row]
    document["planes"]["offsets"] = [to_text(17 + int(b)) for b in document["planes"]["offsets"]]


def _malformed(document: dict[str, Any], source: Random) -> None:
    face = source.choice(document["faces"])
    bad = [0.5, "x", "1/0", "9" * 100_001, None, [], "1e99999"]
    face[source.choice([0, 1])] = source.choice([bad[3:4], source.choice(bad), [*face[1], "0"]])


def _short(document: dict[str, Any], source: Random) -> None:
    face = source.choice(document["faces"])
    face[0] = source.choice([face[0] + "+", face[0][1:]])


FORGERS: list[Forger] = [
    _repeated,
    _left_out,
    _wrong_sign,
    _swapped,
    _other_planes,
    _malformed,
    _short,
]


def check_forgeries(seed: str, number: int, folder: Path) -> None:
    said = answers(forgeries(seed, number), folder)
    assert len(said) == number
    assert [line for line in said if line.startswith("accepted")] == []
    assert {line.partition(":")[0] for line in said} == {"refused", "malformed"}


SLOW = pytest.mark.slow


@built
@pytest.mark.parametrize(
    ("seed", "number"), [("quick", 25), pytest.param("slow", 1000, marks=SLOW)]
)
def test_it_counts_what_engines_and_closed_forms_count(seed, number, tmp_path):
    check_agreement(seed, number, tmp_path)


@built
@pytest.mark.parametrize(("seed", "number"), [("quick", 35), pytest.param("slow", 500, marks=SLOW)])
def test_forged_certificates_are_refused(seed, number, tmp_path):
    check_forgeries(seed, number, tmp_path)


@built
def test_what_is_no_document_of_planes_is_malformed(tmp_path):
    good: dict[str, Any] = {"schema_version": 1, "planes": [["1", "0"], ["0", "1"]]}
    bad: list[Any] = [
        {"planes": [["1", "0"], ["1"]]},
        {"planes": [["0", "0"]]},
        {"planes": []},
        {"planes": [["0.5", 1.5]]},
        {"offsets": ["1"]},
        {"dimension": 3},
        {"planes": [], "dimension": 1001},
        {"planes": [], "dimension": -1},
        {"field": {}},
        {"schema_version": 2},
        *(b"[]", b"{", b"\xff"),
    ]
    assert_malformed(good, bad, "counted: 4 4 1", tmp_path, "--faces")


@built
def test_the_commands_name_the_speaker(run):
    proved = run("count reflection-b3 --verified")
    listed = run("count reflection-b3")
    assert proved == f"{listed}counted by       the verified program\n"
    assert run.json("count reflection-b3 --verified")["first_whitney_numbers"] == [1, -9, 23, -15]


@built
def test_a_list_is_certified_by_the_program():
    planes = Arrangement([[1, 0], [0, 1], [1, 1], [2, 2]], [0, 0, 1, 2])
    evidence = planes.certify_complete(proved=True)
    assert evidence
    assert evidence.theorem == (3, 9, 7)
    short = certify_complete(planes, planes.faces()[1:], proved=True)
    assert not short


@built
def test_types_are_counted_in_one_run(run, monkeypatch):
    assert run.json("list --classes 6 --verified")["proved"] == {"types": 17, "alike": 17}
    wrong = [(1, 26, 48, 24), *tables.proved_f_vectors(census.census(6)[1:])]
    monkeypatch.setattr(tables, "proved_f_vectors", lambda many: wrong)
    assert tables.compare_counts(6) == (17, 16)
    run("list --classes 6 --verified", code=1)


@built
@pytest.mark.slow
@pytest.mark.parametrize("planes", [7, 8, 9])
def test_types_are_counted_alike(planes):
    """All of up to eight planes, a part of those of nine, one of which is irrational."""
    types = len(census.census(planes))
    chosen = range(planes, types, 25) if planes == 9 else None
    found, alike = tables.compare_counts(planes, chosen)
    assert found == alike
    assert found >= types // 25


@built
@pytest.mark.slow
def test_families_have_the_numbers_in_print():
    """Of rational planes, as far as the budget allows; the rest is said to be out of reach."""
    counted, beyond = 0, 0
    for entry in published_counts():
        planes = entry.planes() if entry.regions < 10**6 else None
        if planes is None or planes.field is not None:
            beyond += 1
            continue
        assert sum(map(abs, proved_whitney_numbers(planes))) == entry.regions, entry.label
        counted += 1
    assert counted > beyond


def test_without_the_program_one_line_says_what_to_do(tmp_path, monkeypatch, refused):
    monkeypatch.setattr(proved.sys, "executable", str(tmp_path / "python"))
    monkeypatch.setenv("PATH", str(tmp_path))
    assert "run `make formal`" in refused("count reflection-b3 --verified")


@pytest.mark.parametrize(
    ("planes", "count", "faces", "error"),
    [
        (families.generic(60, 4), proved_f_vector, 547_761, 0),
        (families.resonance(6), proved_whitney_numbers, 1_066_044, 0.5),
        (families.braid(8), proved_f_vector, 545_835, 0.5),
    ],
    ids=["general", "resonance", "braid"],
)
def test_forecasts_follow_the_planes(planes, count, faces, error):
    with limit(1e-6), pytest.raises(OutOfReachError) as refused:
        count(planes)
    told = float(str(refused.value).split()[1].replace(",", ""))
    assert abs(told / faces - 1) <= error + 0.005


def test_irrational_or_large_input_refused_early():
    with pytest.raises(OutOfReachError, match="by the verified program"):
        proved_f_vector(Arrangement([[1, k, k * k, k**3, k**4, k**5] for k in range(200)]))
    with pytest.raises(InputError, match="rational ones"):
        proved_whitney_numbers(families.h3())
