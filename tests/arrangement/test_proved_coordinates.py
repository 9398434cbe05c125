"""Signs without coordinates and graphs without weights, by the verified program if it is built."""

from __future__ import annotations

import itertools
import json
from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import pytest

from arrangement import ArrangementError, InputError
from arrangement.duals.inscribed.certificates import (
    Certificate,
    FarkasCertificate,
    WeightCertificate,
)
from arrangement.duals.inscribed.report import (
    conditions_document,
    decide,
    inscribability,
    proved_conditions,
)
from arrangement.library.census.catalogue import without_coordinates
from arrangement.library.census.final_polynomials import (
    OrderedProducts,
    final_document,
    proves_no_coordinates,
)
from arrangement.library.census.tables import check
from arrangement.library.families import generic
from arrangement.planes import proved

from .test_inscribed import KNOWN, polyhedral
from .test_proved import answers, assert_malformed, built


@built
def test_no_type_without_coordinates_is_left_out():
    assert check(0, order=False, proved=True).proofs == 274


def test_without_the_program_one_line_says_what_to_do(tmp_path, monkeypatch):
    monkeypatch.setattr(proved.sys, "executable", str(tmp_path / "python"))
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(InputError, match="run `make formal`"):
        check(0, order=False, proved=True)


Case = tuple[list[int], list[OrderedProducts]]
proved_types = cache(without_coordinates)


def forged(signs: list[int], proof: list[OrderedProducts], source: Random) -> Case:
    """Change a proof, or the signs that it is about, in one place."""
    k = source.randrange(len(proof))
    row = proof[k]
    pick = source.randrange(8)
    if pick == 0:
        at = source.randrange(len(signs))
        signs = [*signs[:at], source.choice([-1, 0, 1]), *signs[at + 1 :]]
    elif pick == 1:
        row = row._replace(times=row.times + source.choice([-1, 1, 10**40]))
    elif pick == 2:
        row = row._replace(times=-row.times)
    elif pick == 3:
        row = row._replace(smaller=source.randrange(3), larger=source.randrange(3))
    elif pick == 4:
        relation = list(row.relation)
        relation[source.randrange(5)] = source.randrange(9)
        a, b, c, d, e = relation
        row = row._replace(relation=(a, b, c, d, e))
    elif pick == 5:
        a, b, c, d, e = source.sample(row.relation, 5)
        row = row._replace(relation=(a, b, c, d, e))
    # The same products, by a strict comparison a negative number of times, or by an equation.
    parts = [row._replace(times=row.times + 3), row._replace(times=-3)] if pick == 7 else [row]
    middle = [] if pick == 6 else parts
    return signs, [*proof[:k], *middle, *proof[k + 1 :]]


def valid(source: Random) -> Case:
    """Return a proof of signs of nine elements, its comparisons in some other order or split."""
    signs, rows = source.choice(proved_types())
    proof = [row._replace(times=row.times * 6) for row in rows]
    k = source.randrange(len(proof))
    part = source.randrange(proof[k].times + 1) if proof[k].times > 0 else proof[k].times
    proof.append(proof[k]._replace(times=proof[k].times - part))
    proof[k] = proof[k]._replace(times=part)
    source.shuffle(proof)
    return signs.tolist(), proof


@built
def test_forged_proofs_are_refused_and_both_checkers_agree(tmp_path):
    source = Random("forged")
    cases = [valid(source) for _ in range(60)]
    cases += [forged(*valid(source), source) for _ in range(600)]
    names = list(itertools.combinations(range(9), 3))
    ours = [
        proves_no_coordinates(dict(zip(names, signs, strict=True)), proof) for signs, proof in cases
    ]
    said = answers([final_document(*case) for case in cases], tmp_path)
    words = {True: "accepted: no coordinates", False: "refused: no coordinates"}
    assert said == [words[answer] for answer in ours]
    assert all(ours[:60])
    # A sign that the proof does not use, or a relation in other words, changes nothing.
    assert 400 < ours.count(False) < 600


@built
def test_the_signs_are_read_as_python_numbers_them(tmp_path):
    signs, proof = proved_types()[0]
    (line,) = answers([final_document(signs.tolist(), proof)], tmp_path, "--question")
    wanted = zip(itertools.combinations(range(9), 3), signs.tolist(), strict=True)
    assert json.loads(line)["signs"] == [[*map(str, names), str(sign)] for names, sign in wanted]


@built
def test_what_is_no_such_proof_is_malformed(tmp_path):
    good = final_document(*valid(Random(0)))
    row = good["proof"][0]
    rows = [
        row[:-1],
        [*row, 0],
        [9, *row[1:]],
        [-1, *row[1:]],
        [*row[:5], 3, 1, 1],
        [*row[:7], "1"],
    ]
    changes: list[dict[str, Any]] = [
        *({"elements": n} for n in (8, 10, -1, 101, "9", 10**30)),
        *({"signs": text} for text in ("", good["signs"] + "0", "x" + good["signs"][1:], 3)),
        *({"proof": [bad]} for bad in (*rows, None)),
        {"proof": {}},
        {"certificate": "resisted"},
        {"schema_version": 2},
        {"planes": []},
        {"other": 1},
    ]
    assert_malformed(good, changes, "accepted: no coordinates", tmp_path)


def refutations() -> list[Certificate]:
    known = [polyhedral(graph) for graph, inscribable in KNOWN.values() if not inscribable]
    return [*map(decide, known), *(inscribability(generic(m)).certificate for m in (4, 5, 6))]


