"""What of a lesson stands on its slides, and what is said beside them.

Definitions (paragraphs with a word in bold), theorems, proofs, formulas, code, pictures, lists and
tables stand on slides as they are, and so does the introduction. Of other paragraphs the first
sentence does, and the last one too where a formula or code completes it; the whole is among the
notes. The lab that a lesson links is on a slide of its own, below what is said of it.
"""

import re
from itertools import takewhile

from docutils import nodes

#: Lines of code on one slide.
_LINES = 14
_STATEMENT = re.compile(r"(?m)^(?=>>> |\$ )")
_LAB = re.compile(r"\.\./pages/[\w-]*lab\.html#")
_CODE = (nodes.literal_block, nodes.doctest_block)
#: What stays with the paragraph above it; a formula is raw here.
_SHOWN = (*_CODE, nodes.raw)


def title(section):
    """Return the title of a section."""
    return section.next_node(nodes.title).astext()


def sentences(paragraph):
    """Return the sentences of a paragraph, each a list of nodes."""
    found = [[]]
    for node in paragraph.children:
        if not isinstance(node, nodes.Text):
            found[-1].append(node.deepcopy())
            continue
        first, *others = re.split(r"(?<=[.?!])\s+", node.astext())
        found[-1].append(nodes.Text(first))
        found += [[nodes.Text(text)] for text in others]
    return [one for one in found if "".join(node.astext() for node in one).strip()]


def is_picture(node):
    """Return whether a node is a picture, which is raw here."""
    return isinstance(node, nodes.raw) and "formula" not in node


def ends(node):
    """Return whether a node ends a sentence, which else goes on in a formula or in code."""
    if not isinstance(node, (nodes.paragraph, nodes.raw)) or any(map(is_picture, node.children)):
        return True
    return bool(re.search(r"[.?!∎]\W*$", node.get("formula") or node.astext()))


def shortened(paragraph):
    """Return what stands on the slide of a paragraph that is neither definition nor theorem."""
    first, *others = sentences(paragraph)
    parts = first
    if others and not ends(paragraph):
        parts = [*first, nodes.Text(" … " if len(others) > 1 else " "), *others[-1]]
    return nodes.paragraph("", "", *parts)


def pieces(block):
    """Yield the pieces of a long block of code, cut before statements or commands."""
    lines = 0
    held = []
    for statement in _STATEMENT.split(block.astext()):
        count = statement.count("\n")
        if held and lines + count > _LINES:
            yield "".join(held)
            held, lines = [], 0
        held.append(statement)
        lines += count
    yield "".join(held)


def is_bold(node):
    """Return whether a node is a paragraph that starts in bold: a definition or a theorem."""
    return isinstance(node, nodes.paragraph) and isinstance(node.children[0], nodes.strong)


def parts(section, is_first):
    """Yield what stands on slides, each with the paragraph that it is the short form of, if any.

    A proof starts with a word in italics and goes on to its end mark.
    """
    proof = False
    for index, node in enumerate(section.children[1:], 1):
        if isinstance(node, nodes.paragraph):
            start = node.children[0]
            left = takewhile(lambda part: not is_bold(part), section.children[index:])
            proof |= isinstance(start, nodes.emphasis) and any("∎" in p.astext() for p in left)
            bold = any(isinstance(part, nodes.strong) for part in node.children)
            whole = is_first or proof or bold or is_picture(start)
            proof &= "∎" not in node.astext()
            yield (node, None) if whole else (shortened(node), node)
        elif isinstance(node, _CODE):
            for number, piece in enumerate(pieces(node)):
                part = node.deepcopy()
                part.children = [nodes.Text(piece.rstrip("\n"))]
                part.rawsource = part.astext()  # else Sphinx does not colour it
                part["goes_on"] = number > 0
                yield part, None
        elif isinstance(node, nodes.definition_list):
            for item in node.children:
                yield nodes.definition_list("", item.deepcopy()), None
        elif not isinstance(node, (nodes.section, nodes.target, nodes.comment)):
            yield node, None


def blocks(section, is_first):
    """Yield blocks, each the nodes that stand together on a slide and those that are its notes."""
    shown, said = [], []
    for node, note in parts(section, is_first):
        stays = isinstance(node, _SHOWN) and not node.get("goes_on")
        if shown and ends(shown[-1]) and not stays:
            yield shown, said
            shown, said = [], []
        shown.append(node)
        said += [note] if note else []
    if shown:
        yield shown, said


def slides(tree, html):
    """Yield the slides of a lesson: a title, blocks and their notes, the address of a lab or none.

    The pages divide a slide further where it is too long.
    """
    whole = next(tree.findall(nodes.section))
    for section in (whole, *(one for one in whole.children if isinstance(one, nodes.section))):
        name, is_first = title(section), section is whole
        pairs = [] if name == "Answers" else list(blocks(section, is_first))
        texts = [(html(shown), html(said) if said else "") for shown, said in pairs]
        links = [] if is_first else section.findall(nodes.reference)
        labs = [one["refuri"] for one in links if _LAB.match(one.get("refuri", ""))]
        together = len(texts) == len(labs) == 1
        if texts and not together:
            yield {"title": name, "blocks": texts, "lab": ""}
        for lab in labs:
            yield {"title": name, "blocks": texts if together else [], "lab": lab}
