"""The commands run and try: claims of the paper and of files, and printed tables."""

from __future__ import annotations

import argparse
import json
import shlex
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, NamedTuple

from arrangement.console import terminal, workers
from arrangement.console.progress import Bar, note, shown
from arrangement.console.safe_text import safe_lines
from arrangement.console.writing import make_folder, write_text_atomically
from arrangement.errors import InputError
from equilibrium.cli.colours import print_verdict
from proofs_check import claims
from proofs_check.course.printed_table import Row, check_table, value_text
from proofs_check.errors import OwnClaimError
from proofs_check.own_claims import claim_file, one_line, user_claim
from proofs_check.own_claims.quantities import MAPPINGS, TRUTH_VALUES
from proofs_check.own_claims.user_claim import DEFAULT_DOMAIN
from proofs_check.reports import forms, report, text
from proofs_check.statements.evidence import evaluate
from proofs_check.statements.statement import Claim, ClaimVerdict, Kind, Route, Strength

from .listing import width


class _Request(NamedTuple):
    """What a command line asks for: claims by id, or those of files with the numbers for them."""

    names: tuple[str, ...]
    seed: int
    samples: int | None
    classes: tuple[int, int] | None
    large: bool
    verified: bool
    own: Claim | None = None
    elsewhere: Claim | None = None  # the same statement on another domain

    @property
    def from_files(self) -> bool:
        """Whether claims of the user are meant."""
        return self.own is not None or any(claim_file.split(name)[0] for name in self.names)


def _request(names: Iterable[str], arguments: argparse.Namespace) -> _Request:
    options = (arguments.seed, arguments.samples, arguments.classes)
    large, verified = (getattr(arguments, option, False) for option in ("large", "verified"))
    return _Request(tuple(dict.fromkeys(names)), *options, large, verified)


def run_claims(arguments: argparse.Namespace) -> int:
    """Check claims of the paper by id, all claims of files, or numbers of printed tables."""
    own = [name for name in ("samples", "classes", "save") if getattr(arguments, name) is not None]
    tables = [name for name in arguments.ids if name == "-" or name.endswith(".csv")]
    request = _request(arguments.ids, arguments)
    if own and not request.from_files:
        raise OwnClaimError(
            f"--{own[0]} is for claims of FILE.py; those of the paper have fixed cases. Omit it, "
            "or write a file with `proofs-check new FILE.py`"
        )
    if not tables:
        return _run(request, arguments, arguments.jobs)
    if len(tables) < len(arguments.ids) or arguments.output:
        raise OwnClaimError(
            f"{tables[0]} is a table of printed numbers; check it alone, without claims and -o"
        )
    return max(_run_table(table, arguments.json) for table in tables)


def try_claim(arguments: argparse.Namespace) -> int:
    """Check a claim in one line; where no domain is named and it is refuted, on lines as well."""
    statement, when, of = arguments.statement, arguments.when, arguments.of
    nonzero: dict[str, bool] = {}
    claim = one_line.one_line_claim(statement, of=of or DEFAULT_DOMAIN, when=when, nonzero=nonzero)
    lines = None if of else one_line.one_line_claim(statement, of="lines", when=when)
    words = [statement, *(["--of", of] if of else []), *(["--when", when] if when else [])]
    code = _run(_request(words, arguments)._replace(own=claim, elsewhere=lines), arguments, 1)
    if code != terminal.NO:
        _note_constants(nonzero)
    return code


def _note_constants(nonzero: Mapping[str, bool]) -> None:
    """Report quantities of a statement that are 0 wherever it was tried, so that it says less."""
    affine = nonzero.get("affine", True)
    remedy = "" if affine else "; all are central: write --of lines, or --of 'affine(d=3)'"
    for name, is_nonzero in nonzero.items():
        if not is_nonzero and name not in ("affine", "central"):
            value = "false" if name in TRUTH_VALUES else "empty" if name in MAPPINGS else "0"
            note(f"{name} is {value} for every arrangement that was tried{remedy}")


