"""Sign vectors as bits in words: what is packed comes back, and equal rows are found."""

from random import Random

import numpy as np
import pytest

from arrangement.numbers import budget, packing


def rows_of_bits(seed: int, columns: int, rows: int = 40) -> np.ndarray:
    """Rows that differ in one place at most from a few others, so that many are equal."""
    random = Random(seed)
    few = [[random.random() < 0.5 for _ in range(columns)] for _ in range(4)]
    found = [list(random.choice(few)) for _ in range(rows)]
    for row in found[::3]:
        place = random.randrange(columns)
        row[place] = not row[place]
    return np.array(found, bool).reshape(rows, columns)


@pytest.mark.parametrize("columns", [1, 8, 63, 64, 65, 128, 130])
def test_bits_are_those_of_the_words(columns):
    bits = rows_of_bits(columns, columns)
    words = packing.pack(bits)
    assert words.shape == (len(bits), -(-columns // 64))
    numbers = [sum(int(w) << 64 * k for k, w in enumerate(row)) for row in words]
    assert numbers == [sum(1 << k for k in np.flatnonzero(row).tolist()) for row in bits]
    assert (packing.unpack(words, columns) == bits).all()
    assert (packing.pack(bits.reshape(2, -1, columns)) == words.reshape(2, -1, len(words[0]))).all()


def test_words_have_room_for_a_number_of_classes():
    bits = rows_of_bits(0, 3)
    assert [packing.pack(bits, n).shape[1] for n in (1, 64, 65, 129)] == [1, 1, 2, 3]
    assert packing.pack(np.zeros((2, 0), bool)).tolist() == [[0], [0]]
    assert (packing.unpack(packing.pack(bits, 129), 129)[:, :3] == bits).all()
    assert not packing.unpack(packing.pack(bits, 129), 129)[:, 3:].any()


def test_unit_words_have_one_bit_each():
    assert (packing.unpack(packing.unit_words(70), 70) == np.eye(70)).all()


@pytest.mark.parametrize("columns", [5, 70, 200])
@pytest.mark.parametrize("keys", ["mixed", "alike", "few"])
def test_equal_rows_are_neighbours_whatever_the_keys(columns, keys, monkeypatch):
    """Different rows with one key are told apart, also where equal ones stand between them."""
    if keys != "mixed":
        bits = np.uint64(0 if keys == "alike" else 3)
        monkeypatch.setattr(packing, "_keys", lambda rows: rows[:, 0] & bits)
    if keys != "mixed" and columns < 64:
        pytest.skip("one word is its own key")
    for seed in range(5):
        words = packing.pack(rows_of_bits(seed, columns))
        order, new = packing.group_rows(words)
        assert sorted(order) == list(range(len(words)))
        listed = [tuple(row) for row in words[order].tolist()]
        groups = np.cumsum(new)
        assert new[0]
        assert len({*zip(listed, groups, strict=True)}) == len({*listed}) == groups[-1]
        chosen = packing.distinct_rows(words)
        assert sorted(map(tuple, words[chosen].tolist())) == sorted({*listed})


def test_nothing_has_no_groups():
    order, new = packing.group_rows(np.zeros((0, 2), np.uint64))
    assert order.shape == new.shape == (0,)


def test_chunks_cover_everything_once():
    for total in range(8):
        for size in range(1, 9):
            parts = [range(total)[piece] for piece in budget.chunks(total, size)]
            assert [x for part in parts for x in part] == list(range(total))
            assert all(0 < len(part) <= size for part in parts)
            assert [(p.start, p.stop) for p in budget.chunks(total, size)] == [
                (part.start, part.stop) for part in parts
            ]
