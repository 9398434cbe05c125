"""The report on a grasp as one HTML page: banner, picture, forces, margin, closure, assumptions.

The page has no script and asks for nothing from outside; the certificate is in it, to download.
"""

from __future__ import annotations

import base64
from collections.abc import Iterable, Sequence
from fractions import Fraction
from hashlib import sha256
from html import escape
from typing import NamedTuple

from arrangement.console.number_form import LABEL, counted
from arrangement.drawing.output import image
from arrangement.drawing.pages import BASE_STYLE, CARD_STYLE, Template, html_document
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.intervals import Interval
from equilibrium.decide.verdict import Verdict
from equilibrium.model.contact import joined
from equilibrium.model.displacement import STIFFNESS_ASSUMED, has_unit
from equilibrium.model.grasp import Grasp

from .notebook import verdict_svg, verdict_table
from .style import wrench_text
from .views import DRAWINGS

_STYLE: Template = ("equilibrium.pictures", "report.css")
#: Contacts in the table; more are only counted.
_MOST_CONTACTS = 60
#: Larger certificates are not in the page; in bytes.
_LARGEST_CERTIFICATE = 2_000_000
#: Width and height of the bar of factors, and its sides, in units of the picture.
_WIDTH, _HEIGHT, _SIDE = 360, 62, 24
_MODEL = (
    "The object is rigid. Each contact is a spring along its normal with Coulomb friction: its "
    "friction opposes the slip, and it detaches where its normal force would be negative.",
    "Displacements are small: forces act at the contacts where they were before the load.",
)


class _Banner(NamedTuple):
    """What stands on top: the class of its tone, a heading, a sign and the strength in words."""

    tone: str
    heading: str
    sign: str
    words: str


def report_page(
    grasp: Grasp,
    rows: Sequence[tuple[str, str]],
    verdict: Verdict | None = None,
    factors: Sequence[Interval] = (),
    remarks: Iterable[str] = (),
) -> str:
    """Return the page.

    Args:
        rows: title and text of what the command prints of the grasp and of the load.
        verdict: on the load, if there is one.
        factors: of the load with which it is resisted, in the plane.
        remarks: on the data, as they were read.
    """
    texts = dict(rows)
    banner = _banner(grasp, verdict)
    svg = DRAWINGS.of(grasp).svg(grasp, "grasp") if verdict is None else verdict_svg(verdict)
    wrench: RationalVector = () if verdict is None else verdict.wrench
    lead = "in the plane" if grasp.dimension == 2 else "in space"
    if wrench:
        lead = f"{wrench_text(wrench, grasp.units)}: {grasp.size_words}, {lead}"
    sections = [
        _figure(svg),
        _answer(verdict, texts, banner.tone),
        _card(
            "Margin: how far the load may grow, and which contacts give way",
            _margin(texts, factors),
        ),
        _card("Closure", _facts(texts, ("force closure", "form closure", "epsilon"))),
        _card("Contacts", _contacts(grasp, texts)),
        _card("Assumptions", _assumptions(grasp, verdict, texts, remarks)),
        _card("Certificate", _certificate(verdict)),
    ]
    chip = f'<p><span class="chip"><i>{banner.sign}</i> {escape(banner.words)}</span></p>'
    top = (
        f'<header class="top {banner.tone}"><p class="eyebrow">Grasp report</p>'
        f"<h1>{escape(banner.heading)}</h1>"
        f'<p class="lead">{escape(lead)}</p>'
        f"{'' if verdict is None else chip}</header>"
    )
    body = f"{top}\n<main>{''.join(sections)}</main>"
    return html_document("Grasp report", body, [BASE_STYLE, CARD_STYLE, _STYLE], [])


def _banner(grasp: Grasp, verdict: Verdict | None) -> _Banner:
    if verdict is None:
        return _Banner("all-cases", f"A grasp with {grasp.size_words}", "", "")
    if not verdict.decided:
        return _Banner("open", "Undecided", "?", "no equilibrium and no proof was found")
    if verdict.depends:
        words = "other data within the rounding error have another verdict"
        return _Banner("open", "Depends on the rounding", "?", words)
    held = verdict.stable
    heading = "The load is resisted" if held else "The load is not resisted"
    how = (
        "proved by an equilibrium"
        if held
        else "proved: no contact forces in the friction cones balance it"
    )
    if verdict.doubt:
        return _Banner("sampled", heading, "○", f"{how}, for the data as rounded")
    return _Banner("proved" if held else "refuted", heading, "✓" if held else "✗", how)


def _card(title: str, content: str, tone: str = "") -> str:
    """Return a section; empty where there is nothing to show."""
    if not content:
        return ""
    return f'<article class="{tone}"><h2>{escape(title)}</h2>{content}</article>\n'


def _figure(svg: str | None) -> str:
    if svg is None:
        text = "The picture needs matplotlib and shapely: pip install them, then make it again."
        return f'<p class="hint">{text}</p>'
    return f'<article class="picture"><figure>{image(svg, "the grasp")}</figure></article>\n'


def _answer(verdict: Verdict | None, texts: dict[str, str], tone: str) -> str:
    """Return the forces of equilibria, or the proof that there is none."""
    if verdict is None:
        return ""
    if verdict.decided and verdict.stable:
        return _card("Equilibrium", f'<div class="wide">{verdict_table(verdict)}</div>', tone)
    if not verdict.decided:
        return _card("Answer", _printed(texts["verdict"]), tone)
    why = (
        "The certificate cuts the motions into regions. In each, one virtual motion shows that no "
        "contact forces balance the load: the load does more work on it than the contacts absorb."
    )
    return _card("Proof", f"<p>{why}</p>{_printed(texts['verdict'])}", tone)


