"""Verdicts on random grasps in space, ours beside a mixed-integer program and a cone program.

    run.py --only space                      3, 4, 6, 8 and 12 contacts
    run.py --only space --contacts 3,4       fewer
    run.py --only space --grasps 12          12 grasps of each size and kind

Where a peer's verdict is not ours it is wrong: ours counts only with a proof that the checker
accepted. The instances and the peers are those of `spacejob.py`.
"""

import statistics
from collections.abc import Iterable, Sequence

from grasps import VERDICTS, Found, kilobytes, run, shown, spread
from spacejob import EDGES, FINE, NEAR, PEER_SECONDS

from tests.equilibrium.rare import KINDS

#: By number of contacts: grasps of each kind, for us and for the peers.
COUNT = {3: 100, 4: 100, 6: 60, 8: 40, 12: 20}
PEER = {3: 24, 4: 24, 6: 12}
SIZES = tuple(COUNT)
LIMIT = 1800
#: Questions of each kind that is not in general position.
KIND_COUNT = 100


def space_tables(contacts: Sequence[int], count: int = 0) -> None:
    found: dict[tuple[int, int], list[Found]] = {}
    for added, where in ((0, "any wrench"), (NEAR, "near the boundary")):
        print(f"\nGrasps in space, {where}: medians of CPU time (largest)", flush=True)
        print(
            f"{'m':>4} {'verdict':<14} {'grasps':>6} {'verdict, proof':>20} {'check':>18}"
            f" {'proof':>20} {'leaves':>12}"
        )
        for m in contacts:
            found[added, m] = _own_lines(m, _seeds(added, count or COUNT.get(m, 12)))
    print("\nQuestions not in general position, by kind", flush=True)
    for kind in KINDS:
        _own_lines(kind, range(count or KIND_COUNT))
    print("\nOther programs on the same grasps; wrong: not what is proved", flush=True)
    for (added, m), mine in found.items():
        seeds = _seeds(added, min(count or 100, PEER.get(m, 0)))
        where = "near" if added else "any"
        for job, name in (
            ("boxed", f"mixed-integer, {EDGES} edges"),
            ("boxed_fine", f"mixed-integer, {FINE} edges"),
            ("cones", "second-order cones alone"),
        ):
            if seeds and (job != "boxed_fine" or m <= 4):
                listed = run(job, m, seeds, LIMIT, "spacejob.py")
                _against(f"{name}, m = {m}, {where}", mine, listed)


def _seeds(added: int, count: int) -> Sequence[int]:
    return range(added, added + count)


def _own_lines(m: int | str, seeds: Iterable[int]) -> list[Found]:
    """Measure ours, print a line for each verdict and one for all; return what was found."""
    listed = run("ours", m, seeds, LIMIT, "spacejob.py")
    for verdict in (*VERDICTS.values(), "undecided", "all"):
        chosen = [one for one in listed if verdict in ("all", one["verdict"])]
        if chosen:
            proved = [one for one in chosen if "check" in one]
            cells = [spread(chosen, "seconds", shown), spread(proved, "check", shown)]
            cells += [spread(proved, "bytes", kilobytes), spread(proved, "leaves", str)]
            print(
                f"{m:>4} {verdict:<14} {len(chosen):>6} {cells[0]:>20} {cells[1]:>18}"
                f" {cells[2]:>20} {cells[3]:>12}",
                flush=True,
            )
    for one in listed:
        if one["verdict"] == "undecided":
            print(f"  undecided: seed {one['seed']}: {one['reason']}")
    if bad := [one["seed"] for one in listed if not one.get("valid", True)]:
        print(f"  REFUSED: the proofs of seeds {bad}")
    return listed


def _against(name: str, mine: list[Found], other: list[Found]) -> None:
    """Print a peer's times beside ours, and the seeds of its wrong verdicts."""
    proved = {one["seed"]: one for one in mine if one.get("valid")}
    pairs = [(proved[one["seed"]], one) for one in other if one["seed"] in proved]
    if not pairs:
        return
    theirs, ours = ([pair[k]["seconds"] for pair in pairs] for k in (1, 0))
    wrong: dict[str, list[int]] = {verdict: [] for verdict in VERDICTS.values()}
    for one, peer in pairs:
        if peer["verdict"] != one["verdict"] and peer["verdict"] in wrong:
            wrong[peer["verdict"]].append(one["seed"])
    silent = sum(peer["verdict"] not in wrong for _, peer in pairs)
    print(
        f"  {name:<42} {len(pairs):>3} {shown(statistics.median(theirs)):>9}"
        f" ({shown(max(theirs)):>8}), ours {shown(statistics.median(ours)):>8}"
        f"  accepts wrongly {len(wrong['resisted'])}, refuses wrongly {len(wrong['not resisted'])}"
        + (f", none within {PEER_SECONDS} s {silent}" if silent else ""),
        flush=True,
    )
    for verdict, seeds in wrong.items():
        if seeds:
            print(f"    says {verdict}, and is wrong: seeds {', '.join(map(str, seeds))}")
