"""What a sweep is to do: which claim, on which instances, in which chunks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

#: Instances in a chunk, unless another number is given.
CHUNK = 200
#: Most samples of one sweep.
MOST = 10**9


@dataclass(frozen=True)
class Plan:
    """What a sweep is to do. Equal plans give equal results.

    Attributes:
        claim: its id.
        digest: SHA-256 of the file of an own claim, "" for the registry.
        low, high: smallest and largest number of planes (or contacts).
        samples: number of instances.
        seed: of all of them.
        chunk: instances in one chunk.
        types: the instances are all types of the census, not random ones.
        source: the name under which the claim is found here: ID, or FILE.py:ID.
    """

    claim: str
    digest: str
    low: int
    high: int
    samples: int
    seed: int
    chunk: int = CHUNK
    types: bool = False
    source: str = field(default="", compare=False)

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return -(-self.samples // self.chunk)

    def indices(self, number: int) -> range:
        """Return the numbers of the instances of one chunk."""
        start = number * self.chunk
        return range(start, min(start + self.chunk, self.samples))

    def record(self) -> dict[str, Any]:
        """Return the plan for JSON; where the claim is found is not part of it."""
        entries = asdict(self)
        del entries["source"]
        if not self.types:
            del entries["types"]
        return entries

    @classmethod
    def from_record(cls, record: Mapping[str, Any]) -> Plan:
        """Return the plan that has a record.

        Raises:
            TypeError, ValueError: no plan has it.
        """
        plan = cls(**record)
        if not all(isinstance(getattr(plan, name), str) for name in ("claim", "digest")):
            raise ValueError("its plan names no claim")
        numbers = (plan.samples, plan.chunk, plan.low, plan.high, plan.seed)
        if not all(type(n) is int for n in numbers) or min(numbers[:2]) < 1:
            raise ValueError("its plan has no number of samples")
        return plan
