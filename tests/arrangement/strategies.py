"""Random arrangements for property tests: small entries, so that degenerate ones are common."""

from typing import Any

from hypothesis import strategies as st

from arrangement import Arrangement

SMALL = st.integers(-2, 2)
RATIONALS = st.fractions(-3, 3, max_denominator=4)


@st.composite
def arrangements(
    draw: st.DrawFn,
    *,
    dimensions: tuple[int, int] = (1, 4),
    planes: tuple[int, int] = (0, 6),
    central: bool | None = None,
) -> Arrangement:
    """Draw an arrangement with entries in {-2..2}: any rank, coincident planes included."""
    d = draw(st.integers(*dimensions))
    m = draw(st.integers(*planes))
    normal = st.lists(SMALL, min_size=d, max_size=d).filter(any)
    normals = draw(st.lists(normal, min_size=m, max_size=m))
    if central is None:
        central = draw(st.booleans())
    offsets = None if central else draw(st.lists(SMALL, min_size=m, max_size=m))
    return Arrangement(normals, offsets, dimension=d)


def product(left: list[list[Any]], right: list[list[Any]]) -> list[list[Any]]:
    """Return the product of two matrices."""
    columns = list(zip(*right, strict=True))
    return [
        [sum(a * b for a, b in zip(row, column, strict=True)) for column in columns] for row in left
    ]
