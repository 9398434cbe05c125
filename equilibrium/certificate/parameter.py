"""The checker of certificates for all values of a parameter in an interval.

The law and the rule of leaves are those of one question: `law_problem`, and `walk` with
`leaf_rule`. They add, multiply and compare; here their numbers are rational functions of the letter
(`arrangement.numbers.functions`), of which a comparison has an answer if it is the same all over
the interval. Then the check takes the same decisions at every value, and what it finds holds at
each. If one comparison has more answers, the certificate is refused, although its verdict may hold.

``{"schema_version": 4, "certificate": ..., "parameter": {"letter": "t", "from": "2/3", "to": "1"},
"grasp": ..., "wrench": ..., "motion": ..., "forces": ...}``, or "tree" for the last two; or
"assembly" with its wrenches, in place of "grasp". Numbers of the question, of motion and forces and
of leaves may be expressions in the letter; of an angle they are those of ``u = tan(t / 2)``, and so
are the ends of the interval, see `equilibrium.model.parameter`. "without" lists ends that do not
belong to the interval: "from", "to".
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import rational, shown, to_text
from arrangement.numbers.expressions import read_expression
from arrangement.numbers.functions import Domain, Function, Span, Undecided
from equilibrium.model.assembly import SIZE
from equilibrium.model.errors import CertificateError
from equilibrium.model.parameter import ParametricQuestion

from .assemblies import part_report
from .law import LawRow, law_problem, law_rows, lifted_rows
from .leaf_rule import TreeQuestion
from .reading import FORMS, KEYS, STATES, TreeForm, check_version, read_equilibrium
from .report import Report
from .tree import tree_report


@dataclass(frozen=True, repr=False)
class ParameterReport(Report):
    """What a check of a certificate for all values of a parameter found.

    Attributes:
        family: the questions that it is about.
        span: the values of the letter, of an angle those of the tangent of its half.
    """

    family: ParametricQuestion | None = None
    span: Span = field(default_factory=lambda: Span(Fraction(0), Fraction(0)))

    def asked(self, question: Any, *_: Any) -> ParameterReport:
        """Return what this says of questions with a letter; of a single one it says nothing."""
        if question is None:
            return self
        problem = "it is about all values of a parameter, not about one question"
        if isinstance(question, ParametricQuestion):
            problem = self._difference(question)
        return replace(self, problem=self.problem or problem, compared=True)

    def _difference(self, wanted: ParametricQuestion) -> str:
        """Return in what its questions differ from others for its values, or nothing."""
        assert self.family is not None
        if (self.family.letter, self.family.is_angle) != (wanted.letter, wanted.is_angle):
            return "its parameter is another one"
        if self.family.names != wanted.names:
            return "it is about other bodies"
        domain = Domain(self.span, letter=wanted.letter)
        try:
            if function_rows(self.family, domain) != function_rows(wanted, domain):
                return "its contacts differ"
            if self.family.load(domain) != wanted.load(domain):
                return "its wrench differs"
        except Undecided:
            return "its numbers differ for some values"
        return ""

    @property
    def to_compare(self) -> str:
        """How the command compares what it is about with a question."""
        return "not compared with a question: give --grasp FILE, or compare the expressions above"

    @property
    def question(self) -> list[str]:
        """What it is about, in lines: the values, the wrench and each contact."""
        assert self.family is not None
        document = self.family.document
        of = f"tan({self.family.letter} / 2)" if self.family.is_angle else self.family.letter
        lines = [f"all {of} in {self.span}"]
        if "wrench" in document or "bodies" not in document:
            lines.append(f"wrench {_words(document.get('wrench', '0'))}")
        else:
            lines += [f"body {_words(body)}" for body in document["bodies"]]
        for i, entry in enumerate(document["contacts"], 1):
            pairs = (f"{key} {_words(x)}" for key, x in entry.items())
            lines.append(f"contact {i}: {', '.join(pairs)}")
        return lines

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        assert self.family is not None
        return {
            "valid": bool(self),
            "certificate": self.kind,
            "leaves": self.leaves,
            **({"problem": self.problem} if self.problem else {}),
            "parameter": parameter_entry(self.family.letter, self.span),
            **question_entry(self.family),
            "compared": self.compared,
        }


def _words(value: Any) -> str:
    if isinstance(value, Mapping):
        return ", ".join(f"{key} {_words(x)}" for key, x in value.items())
    return f"({', '.join(map(str, value))})" if isinstance(value, list) else str(value)


def check_parameter(document: Mapping[str, Any]) -> ParameterReport:
    """Check a certificate for all values of a parameter.

    Raises:
        InputError: this is not such a certificate, whatever its numbers are.
    """
    kind = check_version(document)
    about = "assembly" if "assembly" in document else "grasp"
    common = ("schema_version", "certificate", "parameter", about)
    check_keys(document, (*common, *KEYS[kind]), ("wrench",), "the certificate")
    letter, span = read_parameter(document["parameter"])
    known = {"wrench": document["wrench"]} if "wrench" in document else {}
    question = check_keys(document[about], (), document[about], about)
    family = ParametricQuestion({**question, **known}, letter)
    # The readers of grasps and assemblies find what is no question.
    family.at((span.low + span.high) / 2)
    leaves, problem = parameter_problem(family, span, document)
    return ParameterReport(kind, problem, leaves, family=family, span=span)


def parameter_problem(
    family: ParametricQuestion, span: Span, proof: Mapping[str, Any]
) -> tuple[int, str]:
    """Return the number of leaves of a proof, and what is wrong with it, or nothing.

    Args:
        proof: "motion" and "forces", or "tree".
    """
    try:
        return decided_problem(family, Domain(span, letter=family.letter), proof)
    except Undecided as undecided:
        return 0, f"a comparison has no one answer: {undecided}"


def decided_problem(
    family: ParametricQuestion, domain: Domain, proof: Mapping[str, Any]
) -> tuple[int, str]:
    """Return what `parameter_problem` does.

    Args:
        domain: where comparisons have to have one answer; with a value they narrow it.

    Raises:
        Undecided: a comparison has different answers on the interval.
        InputError: the proof has no readable form.
    """
    rows, load = function_rows(family, domain), family.load(domain)
    known: dict[str, Any] = {}

    def read(value: Any, name: str) -> Any:
        """Return a number or an expression of the proof; most are there more than once."""
        if not isinstance(value, str):
            return rational(value, name)
        if value not in known:
            expression = read_expression(value, family.letter, name)
            try:
                known[value] = expression.value(Function.letter(domain))
            except ZeroDivisionError:
                raise CertificateError(f"{name} is {shown(value)}, which divides by zero") from None
        return known[value]

    form = form_of(family, read)
    if "tree" not in proof:
        motion, forces = read_equilibrium(proof, len(rows), form)
        return 0, law_problem(rows, load, motion, forces)
    tree, names = proof["tree"], family.names
    if names is not None and isinstance(tree, Mapping) and "part" in tree:
        contacts = family.contacts(domain)
        loads = {name: load[SIZE * k : SIZE * (k + 1)] for k, name in enumerate(names)}
        own = law_rows(contacts)  # type: ignore[arg-type]
        planar = FORMS[2]._replace(read=read)
        report = part_report(tree, [c.bodies for c in contacts], own, loads, planar)
    else:
        report = tree_report(tree, TreeQuestion(rows, load, form))
    return report.leaves, report.problem


def form_of(family: ParametricQuestion, read: Any) -> TreeForm:
    """Return the form of proofs about a question, with numbers that are read by a function."""
    if family.names is None:
        return FORMS[2]._replace(read=read)
    return TreeForm(SIZE * len(family.names), 1, tuple(STATES), family.names, read)


def function_rows(family: ParametricQuestion, domain: Domain) -> list[LawRow]:
    """Return the rows of the law, in functions of the letter."""
    contacts = family.contacts(domain)
    rows = law_rows(contacts)  # type: ignore[arg-type]
    if family.names is None:
        return rows
    return lifted_rows(rows, [contact.bodies for contact in contacts], family.names)


def parameter_entry(letter: str, span: Span) -> dict[str, Any]:
    """Return the JSON form of a letter and its values."""
    without = [end for end, has in (("from", span.has_low), ("to", span.has_high)) if not has]
    entry: dict[str, Any] = {"letter": letter, "from": to_text(span.low), "to": to_text(span.high)}
    return {**entry, "without": without} if without else entry


def read_parameter(entry: Any) -> tuple[str, Span]:
    """Return the letter and its values.

    Raises:
        CertificateError: this is no interval.
    """
    check_keys(entry, ("letter", "from", "to"), ("without",), "parameter")
    low, high = (rational(entry[key], f"parameter.{key}") for key in ("from", "to"))
    without = check_list(entry.get("without", []), "parameter.without")
    if not all(end in ("from", "to") for end in without) or len({*without}) < len(without):
        ends = shown(without)
        raise CertificateError(f'parameter.without is {ends}; expected "from", "to" or both')
    span = Span(low, high, "from" not in without, "to" not in without)
    if low > high or (low == high and without):
        raise CertificateError(f"the interval {span} has no values; expected from below to")
    return entry["letter"], span


def question_entry(family: ParametricQuestion) -> dict[str, Any]:
    """Return the question of a certificate: grasp or assembly, and the wrench."""
    document = dict(family.document)
    wrench = {"wrench": document.pop("wrench")} if "wrench" in document else {}
    return {"grasp" if family.names is None else "assembly": document, **wrench}