def _margin(texts: dict[str, str], factors: Sequence[Interval]) -> str:
    if "margin" not in texts:
        return ""
    bar = f"<figure>{_bar(factors)}</figure>"
    return bar + _facts(texts, ("margin", "least preload"))


def _bar(factors: Sequence[Interval]) -> str:
    """Return a ruler of factors, with those that are resisted, their ends, and the load at 1."""
    ends = [end for part in factors for end in part if end is not None]
    last = max([Fraction(3, 2), *(Fraction(5, 4) * end for end in ends)])

    def at(value: Fraction) -> float:
        return round(_SIDE + float(value / last) * (_WIDTH - 2 * _SIDE), 1)

    parts = [
        f'<line class="ruler" x1="{_SIDE}" x2="{_WIDTH - _SIDE}" y1="32" y2="32"/>',
    ]
    labels: dict[float, str] = {}
    for low, high in factors:
        start, end = at(low or Fraction(0)), at(last if high is None else high)
        width = max(round(end - start, 1), 2)
        parts.append(f'<rect class="held" x="{start}" y="26" width="{width}" height="12"/>')
        labels |= {at(x): LABEL.number(x) for x in (low, high) if x is not None}
        if high is None:
            labels[at(last)] = "∞"
    load = at(Fraction(1))
    parts.append(f'<path class="load" d="M{load} 40l-5 8h10z"/>')
    parts.append(f'<text x="{load}" y="59">1: the load</text>')
    left = -30.0
    for x, text in sorted(labels.items()):
        if x - left > 26:
            parts.append(f'<text x="{x}" y="18">{escape(text)}</text>')
            left = x
    name = "factors of the load that are resisted"
    size = f'viewBox="0 0 {_WIDTH} {_HEIGHT}"'
    return f'<svg class="factors" role="img" aria-label="{name}" {size}>{"".join(parts)}</svg>'


def _facts(texts: dict[str, str], names: Iterable[str]) -> str:
    lines = [
        f"<dt>{escape(name)}</dt><dd>{'<br>'.join(map(escape, texts[name].splitlines()))}</dd>"
        for name in names
        if name in texts
    ]
    return f"<dl>{''.join(lines)}</dl>" if lines else ""


def _contacts(grasp: Grasp, texts: dict[str, str]) -> str:
    """Return a table of contacts, those of a pad as one."""
    entries = [joined(points).to_dict() for points in grasp.parts[:_MOST_CONTACTS]]
    names = list(dict.fromkeys(name for entry in entries for name in entry if name != "share"))
    head = "".join(f"<th>{escape(name)}</th>" for name in ("", *names))
    rows = "".join(
        f"<tr><th>{i}</th>{''.join(f'<td>{_cell(entry.get(name))}</td>' for name in names)}</tr>"
        for i, entry in enumerate(entries, 1)
    )
    more = len(grasp.parts) - len(entries)
    note = f'<p class="hint">and {counted(more, "contact")} more</p>' if more else ""
    table = f'<div class="wide"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>'
    return f"{table}</div>{note}{_facts(texts, ('rank',))}" if entries else ""


def _cell(value: object) -> str:
    if isinstance(value, list):
        return f"({', '.join(escape(str(x)) for x in value)})"
    return "" if value is None else escape(str(value))


def _assumptions(
    grasp: Grasp, verdict: Verdict | None, texts: dict[str, str], remarks: Iterable[str]
) -> str:
    stated = [*_MODEL]
    if any(grasp.adhesion_wrench):
        stated.append("A contact with adhesion pulls with it besides, whatever the load.")
    stated.append(f"Units: {texts.get('units', 'not stated')}.")
    stated.append(
        f"Stiffness: {texts['stiffness']}." if has_unit(grasp) else f"{STIFFNESS_ASSUMED}."
    )
    if grasp.data_error is None:
        stated.append("All numbers are exact, as they were given, and so is every step.")
    else:
        stated.append("The data were rounded to exact numbers; from there on every step is exact.")
    if grasp.dimension == 3 and verdict is not None and verdict.pyramid is None:
        stated.append("Friction cones are round, not pyramids.")
    if verdict is not None:
        stated += verdict.warnings
    items = [text[0].upper() + text[1:] for text in (*stated, *remarks)]
    return f"<ul>{''.join(f'<li>{escape(text)}</li>' for text in items)}</ul>"


def _certificate(verdict: Verdict | None) -> str:
    """Return a link to download the proof, and how it is checked."""
    certificate = None if verdict is None else verdict.certificate
    if certificate is None:
        return ""
    data = certificate.text.encode("utf-8")
    check = '<span class="command"><code>equilibrium verify certificate.json</code></span>'
    about = (
        f"A document of {len(data):,} bytes that proves the verdict. A checker that shares no code "
        "with the solver verifies it:"
    )
    digest = f'<p class="hint">SHA-256 <code>{sha256(data).hexdigest()}</code></p>'
    if len(data) > _LARGEST_CERTIFICATE:
        link = "<p>It is too large for this page; the option --certificate of solve writes it.</p>"
    else:
        target = f"data:application/json;base64,{base64.b64encode(data).decode('ascii')}"
        link = f'<a class="button" download="certificate.json" href="{target}">certificate.json</a>'
    return f"<p>{about}</p><p>{check}</p><p>{link}</p>{digest}"


def _printed(text: str) -> str:
    """Return lines as they are printed, without what they say of options of a command."""
    lines = (line.partition("; --certificate")[0] for line in text.splitlines())
    return f"<pre>{escape(chr(10).join(lines))}</pre>"