def _run(request: _Request, arguments: argparse.Namespace, jobs: int) -> int:
    make = forms.form(Path(arguments.output).suffix) if arguments.output else None
    chosen = _claims_of(request)
    _check_ids(chosen, arguments.save)
    widths = text.columns(map(report.claim_record, chosen))
    results: list[dict[str, Any]] = []
    lost, unsaved = 0, list[InputError]()
    for result in _results(request, chosen, jobs, piped=arguments.json):
        if "error" in result:
            lost += 1
            if len(chosen) == 1:
                raise OwnClaimError(result["error"])
            _tell_lost(result)
            continue
        if request.elsewhere and result["verdict"] == ClaimVerdict.REFUTED.value:
            result["also_tried"] = [_elsewhere(request)]
        saved = _save(result, arguments.save, unsaved) if request.from_files else ""
        results.append(result)
        if not arguments.json:
            if request.from_files:
                entry = "\n" * (len(results) > 1) + text.details(result, width(), saved=saved)
            else:
                entry = text.entry(result, widths, width())
            print_verdict(entry, result["strength"] or "")
            sys.stdout.flush()
    record = report.json_record(results, request.seed, **_about(request))
    if arguments.json:
        terminal.print_json(record)
    elif not request.from_files:
        print("\n".join(["", *text.left_out(record), text.summary(record["results"])]))
    if make:
        write_text_atomically(arguments.output, make(record))
    if unsaved:
        raise unsaved[0]
    if lost:
        raise OwnClaimError(f"{lost} of {len(chosen)} claims have no verdict")
    return exit_code(record, strict=arguments.strict)


def _elsewhere(request: _Request) -> dict[str, Any]:
    """Return what is true of a statement on the other domain of a request, in short."""
    try:
        (claim,) = _own_claims(request._replace(own=request.elsewhere, elsewhere=None))
        result = report.result_record(evaluate(claim, request.seed))
    except OwnClaimError as error:
        domain = request.elsewhere.domain_text if request.elsewhere else ""
        return {"domain": domain, "verdict": None, "text": f"no verdict: {error}"}
    kept = ("domain", "verdict", "strength", "tried", "evidence", "counterexample")
    words, failure = text.conclusion(result), result["counterexample"]
    if failure:
        words += f" by {report.instance_text(failure['instance'])}: {failure['note']}"
    return {**{name: result[name] for name in kept}, "text": words}


def exit_code(record: Mapping[str, Any], *, strict: bool) -> int:
    """Return 0 if every verdict is the expected one, else 1; 3 where there is none, or too weak.

    Without a verdict nothing is refuted, and nothing confirmed.
    """
    if record["as_expected"] is not True:
        verdicts = {
            result["verdict"] for result in record["results"] if result["as_expected"] is not True
        }
        return terminal.UNDECIDED if verdicts == {None} else terminal.NO
    sampled = any(text.strength(result) is Strength.SAMPLED for result in record["results"])
    return terminal.UNDECIDED if strict and sampled else terminal.YES


def _tell_lost(result: dict[str, Any]) -> None:
    print(safe_lines(f"{result['id']}: no verdict: {result['error']}"), file=sys.stderr)


def file_record(name: str, arguments: argparse.Namespace) -> tuple[dict[str, Any], str]:
    """Check the claims of one file; return the record, and how many have no verdict, in words."""
    request = _request([name], arguments)
    results = list(_results(request, _claims_of(request), 1, piped=True))
    lost = [result for result in results if "error" in result]
    if len(lost) == len(results):
        raise OwnClaimError(lost[0]["error"])
    for result in lost:
        _tell_lost(result)
    kept = [result for result in results if "error" not in result]
    words = f"{len(lost)} of {len(results)} claims have no verdict" if lost else ""
    return report.json_record(kept, request.seed, **_about(request)), words