def with_other_multipliers(refutation: FarkasCertificate, source: Random) -> FarkasCertificate:
    """Change one multiplier, one side of a cutset, or leave one cutset out."""
    vertices, cuts = list(refutation.vertex_multipliers), list(refutation.cuts)
    lower, upper = dict(refutation.lower_multipliers), dict(refutation.upper_multipliers)
    edge, step = source.choice(refutation.graph.edges), source.choice([-1, 1, Fraction(1, 10**30)])
    pick = source.choice(["vertex", "lower", "upper", "both", *["side", "factor", "none"] * 2])
    if pick == "vertex" or (pick in ("side", "factor", "none") and not cuts):
        vertices[source.randrange(len(vertices))] += step
    elif pick in ("lower", "upper", "both"):
        for bounds in [lower] * (pick != "upper") + [upper] * (pick != "lower"):
            bounds[edge] = bounds.get(edge, Fraction(0)) + step
    else:
        side, factor = cuts.pop(source.randrange(len(cuts)))
        if pick == "side":
            cuts.append((side ^ {source.randrange(len(vertices))}, factor))
        elif pick == "factor":
            cuts.append((side, factor + step))
    return FarkasCertificate(refutation.graph, tuple(vertices), lower, upper, tuple(cuts))


def holds(refutation: Certificate) -> bool:
    try:
        refutation.verify()
    except ArrangementError:
        return False
    return True


@built
def test_forged_multipliers_are_refused_and_both_checkers_agree(tmp_path):
    source, found = Random("multipliers"), refutations()
    assert all(map(proved_conditions, found))
    given = [refutation for refutation in found if isinstance(refutation, FarkasCertificate)]
    assert any(refutation.cuts for refutation in given)
    forged = [with_other_multipliers(source.choice(given), source) for _ in range(400)]
    said = answers(map(conditions_document, forged), tmp_path)
    words = {True: "accepted: no weights", False: "refused: no weights"}
    assert said == [words[holds(refutation)] for refutation in forged]
    # A larger multiplier of both bounds of an edge changes the constant alone.
    assert said.count(words[False]) > 300


@built
def test_the_graph_is_read_as_it_is(tmp_path):
    certificate = refutations()[0]
    (line,) = answers([conditions_document(certificate)], tmp_path, "--question")
    graph = certificate.graph
    edges = list(map(list, graph.edges))
    assert json.loads(line) == {"vertices": graph.vertex_count, "edges": edges}


@built
def test_other_forms_of_multipliers_are_malformed(tmp_path):
    good = conditions_document(refutations()[-2])
    changes: list[dict[str, Any]] = [
        *({"edges": [row]} for row in ([0, 1, "0"], [0, 99, "0", "0"], [0, 1, 0.5, "0"], None)),
        *({"cutsets": [row]} for row in ([[0, 1]], [[0, 99], "1"], [["0"], "1"], [[0], "x"])),
        {"vertices": []},
        {"certificate": "no coordinates"},
        {"schema_version": 2},
        {"other": 1},
    ]
    assert_malformed(good, changes, "accepted: no weights", tmp_path)
    inscribability(generic(5)).verify(proved=True)


def with_other_weights(certificate: WeightCertificate, source: Random) -> WeightCertificate:
    """Change weights: of one edge, or by turns along a closed walk, which keeps all sums."""
    graph = certificate.graph
    weights = dict(zip(graph.edges, certificate.weights, strict=True))
    step = Fraction(source.choice([-1, 1]) * source.randrange(1, 8), source.choice([16, 24, 10**9]))
    if source.random() < 0.2:
        weights[source.choice(graph.edges)] += step
    else:
        walk = [source.randrange(graph.vertex_count)]
        while len(walk) < 2 or walk[-1] != walk[0] or len(walk) % 2 == 0:
            walk = [*walk, source.choice(graph.neighbours[walk[-1]])][-400:]
        for i, (u, v) in enumerate(itertools.pairwise(walk)):
            weights[min(u, v), max(u, v)] += step * (-1) ** i
    return WeightCertificate(graph, tuple(weights.values()))


@built
def test_light_cutset_refused_by_both_checkers(tmp_path):
    source = Random("weights")
    known = [polyhedral(graph) for graph, inscribable in KNOWN.values() if inscribable]
    found = [decide(graph) for graph in known]
    assert all(map(proved_conditions, found))
    assert proved_conditions(inscribability(generic(3)).certificate)
    given = [certificate for certificate in found if isinstance(certificate, WeightCertificate)]
    changed = [with_other_weights(source.choice(given), source) for _ in range(300)]
    prism = next(graph for graph in known if (graph.vertex_count, len(graph.edges)) == (6, 9))
    # The triangles of a prism: each sum is 1, and the cutset between them weighs 3 - 6 w.
    edges = [(w, 1 - 2 * w) for w in (Fraction(1, 3), Fraction(3, 10), Fraction(2, 5))]
    for w, across in edges:
        in_triangle = [len({*prism.neighbours[u]} & {*prism.neighbours[v]}) for u, v in prism.edges]
        changed.append(WeightCertificate(prism, tuple(w if k else across for k in in_triangle)))
    said = answers(map(conditions_document, changed), tmp_path)
    words = {True: "accepted: weights", False: "refused: weights"}
    assert said == [words[holds(certificate)] for certificate in changed]
    assert 50 < said.count(words[True]) < 250
    assert said[-3:] == [words[False], words[True], words[False]]
    bad: list[dict[str, Any]] = [
        *({"vertices": n} for n in (1, -1, 1001, "6")),
        *({"edges": [row]} for row in ([0, 1], [0, 99, "1/3"], [0, 1, 0.5], None)),
        {"cutsets": []},
        {"schema_version": 2},
    ]
    assert_malformed(conditions_document(changed[-2]), bad, words[True], tmp_path)
