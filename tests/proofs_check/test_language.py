"""The language of claims in one line: what is read, and what is refused before it is computed."""

import pytest

from arrangement.library.families import generic, near_pencil
from proofs_check.errors import OwnClaimError
from proofs_check.own_claims.language import read, read_statement
from proofs_check.own_claims.one_line import value_of

SIX = near_pencil(6)  # f = (1, 12, 30, 20), t = {2: 5, 5: 1}
LINES = generic(4, 2, affine=True)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "regions == 14 or 12 or 16",
            "'12' .* a number; .* Did you mean regions in .14, 12, 16",
        ),
        ("regions == 1 or 7", "Did you mean regions in .1, 7.?"),
        ("regions != 1 and 7", "Did you mean regions not in .1, 7.?"),
        ("m > 3 and f_vector", "is a vector; expected a truth value .* Compare it"),
        ("not m", "'m' in 'not m' is a number; expected a truth value"),
        ("m implies simple", "'m' in 'm implies simple' is a number; expected a truth value"),
        ("simple implies (m^2 implies V)", r"'m\^2' in 'm\^2 implies V' is a number"),
        ("implies(m,V) or simple", r"'m' in 'implies\(m,V\)' is a number"),
        ("m > 2 and [m, 2^m] == m", r"'\[m, 2\^m\] == m' compares a vector with a number"),
        ("m", "'m' is a number; expected a comparison"),
        ("simple == 1", "compares a truth value with a number"),
        ("m + simple > 3", "'simple' in 'm . simple' is a truth value; expected a number"),
        ("f_vector >= 3", "compares a vector with a number"),
        ("p_vector >= t_vector", "orders mappings; expected == or !="),
        ("simple > central", "orders truth values"),
        ("sum(p_vector) == m", r"write sum\(p_vector.values\(\)\) or sum\(p_vector.keys\(\)\)"),
        ("max(t_vector) == m", r"write max\(t_vector.values\(\)\)"),
        ("max(f_vector, polynomial) > m", "is a vector; expected a number"),
        ("sum(m) == 3", "is of a number; expected a vector"),
        ("sum(f_vector, 2) == 3", "has 2 arguments; expected 1"),
        ("3 in p_vector", "looks for a number in a mapping"),
        ("f_vector.get(1, 0) > 2", "asks a vector for keys"),
        ("m[1] > 2", "is a number; it has no .index"),
        ("-" * 400 + "m < 0", "402 operations inside each other; expected at most 250"),
        ("(" * 240 + "m" + ")" * 240 + " > 0", "cannot be read"),
        ("m if simple else 3", "not in the language"),
        ("regions <= 1 + m(m-1)/2", r"'m.m-1.' calls m, a number; write m\*\(...\)"),
        ("f_vector(0) > 3", r"calls f_vector, a vector; write f_vector\[index\]"),
        ("regions <= 2m", r"has a product without its sign, '2m', .* write such as 2\*m"),
        ("regions <= m\u00b2", r"a raised or lowered number, '.', .* write such as m\*\*2"),
        ("if simple then m > 2", "has a condition, 'if', .* such as m >= 4 implies regions"),
        ("regions <= m**2 for m >= 4", "a condition, 'for', .* with --when 'm >= 4'"),
        ("number of regions > 2", "words for a quantity, 'number of', .* such as regions, V, E"),
        ("regions are at most m**2", r"words for symbols; write 'regions <= m\*\*2'"),
        ("the number of regions is at most 2^m", r"; write 'regions <= 2\^m'"),
        ("every arrangement has at least m triangles.", r"write 'p_vector.get\(3, 0\) >= m'"),
        ("a generic arrangement has exactly 2*E edges", "; write 'simple implies E == 2\\*E'"),
        ("there are fewer than m**2 vertices", r"; write 'V < m\*\*2'"),
        ("every line is at most what", "cannot be read; write a comparison such as regions"),
        ("faces - edges = 2", "'faces' is not a quantity; write F.*; 'edges' is not .*; write E$"),
        ("regions <= m!", r"has a factorial, 'm!', .* write such as factorial\(m\)"),
        ("regions <=", r"cannot be read; write a comparison such as regions <= m\*\*2"),
        ("vertices > 3", "'vertices' is not a quantity; write V"),
        ("unbounded_regions > 3", r"; write \(regions - bounded_regions\)$"),
        ("binom(m, 2) > 3", "'binom' is not a function; write binomial"),
        ("number_of_regions > 3", "is not a quantity; write regions$"),
        ("V_count > 3", "is not a quantity; write V$"),
        ("regions is even", "is not a quantity; write regions % 2 == 0"),
        ("region > 3", "did you mean regions"),
        ("simpel or m > 3", "did you mean simple"),
        ("maximum(m, 2) > 3", "did you mean max"),
        ("facess > 3", "did you mean faces. Write F, or f_vector"),
        ("nfaces > 3", "did you mean faces. Write F, or f_vector"),
        ("vertexes > 3", "did you mean vertices. Write V"),
        ("regionss > 3", "did you mean regions"),
        ("REGIONS > 3", "did you mean regions"),
        ("v > 3", "did you mean V.? "),
        ("f0 > 3", r"write f_vector\[0\]"),
        ("Chi(1) > 3", r"did you mean chi\(t\)"),
    ],
)
def test_what_has_no_one_meaning_is_refused(text, message):
    with pytest.raises(OwnClaimError, match=message):
        read_statement(text)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("regions <= m^2 - m + 2", True),
        ("regions ≤ m^2 - m + 2 and regions ≥ m and regions ≠ m", True),
        ("V - E + F = 2", True),
        ("2^3^2 == 512 and -m^2 == 0 - 36", True),
        ("binomial(m, 2) == comb(m, 2) == 15", True),
        ("factorial(4)", 24),
        ("n", 6),
        ("V - E + F", 2),
        ("(V, E, F) == (12, 30, 20)", True),
        # Floor division rounds down, of negative numbers and of fractions too.
        ("(7 // 2, (-7) // 2, 7 // (-2), m / 4 // 1, -m / 4 // 1)", (3, -4, -4, 1, -2)),
        ("(7 % 4, (-7) % 4, 7 / 2 * 2, m - 8, 2 + 3 * 4)", (3, 1, 7, -2, 14)),
        ("(max(2, m, 3), min(7, m, 9), abs(2 - m), len(f_vector))", (6, 6, 4, 4)),
        ("m < 7 and not m < 6 and m <= 6 and not m <= 5", True),
        ("m > 5 and not m > 6 and m >= 6 and not m >= 7", True),
        ("m == 6 and not m == 7 and m != 7 and not m != 6", True),
        ("simple implies m == 9", True),
        ("m == 6 implies m == 9", False),
        ("m == 6 implies (m == 9 implies m == 3)", True),
        ("(m == 6 implies m == 9) implies m == 3", True),
        ("not (m == 6 implies V == 12) or simple", False),
        ("implies(m == 6, V == 12) and E in (30, 31)", True),
        ("m not in (3, 4) and 5 in t_vector.keys()", True),
        # Vectors are ordered entry by entry, not lexicographically.
        ("f_vector >= (0, 999, 999, 999)", False),
        ("f_vector >= (1, 12, 30, 20) and f_vector <= (1, 12, 30, 21)", True),
        ("not f_vector > (0, 11, 29, 20)", True),
        ("f_vector == (1, 2) or f_vector != (1, 2)", True),
        ("sum(t_vector.values())", 6),
    ],
)
def test_values(text, value):
    assert value_of(read(text), SIX, {}) == value


def test_letters_count_what_divides_the_sphere_or_the_plane():
    assert value_of(read("(V, E, F)"), LINES, {}) == (6, 16, 11)
    with pytest.raises(OwnClaimError, match="V, E and F are of lines in the plane"):
        value_of(read("V"), generic(4, 3, affine=True), {})


def test_order_of_vectors_of_different_lengths_is_refused():
    with pytest.raises(OwnClaimError, match=r"with 4 and 2 entries; expected equal numbers"):
        value_of(read("f_vector >= (1, 2)"), SIX, {})


def test_deepest_texts_are_computed():
    assert value_of(read("-" * 240 + "m"), SIX, {}) == 6
    assert value_of(read("+".join(["m"] * 240)), SIX, {}) == 1440