def _about(request: _Request) -> dict[str, Any]:
    """Return what a record says of its claims: title, source, and the command for the same run."""
    options = ["--seed", str(request.seed)] if request.seed else []
    options += ["--samples", str(request.samples)] if request.samples is not None else []
    options += ["--classes", "{}..{}".format(*request.classes)] if request.classes else []
    names = request.names
    options += [f"--{word}" for word in ("large", "verified") if getattr(request, word)]
    verb = "try" if request.own else "run"
    command = shlex.join(["proofs-check", verb, *names, *options])
    if request.own:
        return {"title": request.own.statement, "about": "a claim in one line", "command": command}
    if request.from_files:
        file = claim_file.split(names[0])[0] or ""
        title = claim_file.heading(file).rstrip(".") or Path(file).name
        return {"title": title, "about": ", ".join(names), "command": command}
    paper = claims.paper()
    every = not (request.names or request.large)
    left_out = [claim.id for claim in claims.registry() if every and claim.large]
    return {**paper, "command": command, "left_out": left_out}


def _results(
    request: _Request, chosen: list[Claim], jobs: int, *, piped: bool
) -> Iterator[dict[str, Any]]:
    """Yield the record of each result in order, with the progress taken off the terminal.

    Args:
        piped: whether progress is reported in a pipe too, where nothing is printed meanwhile.
    """
    bar = Bar(len(chosen), "claims", piped=piped)
    waiting: dict[int, dict[str, Any]] = {}
    done = 0

    def tick(cases: int) -> None:
        bar.update(done, f"{chosen[done].id}, {cases} cases")

    due = workers.part_numbers(len(chosen), (1, 1), jobs)
    jobs = min(jobs, len(chosen))
    numbered = (
        workers.on_processes(_result, request, due, jobs)
        if jobs > 1
        else ((k, _record(claim, request.seed, tick)) for k, claim in enumerate(chosen))
    )
    bar.update(done, chosen[done].id)
    try:
        for number, record in numbered:
            waiting[number] = record
            bar.update(done + len(waiting), f"{record['id']} is done")
            while done in waiting:
                bar.close()
                done += 1
                yield waiting.pop(done - 1)
    finally:
        bar.close()


def _result(request: _Request, number: int) -> tuple[int, dict[str, Any]]:
    """Check the claim with a number among those request for, in a process of its own."""
    return number, _record(_claims_of(request)[number], request.seed)


def _record(claim: Claim, seed: int, tick: Callable[[int], None] | None = None) -> dict[str, Any]:
    # The bar of the command counts cases; in a long one the loops inside report, in this process.
    with shown(tick is not None, notes=False):
        try:
            return report.result_record(evaluate(claim, seed, tick))
        except OwnClaimError as error:
            return {"id": claim.id, "error": str(error)}


def _claims_of(request: _Request) -> list[Claim]:
    """Return the claims of the paper with the given ids, or all claims of the given files."""
    if request.from_files:
        if request.verified:
            raise OwnClaimError("--verified is for the claims of the paper; omit it, or the files")
        return list(_own_claims(request))
    known = claims.registry()
    every = (claim for claim in known if request.large or not claim.large)
    chosen = [known[id] for id in request.names] or list(every)
    return list(map(_with_proved_route, chosen)) if request.verified else chosen


def _with_proved_route(claim: Claim) -> Claim:
    """Return the claim with the verified program as one more route, if it is about counts."""
    from arrangement.planes.planes import Planes
    from arrangement.planes.proved import proved_f_vector
    from proofs_check.routes.proved import COUNTS

    compute = COUNTS.get(claim.id)
    if compute is None:
        return claim
    proved_f_vector(Planes([[1]]))  # an error if it is not built
    return replace(claim, routes=(*claim.routes, Route("the program proved in Coq", compute)))


def _own_claims(request: _Request) -> Iterator[Claim]:
    """Yield the claims of files, with the numbers that the command line names."""
    names, samples, classes = request.names, request.samples, request.classes
    if not request.own and not all(claim_file.split(name)[0] for name in names):
        raise OwnClaimError("ids and files are both given; run the claims of files on their own")
    if samples is not None and samples < 0:
        raise OwnClaimError(f"--samples is {samples}; it must be at least 0")
    listed = (
        [request.own]
        if request.own
        else [c for name in names for c in claim_file.claims_named(name)]
    )
    files = {claim.file for claim in listed}
    several = Counter(Path(file).name for file in files)
    for claim in listed:
        name = Path(claim.file).name
        if several[name] > 1 and claim.locator == name:
            claim = replace(claim, locator=claim.file)
        changed = claim
        if samples is not None and claim.domain:
            changed = replace(claim, samples=samples)
        if classes is not None and claim.domain:
            others = [source for source in claim.sources if source.kind is not Kind.EXHAUSTIVE]
            types = user_claim.type_sources(claim.domain, *classes)
            changed = replace(changed, sources=(*types, *others))
        yield changed


