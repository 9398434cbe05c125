"""Families, generators and pseudolines as domains of claims."""

import re
from itertools import combinations
from pathlib import Path
from random import Random

import pytest

from arrangement import Arrangement, counts
from arrangement.library import families
from arrangement.library.census import census
from proofs_check import ClaimVerdict, claim, evaluate, family
from proofs_check.errors import OwnClaimError
from proofs_check.instances.domains import DOMAINS, domain
from proofs_check.instances.families import read_family
from proofs_check.instances.pseudolines import Pseudolines, not_stretchable, type_sources, types
from proofs_check.own_claims.shrink import shrink

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize(
    ("text", "made"),
    [
        ("catalan(n=2..4)", family("catalan", n=range(2, 5))),
        ("random-integer( m=3..5 , seed=0,1 )", family("random_integer", m=[3, 4, 5], seed=[0, 1])),
        ("generic(m=3,5, affine=true)", family("generic", m=(3, 5), affine=True)),
        ("generic(m=3,5, affine)", family("generic", m=(3, 5), affine=True)),
        ("generic(m=3,5, affine=False)", family("generic", m=(3, 5), affine=False)),
        ("linial(type=B2,A3)", family("linial", type=["B2", "A3"])),
        ("graphical(graph=1-2,2-3)", family("graphical", graph="1-2,2-3")),
        ("h3", family("h3")),
    ],
)  # fmt: skip
def test_a_family_as_text_is_that_of_python(text, made):
    read = read_family(text)
    assert str(read) == str(made) == str(read_family(str(made)))
    assert [case.label for case in read.cases()] == [case.label for case in made.cases()]
    assert [x.subject.planes for x in read.cases()] == [x.subject.planes for x in made.cases()]
    assert len([*read.cases()]) == len(read)


def test_members_are_those_of_the_library():
    for case, n in zip(family("catalan", n=range(2, 5)).cases(), range(2, 5), strict=True):
        assert case.subject.planes == families.catalan(n)
        assert case.document == families.catalan(n).to_dict()
    seeds = [case.subject.planes for case in family("random-integer", m=4, seed=range(5)).cases()]
    assert len({planes.integer_planes for planes in seeds}) == 5
    assert seeds[3] == families.random_integer(4, seed=3)


def test_a_first_argument_may_have_the_name_of_a_parameter():
    found = []

    def of_planes(planes):
        found.append(len(planes))
        return True

    own = claim("?", of=family("simplicial", planes=[9, 13], number=1))(of_planes)
    assert evaluate(own).verdict is ClaimVerdict.HOLDS
    assert found[:2] == [9, 13]


def test_functions_of_a_claim_take_the_parameters_that_they_name():
    def formula(_planes, n):
        return (n + 1) ** (n - 1)

    def counted(planes):
        return counts.region_count(planes)

    @claim("s", of="shi(n=2..4)", routes=[formula, counted], when=lambda planes, n: n != 3)
    def shi(planes, value, n):
        return planes.dimension == n and value == (n + 1) ** (n - 1)

    result = evaluate(shi)
    assert result.verdict is ClaimVerdict.HOLDS
    (part,) = result.evidence.parts
    assert (part.checked, part.passed_over, part.foreign) == (2, 1, 0)
    assert [record.values for record in result.evidence.records] == [(3, 3), (125, 125)]


def test_a_claim_in_one_line_names_the_parameters_of_a_family(tmp_path, monkeypatch, run, refused):
    monkeypatch.chdir(tmp_path)
    for statement, code in (
        ("regions == (n + 1)**(n - 1)", 0),
        ("abs(chi(1)) == (n - 1)**(n - 1) and bounded_regions == 0", 0),
        ("regions == chi(-1)", 1),
    ):
        found = run.json("try {} --of shi(n=2..5)", statement, code=code)["results"][0]
        assert found["over"] == "shi(n=2..5), 4 members"
        assert found["evidence_kind"] == "all cases"
    assert found["counterexample"]["label"] == "shi(n=3)"
    assert "is false: 16 and -16" in found["evidence"]
    assert "did you mean" not in (message := refused("try {} --of shi(n=2..5)", "regions == k"))
    assert "'k' is not a quantity; expected one of m (planes), rank" in message


