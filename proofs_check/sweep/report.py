"""What the store of a sweep says: a record with the keys of every other result, and its state.

The record has no times and nothing that depends on the order of the work, so that a sweep that was
interrupted, or done in parts, has the same report, to the byte, as one that was not.
"""

from __future__ import annotations

from typing import Any

from arrangement.library.census import MOST_PLANES
from proofs_check.reports.report import conclusion, instance_text, record_of
from proofs_check.statements.evidence import strength_from, verdict_from
from proofs_check.statements.statement import ClaimVerdict, Kind, range_text

from .store import Plan, Store
from .sweep import EACH, Total, total


def consistent(verdict: ClaimVerdict | None, expected: ClaimVerdict) -> bool:
    """Return whether a verdict on samples is compatible with the expected one.

    Samples can miss the instances that refute a statement or need its saving hypothesis, so
    "no counterexample found" contradicts nothing. A counterexample contradicts an expected "holds".
    """
    if verdict is None:
        return False
    order = (ClaimVerdict.HOLDS, ClaimVerdict.HOLDS_UNDER_HYPOTHESIS, ClaimVerdict.REFUTED)
    return order.index(verdict) <= order.index(expected)


def record(opened: Store) -> dict[str, Any]:
    """Return the JSON record of a sweep, complete or not."""
    plan, claim, sums = opened.plan, opened.claim, total(opened.chunks())
    verdict = verdict_from(sums.outcomes)
    expected = ClaimVerdict(claim["record"]["expected"])
    worst = next((k for k in ("broken", "fails", "excused") if k in sums.smallest), None)
    complete = sums.chunks == plan.chunks
    kind = Kind.EXHAUSTIVE if plan.types and complete else Kind.SAMPLED
    needed = verdict is ClaimVerdict.HOLDS_UNDER_HYPOTHESIS
    result = {
        **claim["record"],
        "evidence_kind": kind.value,
        "over": _over(plan, claim),
        "domain": _over(plan, claim),
        "verdict": verdict.value if verdict else None,
        **conclusion(
            strength_from(verdict, kind),
            sums.outcomes["holds"],
            [claim["record"]["saving_hypothesis"]] if needed else [],
        ),
        "as_expected": consistent(verdict, expected),
        "complete": complete,
        "evidence": _evidence(plan, claim, sums, verdict),
        "rows": False,
        "seed": plan.seed,
        "plan": plan.record(),
        "records": [],
        "table": _table(claim["unit"], sums),
        "counterexample": _entry(worst, sums.smallest[worst]) if worst else None,
    }
    return record_of([result], plan.seed, sums.environments)


def _over(plan: Plan, claim: dict[str, Any]) -> str:
    numbers = range_text(plan.low, plan.high)
    if plan.types:
        return f"all isomorphism classes of {numbers} distinct planes of rank 3"
    return f"random {claim['domain']} with {numbers} {claim['unit']}"


def _evidence(plan: Plan, claim: dict[str, Any], sums: Total, verdict: ClaimVerdict | None) -> str:
    names = {
        "holds": "that hold",
        "fails": "that fail",
        "excused": "that fail outside the hypothesis",
        "broken": "broken",
        "outside": "outside the hypothesis",
    }
    numbers = [f"{n} {names[kind]}" for kind, n in sums.outcomes.items() if n]
    done = (
        str(plan.samples) if sums.samples == plan.samples else f"{sums.samples} of {plan.samples}"
    )
    over = _over(plan, claim) if plan.types else f"samples: {_over(plan, claim)}, seed {plan.seed}"
    parts = [f"{done} {over}: {', '.join(numbers)}"]
    if plan.types and plan.high == MOST_PLANES and "many_types" in claim:
        parts.append(
            f"those of {MOST_PLANES} planes by {claim['many_types']}, "
            f"one in {EACH} by both routes too"
        )
    expected = ClaimVerdict(claim["record"]["expected"])
    if verdict is not None and verdict is not expected and consistent(verdict, expected):
        saving = claim["record"].get("saving_hypothesis")
        needs = f"it needs the hypothesis {saving}" if saving else "it needs a hypothesis"
        refuted = expected is ClaimVerdict.REFUTED
        parts.append(f"on other instances {'it is refuted' if refuted else needs}")
    for kind, text in (
        ("broken", "smallest broken instance"),
        ("fails", "smallest failure"),
        ("excused", "smallest failure outside the hypothesis"),
    ):
        if kind in sums.smallest:
            entry = sums.smallest[kind]
            where = f"sample {entry['index']}, {instance_text(entry['instance'])}"
            parts.append(f"{text}: {where}" + (f": {entry['note']}" if entry["note"] else ""))
    return "; ".join(parts)


def _table(unit: str, sums: Total) -> dict[str, Any]:
    columns = [unit, "hold", "fail", "fail outside the hypothesis", "broken", "outside"]
    return {"columns": columns, "rows": [[m, *row] for m, row in sums.counts.items()]}


def _entry(kind: str, entry: dict[str, Any]) -> dict[str, Any]:
    return {
        "label": f"sample {entry['index']}",
        "values": entry["values"],
        "holds": False,
        "covered": kind != "excused",
        "note": entry["note"],
        "assumption": "",
        "instance": entry["instance"],
    }


def status(opened: Store) -> dict[str, Any]:
    """Return how far a sweep is, also while it runs."""
    plan, sums = opened.plan, total(opened.chunks())
    return {
        "claim": plan.claim,
        "plan": plan.record(),
        "chunks": sums.chunks,
        "chunks_due": plan.chunks,
        "samples": sums.samples,
        "samples_due": plan.samples,
        "complete": sums.chunks == plan.chunks,
        "outcomes": sums.outcomes,
        "milliseconds": sums.milliseconds,
        "environments": sums.environments,
    }
