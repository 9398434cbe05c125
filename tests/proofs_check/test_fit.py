"""What a sequence of values is: fits are exact and meet values that were not used."""

from fractions import Fraction
from math import comb
from pathlib import Path

import pytest
import sympy

from proofs_check.own_claims.fit import LEAST_CHECKED, MOST_PERIOD, fit

N = sympy.Symbol("n")


def value(found, n):
    return sympy.sympify(found.parts[n % found.period]).subs(N, n)


SEQUENCES = {
    "constant": (lambda n: 7, 1, 0),
    "regions of lines": (lambda n: comb(n, 2) + n + 1, 1, 2),
    "quarter squares": (lambda n: n * n // 4, 2, 2),
    "thirds": (lambda n: Fraction(n, 3) + n % 3, 3, 1),
    "binomial": (lambda n: comb(n, 4), 1, 4),
    "period 6": (lambda n: (5, 0, -2, 9, 9, 1)[n % 6], 6, 0),
}


@pytest.mark.parametrize("name", SEQUENCES)
@pytest.mark.parametrize("start", [-3, 0, 5])
def test_a_fit_is_the_sequence_and_goes_on_as_it(name, start):
    term, period, degree = SEQUENCES[name]
    start = max(start, 0) if name in ("binomial", "regions of lines") else start
    known = {n: term(n) for n in range(start, start + 14)}
    found = fit(known)
    assert (found.period, found.degree) == (period, degree)
    assert {*found.fitted} | {*found.checked} == {*known}
    assert not {*found.fitted} & {*found.checked}
    assert len(found.fitted) == period * (degree + 1)
    assert all(value(found, n) == sympy.Rational(str(term(n))) for n in range(start, start + 40))


@pytest.mark.parametrize("wrong", range(9))
def test_one_wrong_value_among_those_not_used_is_no_fit(wrong):
    known = {n: n * n - n + 2 for n in range(9)}
    assert fit(known).checked == (3, 4, 5, 6, 7, 8)
    known[wrong] += 1
    assert fit(known) is None


def test_a_fit_leaves_values_to_check_it():
    assert LEAST_CHECKED == 2
    assert fit({n: n**3 for n in range(5)}) is None
    assert fit({n: n**3 for n in range(6)}).checked == (4, 5)
    assert fit({1: 3, 2: 3}) is None
    assert fit({n: n % MOST_PERIOD for n in range(2 * MOST_PERIOD - 1)}) is None
    assert fit({n: n % MOST_PERIOD for n in range(2 * MOST_PERIOD)}).period == MOST_PERIOD
    assert fit({n: n % (MOST_PERIOD + 1) for n in range(4 * MOST_PERIOD)}) is None
    assert fit({n: 2**n for n in range(12)}) is None
    assert fit({}) is None


def test_gaps_and_order_of_the_parameter_do_not_matter():
    places = (11, 2, 5, 3, 30, 7)
    assert fit({n: n * n + 1 for n in sorted(places)}).parts == {0: "n**2 + 1"}


@pytest.mark.parametrize(
    ("quantity", "of", "code", "words"),
    [
        ("regions", "generic(m=2..8)", 0, "fits    m**2 - m + 2 on m = 2..4, checked on 5..8"),
        ("f_vector[1]", "generic(m=3..8)", 0, "fits    m**2 - m on m = 3..5, checked on 6..8"),
        ("rank + n", "braid(n=2..6)", 0, "2*n - 1 on n = 2, 3, checked on 4..6"),
        ("m", "braid(n=2..9)", 0, "n*(n - 1)/2 on n = 2..4"),
        ("regions", "shi(n=2..6)", 1, "no polynomial"),
        ("regions / 2", "shi(type=B3, m=1..7)", 0, "(6*m + 1)**3/2 on m = 1..4, checked on 5..7"),
    ],
)
def test_the_command_says_what_fits_and_what_was_not_used(quantity, of, code, words, run):
    text = " ".join(run("fit {} --of", quantity, of, code=code).split())
    assert " ".join(words.split()) in text
    assert ("proved no" in text) == (code == 0)
    record = run.json("fit {} --of", quantity, of, code=code)
    assert (record["fit"] is None) == bool(code)
    assert record["family"] == of
    if record["fit"]:
        used = record["fit"]["fitted_on"] + record["fit"]["checked_on"]
        assert sorted(used) == [n for n, _ in record["values"]]


FILE = """
from proofs_check import claim, family

def listed(planes): return planes.f_vector[3]
def formula(planes, m): return m * m - m + 2 + (m == 8) * {fault}

@claim("s", of="generic(m=2..8)", routes=[listed, formula])
def regions(planes, value):
    return True

@claim("s", of="simple", samples=2)
def other(planes):
    return True
"""


def test_the_values_of_a_claim_are_fitted_where_its_routes_agree(
    tmp_path, monkeypatch, run, refused
):
    monkeypatch.chdir(tmp_path)
    Path("mine.py").write_text(FILE.replace("{fault}", "0"), encoding="utf-8")
    assert "m**2 - m + 2 on m = 2..4" in run("fit mine.py:regions")
    for name, words in (("mine.py:other", "one parameter"), ("mine.py", "one claim")):
        assert words in refused("fit", name)
    Path("mine.py").write_text(FILE.replace("{fault}", "1"), encoding="utf-8")
    assert "the implementations disagree" in refused("fit mine.py:regions")
