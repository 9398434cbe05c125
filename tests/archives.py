"""Damaged NPZ archives: other headers, flags, versions and compressions, and changed bytes."""

import io
import struct
import zipfile
from collections.abc import Iterator
from random import Random

#: What takes the place of the header of an array.
HEADERS = [
    b"((((",
    b"-" * 5000 + b"1",
    b"{'descr': '<f8', 'fortran_order': False, 'shape': (True, 3), }",
    b"{'descr': '<f8', 'fortran_order': False, 'shape': (-1, 3), }",
    b"{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999, 3), }",
    b"{'descr': '|O', 'fortran_order': False, 'shape': (2,), }",
    b"{'descr': '<M8[s]', 'fortran_order': False, 'shape': (2, 3, 2), }",
    b"",
]
#: Of the headers of a file in an archive: their marks, and where version, flags, method stand.
_PLACES = ((b"PK\x03\x04", (4, 6, 8)), (b"PK\x01\x02", (6, 8, 10)))


def with_header(archive: bytes, name: str, header: bytes, method: int) -> bytes:
    """Return an archive whose array of a name has another header; its checksums are right."""
    made = io.BytesIO()
    with (
        zipfile.ZipFile(io.BytesIO(archive)) as old,
        zipfile.ZipFile(made, "w", method) as new,
    ):
        for one in old.namelist():
            content = old.read(one)
            if one == name:
                (length,) = struct.unpack("<H", content[8:10])
                line = header + b"\n"
                content = content[:8] + struct.pack("<H", len(line)) + line + content[10 + length :]
            new.writestr(one, content)
    return made.getvalue()


def with_field(archive: bytes, field: int, value: int) -> bytes:
    """Return an archive with another version (field 0), flags (1) or compression (2)."""
    found = bytearray(archive)
    for mark, places in _PLACES:
        at = found.find(mark)
        while at >= 0:
            struct.pack_into("<H", found, at + places[field], value)
            at = found.find(mark, at + 1)
    return bytes(found)


def mutants(archive: bytes, count: int, seed: int) -> Iterator[bytes]:
    """Yield damaged archives: first one of each kind, then random ones."""
    source = Random(seed)
    names = zipfile.ZipFile(io.BytesIO(archive)).namelist()
    yield from (with_header(archive, names[0], header, 8) for header in HEADERS)
    yield from (with_field(archive, *change) for change in ((1, 1), (0, 99), (2, 93), (2, 12)))
    for number in range(count):
        changed = bytearray(archive)
        if number % 4 == 0:
            header, method = source.choice(HEADERS), source.choice((0, 8, 12, 14))
            changed = bytearray(with_header(archive, source.choice(names), header, method))
        elif number % 4 == 1:
            start = source.randrange(1, len(changed))
            del changed[start : start + source.randint(1, 40)]
        for _ in range(source.randint(1, 4)):
            changed[source.randrange(len(changed))] = source.randrange(256)
        yield bytes(changed)