def _check_ids(chosen: list[Claim], folder: str | None) -> None:
    """Refuse claims that would be saved to one file."""
    id, number = Counter(claim.id for claim in chosen).most_common(1)[0]
    if folder and number > 1:
        raise OwnClaimError(
            f"{number} claims have the id {id}; expected one, for --save writes a file for each "
            "id. Run their files one by one"
        )


def _save(result: dict[str, Any], folder: str | None, unsaved: list[InputError]) -> str:
    """Write the smallest failure as an instance file; return its path, or "" without one.

    Commands that read arrangements or grasps read the file. An older one of that name is replaced.

    Args:
        folder: None for no file.
        unsaved: gets the error of a file that cannot be written, for verdicts come first.
    """
    failure = result["counterexample"]
    if folder is None or failure is None or failure["instance"] is None:
        return ""
    reason = f"smallest instance found on which {result['id']} fails: {failure['note']}"
    content: dict[str, Any] = {**failure["instance"], "description": reason}
    target = Path(folder) / f"{result['id']}.json"
    try:
        make_folder(target.parent)
        write_text_atomically(target, json.dumps(content, indent=1) + "\n")
    except InputError as error:
        unsaved.append(error)
        return ""
    return str(target)


_WORDS = {True: "agree", False: "differ", None: "not computed"}


def _run_table(path: str, as_json: bool) -> int:
    """Print each row of a table with both values; exit 1 if two differ.

    Rows of one quantity that print different numbers are in conflict, computed or not.

    Args:
        path: of a CSV file, or "-" for standard input.

    Raises:
        InputError: some rows cannot be read; the others are printed before. Nothing is, if no row
            can be read.
    """
    total: Counter[str] = Counter()
    first: dict[tuple[str, str], Row] = {}
    unread: list[Row] = []  # of the beginning
    for row in check_table(path):
        if row.mistake and not first:
            unread.append(row)
            continue
        if not first:
            for entry in unread:
                _print(entry, "not read", as_json=as_json)
        verdict, other = "not read", row
        if not row.mistake:
            other = first.setdefault((row.arrangement, row.quantity), row)
            verdict = "conflict" if row.printed != other.printed else _WORDS[row.agrees]
        total[verdict] += 1
        note = f", line {other.line} prints {value_text(other.printed, row.quantity)}"
        _print(row, verdict, note if verdict == "conflict" else "", as_json=as_json)
    if unread and not first:
        raise InputError(f"line {unread[0].line} of {path}: {unread[0].mistake}")
    if unread:
        total["not read"] += len(unread)
    if not as_json:
        print(", ".join(f"{number} {verdict}" for verdict, number in total.items()))
    if total["not read"]:
        raise InputError(f"{total['not read']} of {total.total()} rows cannot be read")
    return terminal.NO if total["differ"] or total["conflict"] else terminal.YES


def _print(row: Row, verdict: str, note: str = "", *, as_json: bool) -> None:
    if as_json:
        terminal.print_json({**asdict(row), "verdict": verdict})
    else:
        print(f"{verdict:<12}  {_line(row)}{note}")


def _line(row: Row) -> str:
    if row.mistake:
        return f"line {row.line}: {row.mistake}"
    what = f"{row.arrangement}, {row.quantity}: printed {value_text(row.printed, row.quantity)}"
    if row.computed is None:
        return f"{what}, {row.reason}"
    hint = f" ({row.reason}; see relatively_bounded_regions)" if row.reason else ""
    return f"{what}, computed {value_text(row.computed, row.quantity)}{hint}"