def test_pseudolines_of_a_type_are_counted_as_its_planes_are():
    for n in range(3, 7):
        for planes, case in zip(census(n), types([n]), strict=True):
            lines = case.subject
            assert dict(lines.chirotope) == dict(counts.chirotope(planes))
            assert len(lines.distinct) == len(lines) == len(planes)
            for name in ("rank", "dimension", "is_central", "is_simple", "is_simplicial"):
                assert getattr(lines, name) == getattr(planes, name)
            assert lines.f_vector == planes.faces().f_vector
            assert lines.p_vector == planes.p_vector
            assert lines.t_vector == dict(counts.t_vector(planes))
            assert lines.whitney_numbers == counts.first_whitney_numbers(planes)
            assert {*lines.regions()} == {region.signs for region in planes.regions()}
            for k in range(n) if n > 3 else ():
                rows = [row for j, row in enumerate(planes.normals) if j != k]
                rest, left = Arrangement(rows), lines.without(k)
                assert (left is None) == (rest.rank < 3)
                assert left is None or dict(left.chirotope) == dict(counts.chirotope(rest))


def test_nonstretchable_types_are_oriented_matroids():
    found = not_stretchable()
    assert len({lines.signs for lines in found}) == len(found) == 274
    assert sum(lines.is_simple for lines in found) == 1  # Ringel's
    for lines in found[::9]:
        _, vertices, edges, regions = lines.f_vector
        assert vertices - edges + regions == 2
        assert regions == sum(map(abs, lines.whitney_numbers)) == sum(lines.p_vector.values())
        assert not lines.stretchable
        for a, b, c, d, e in combinations(range(9), 5):  # Grassmann-Pluecker relations
            chi = lines.chirotope
            terms = {
                chi[a, b, c] * chi[a, d, e],
                -chi[a, b, d] * chi[a, c, e],
                chi[a, b, e] * chi[a, c, d],
            }
            assert terms == {0} or {1, -1} <= terms


def test_a_claim_on_pseudolines_meets_those_that_no_lines_have():
    @claim("s", of="pseudolines", classes=5, samples=20, expected="refuted")
    def lines_have_it(lines):
        return lines.stretchable

    result = evaluate(lines_have_it)
    assert result.verdict is ClaimVerdict.REFUTED
    every, special, samples = result.evidence.parts
    assert (every.checked, every.failures) == (7, 0)
    assert (special.checked, special.failures) == (274, 274)
    assert samples.checked == 20
    assert result.evidence.counterexample.document["pseudolines"] == 9
    assert "that lines have" in type_sources(3, 9)[0].over


def test_a_failure_on_pseudolines_is_made_small():
    lines = next(iter(not_stretchable()))
    small, _ = shrink(lines, lambda lines: sum(lines.p_vector.values()) > 20)
    assert len(small) == 5  # four have at most 14 regions
    assert all(
        left is None or sum(left.p_vector.values()) <= 20 for left in map(small.without, range(6))
    )


def test_samples_of_pseudolines_are_types(refused):
    drawn = [DOMAINS["pseudolines"].draw(Random(seed), 5) for seed in range(30)]
    assert {lines.signs for lines in drawn} == {case.subject.signs for case in types([5])}
    assert isinstance(DOMAINS["pseudolines"].draw(Random(0), 9), Pseudolines)
    with pytest.raises(OwnClaimError, match="at most 9"):
        claim("s", of="pseudolines", planes=(3, 10))
    error = refused("try {} --of pseudolines --classes 3..10", "m > 2")
    assert "expected numbers of pseudolines from 3 to 9" in error


def test_out_of_domain_distinct_from_out_of_hypotheses():
    @claim("s", of="simple", when=lambda p: len(p) > 4, classes=5, families=False, samples=0)
    def simple(planes):
        return planes.is_simple

    result = evaluate(simple)
    (part,) = result.evidence.parts
    assert (part.checked, part.foreign, part.passed_over) == (1, 4, 2)


def test_an_unknown_domain_lists_those_of_the_documentation(refused):
    text = (ROOT / "docs" / "checking.rst").read_text(encoding="utf-8")
    table = text.partition("Domains, named in")[2].partition("\n\nInstead of")[0]
    rows = re.findall(r"^   \* - (.*)$", table, re.MULTILINE)
    documented = {name for row in rows for name in re.findall(r"`([\w()=-]+)`", row)}
    error = refused("try {} --of simpel", "m > 0")
    assert "did you mean simple?" in error
    listed = re.search(r"there are ([\w, ()=-]+), and families such as catalan", error)
    assert listed is not None
    assert {*listed[1].split(", ")} == documented
    assert all(domain(name) for name in documented - {"dual"})
