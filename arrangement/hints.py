"""Answers to names and calls that do not exist: what to write, and what there is.

1. A synonym, or a variant of a name that is there, is answered with what to write.
2. So is a name that belongs to something else: to a result of this value, or to its package.
3. Every other name is answered with the names that there are, and the arguments that they need.
4. A call that does not fit is answered with one that does, and with what its arguments mean.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import FrozenInstanceError
from enum import Enum
from functools import wraps
from types import FunctionType, ModuleType
from typing import TYPE_CHECKING, Any, ClassVar, ParamSpec, TypeVar

P = ParamSpec("P")
Returned = TypeVar("Returned")

#: How alike a misspelt name is to the name that is meant: "zone" and "cone" are less so, and
#: "decone" and "cone".
_ALIKE = 0.81
#: How alike a misspelt synonym is: "to_csv" and "to_svg" are less so.
_SAME = 0.87
#: A name that has to be imported: what is called, or has something.
_FIRST = re.compile(r"(?<![\w.])(\w+)(?=[.(])")
_PACKAGES = ("arrangement", "equilibrium", "proofs_check")
#: Of more arguments than this no call is shown.
_MANY = 4
#: An argument that is written where there is it: without it planes pass through the origin.
_AFFINE = "affine"
#: Arguments that are exact numbers.
_EXACT = re.compile(r"[( ](?:direction|normal|offset|point|wrench)[,)]")
#: The method that is written with brackets.
_ITEM = "__getitem__"
#: What comes before a noun, or behind it, where its number is meant; and what says nothing.
_COUNTING = re.compile(r"(?:n|nb|num|number_of|count)_(.+)|(.+)_(?:count|number)")
_FILLING = re.compile(r"(?:all|calculate|compute|contact|find|get|list|set)_(.+)")
#: What says alone which method is meant, as ``plot_regions`` does.
_DRAWING = re.compile(r"(?:draw|plot|show|visuali[sz]e)_(.+)")
#: A heading in the docstring of a package, and the names in a line below it.
_HEADING = re.compile(r"^(\w.*)\n((?: {4}.+\n?)+)", re.MULTILINE)
_ENTRY = re.compile(r"^ {4}(\w+(?:, \w+)*)(?: {2}|$)", re.MULTILINE)


class _LateText:
    """A message that is made when it is read: most missing names are only looked for."""

    def __init__(self, make: Callable[[], str]) -> None:
        self._make = make

    def __str__(self) -> str:
        return self._make()

    __repr__ = __str__

    def __reduce__(self) -> tuple[type[str], tuple[str]]:
        return str, (str(self),)


def missing_attribute(owner: object, name: str, synonyms: Mapping[str, str]) -> AttributeError:
    """Return the error for an attribute that a value, a class or a module does not have.

    Args:
        synonyms: other names of the field, each with what to write here.
    """
    what = f"{type(owner).__name__!r} object"
    if isinstance(owner, (ModuleType, type)):
        kind = "module" if isinstance(owner, ModuleType) else "class"
        what = f"{kind} {owner.__name__!r}"
    text = f"{what} has no attribute {name!r}"
    if name.startswith("_"):  # `copy` and `pickle` look for many of these
        return AttributeError(text, name=name)
    return AttributeError(_LateText(lambda: text + _advice(owner, name, synonyms)), name=name)


def _advice(owner: object, name: str, synonyms: Mapping[str, str]) -> str:
    """Return what to write for a name that is not there."""
    from difflib import get_close_matches

    own: Any = owner if isinstance(owner, (ModuleType, type)) else type(owner)
    uses, word = _uses(own), name.lower()
    known = {x.lower(): use for x, use in {**uses, **synonyms}.items()}
    if "to_dict" in uses:
        known.setdefault("to_json", f"json.dumps({_variable(own)}.to_dict())")
    if use := _meant(word, known):
        return f"; use {_with_import(own, use)}"
    parts = {type(x): f"{_variable(own)}.{k}." for k, x in getattr(owner, "__dict__", {}).items()}
    levels = _elsewhere(own, parts) if name[:1].islower() else ()
    near = get_close_matches(name, uses, 2, _ALIKE) or get_close_matches(word, known, 1, _SAME)
    use = next(filter(None, (_meant(word, level) for level in levels)), "") or " or ".join(
        known[x.lower()] for x in near if x[0] == name[:1]
    )
    return "; ".join(["", *[f"use {_with_import(own, use)}"] * bool(use), *_listed(own, uses)])


def _with_import(own: Any, use: str) -> str:
    """Return what to write, with the import that it needs."""
    first = [] if "import" in use else dict.fromkeys(_FIRST.findall(use))
    names = [name for name in first if name in dir(sys.modules[_package(own)])]
    imports = [f"from {_package(own)} import {', '.join(names)}"] * bool(names)
    imports += [f"import {name}" for name in first if name in _PACKAGES]
    use += f" ({'; '.join(imports)})" * bool(imports)
    return use + ', floats as strings such as "0.2"' * bool(_EXACT.search(use))


def _meant(name: str, uses: Mapping[str, str]) -> str | None:
    """Return what to write for a name: that of a known word, of which it may be a variant.

    ``num_regions`` means ``n_regions`` or ``region_count``, ``get_rank`` ``rank``, and
    ``char_poly`` ``characteristic_polynomial``.

    Args:
        uses: known words in small letters, each with what to write.
    """
    words = [name]
    if counted := _COUNTING.fullmatch(name):
        noun = counted[1] or counted[2]
        words += [f"n_{noun}", f"number_of_{noun}", f"{noun.removesuffix('s')}_count", noun]
    if filled := _FILLING.fullmatch(name):
        words += [f"with_{filled[1]}", filled[1], f"{filled[1]}s"]
    if drawn := _DRAWING.fullmatch(name):
        words += [f"plot_{drawn[1]}", f"{drawn[1]}_diagram", "plot", "draw"]
    parts = name.split("_")
    for word in uses if len(parts) > 1 else ():
        whole = word.split("_")
        if len(whole) == len(parts) and all(map(str.startswith, whole, parts)):
            words.append(word)
    return next((uses[word] for word in words if word in uses), None)


def _package(own: Any) -> str:
    place: str = own.__name__ if isinstance(own, ModuleType) else own.__module__
    return place.partition(".")[0]


def _variable(own: Any) -> str:
    """Return what a value of a class is called: ``A`` where the package has the name of it."""
    name: str = own.__name__
    return name[0] if name.lower() == _package(own) else name.lower()


def _attributes(own: Any) -> dict[str, Any]:
    """Return the public names of a class or a module, each with what stands there.

    Of a class these are functions and properties, and for its fields their annotations.
    """
    if isinstance(own, ModuleType):
        values = {name: _loaded(own, name) for name in dir(own) if name[0] != "_"}
        listed = [
            x for x, y in values.items() if getattr(y, "__module__", "").startswith(_package(own))
        ]
        return {name: values[name] for name in getattr(own, "__all__", listed)}
    found: dict[str, Any] = {}
    for base in own.__mro__:
        if _package(base) in (_package(own), _package(Hints)):
            fields = vars(base).get("__annotations__", {})
            kinds = {x: y for x, y in fields.items() if "ClassVar" not in str(y)}
            used = {x: y for x, y in vars(base).items() if hasattr(y, "__get__")}
            found = {**kinds, **used, **found}
    return {name: value for name, value in found.items() if name[0] != "_" or name == _ITEM}


def _loaded(module: ModuleType, name: str) -> object:
    """Return what a module has under a name; None where a library that it needs is absent."""
    try:
        return getattr(module, name)
    except ImportError:
        return None


def _uses(own: Any) -> dict[str, str]:
    """Return the public names of a class or a module, each as it is written."""
    return {name: _use(name, value) for name, value in _attributes(own).items()}


def _use(name: str, value: object) -> str:
    """Return an attribute as it is written: what is called with the arguments that it needs."""
    value = getattr(value, "__func__", value)
    if not callable(value) or (isinstance(value, type) and issubclass(value, (Exception, Enum))):
        return name
    needed = _usual(value)
    if name == _ITEM:
        return f"[{needed[0]}]"
    is_short = len(needed) <= _MANY and not any(word[0] == "_" for word in needed)
    return f"{name}({', '.join(needed) if is_short else '...'})"


def _parameters(function: Callable[..., Any]) -> dict[str, Any]:
    """Return the parameters of a function by name, without the value that a method is of."""
    from inspect import signature

    parameters = dict(signature(function).parameters)
    return {name: x for name, x in parameters.items() if name not in ("self", "cls")}


def _needed(function: Callable[..., Any]) -> list[str]:
    """Return the arguments that a call needs, as they are written."""
    marks = {"VAR_POSITIONAL": "*{0}", "KEYWORD_ONLY": "{0}={0}", "VAR_KEYWORD": ""}
    needed = [(name, x) for name, x in _parameters(function).items() if x.default is x.empty]
    return [*filter(None, (marks.get(x.kind.name, "{0}").format(name) for name, x in needed))]


def _usual(function: Callable[..., Any]) -> list[str]:
    """Return the arguments with which a call is shown, as they are written."""
    if _AFFINE not in (parameters := _parameters(function)):
        return _needed(function)
    return [*(x for x, y in parameters.items() if y.kind is not y.KEYWORD_ONLY), f"{_AFFINE}=True"]


def _listed(own: Any, uses: Mapping[str, str]) -> list[str]:
    """Return the names of a class or a module: all, or the main ones by groups."""
    name, groups = own.__name__.rpartition(".")[2], dict(getattr(own, "_main", {}))
    doc = own.__doc__ or "" if isinstance(own, ModuleType) else ""
    for heading, lines in _HEADING.findall(doc):
        groups[heading] = " ".join(_ENTRY.findall(lines)).replace(",", "")
    if not groups:
        return [f"{name} has {', '.join(uses.values())}"] * bool(uses)
    lines = [
        f"\n    {heading}: {', '.join(uses.get(x, x) for x in words.split())}"
        for heading, words in groups.items()
    ]
    return [f"{name} has, among others (help({name}) shows all):{''.join(lines)}"]


def _elsewhere(own: Any, parts: Mapping[type, str]) -> Iterator[Mapping[str, str]]:
    """Yield what has other names, each with what to write: first what is near.

    These are the items, parts and results of a value; then of its package the functions and
    classes, its modules, and what functions return. Of a value only functions that take it count.
    """
    kind = "" if isinstance(own, ModuleType) else _variable(own)
    if kind:
        item = _result(own, _attributes(own).get(_ITEM))
        words = {} if item is None else {**item._synonyms, **_uses(item)}
        pairs = {x: f"[x.{use} for x in {kind}]" for x, use in words.items() if use.isidentifier()}
        yield pairs | {f"{word}s": use for word, use in pairs.items()}
        yield _names({cls: before for cls, before in parts.items() if isinstance(cls, Hints)})
        yield _names(_results({own: f"{kind}."}))
    package = sys.modules[_package(own)]
    uses, values, prefix = _uses(package), _attributes(package), f"{package.__name__}."
    yield {name.lower(): prefix + use for name, use in uses.items()}
    for name, module in values.items():
        if isinstance(module, ModuleType):
            yield {word.lower(): f"{prefix}{name}.{use}" for word, use in _uses(module).items()}
    made: dict[bool, dict[type, str]] = {False: {}, True: {}}
    for name in sorted(values, key=(package.__doc__ or "").find):
        result, is_class = _result(package, values[name]), isinstance(values[name], type)
        if result and re.search(rf"\b{kind}\b", uses[name]) and "..." not in uses[name]:
            made[is_class].setdefault(result, f"{prefix}{uses[name]}.")
    yield from (_names(made[False]), _names(made[True] | _results(made[False])))


def _names(made: Mapping[type, str]) -> dict[str, str]:
    """Return the names of the attributes of classes, each behind what returns a value of it."""
    pairs = [(x, before + use) for cls, before in made.items() for x, use in _uses(cls).items()]
    return {name.lower(): use for name, use in reversed(pairs)}


def _results(made: Mapping[type, str]) -> dict[type, str]:
    """Return the classes of the attributes of classes, each behind what returns a value of it."""
    found: dict[type, str] = {}
    for cls, before in made.items():
        for name, value in _attributes(cls).items():
            if name != _ITEM and (result := _result(cls, value)) and result not in made:
                found.setdefault(result, f"{before}{_use(name, value)}.")
    return found


def _result(own: Any, value: Any) -> Any:
    """Return the class of what an attribute is or returns, by its annotation; None if foreign."""
    from inspect import unwrap

    names, hint = vars(sys.modules[getattr(own, "__module__", own.__name__)]), value
    function = getattr(value, "func", getattr(value, "fget", getattr(value, "__func__", value)))
    if isinstance(function, FunctionType):
        names, hint = unwrap(function).__globals__, function.__annotations__.get("return", "")
    for part in hint.partition(" | ")[0].split(".") if isinstance(hint, str) else ():
        hint = names.get(part)
        names = getattr(hint, "__dict__", {})
    return hint if isinstance(hint, Hints) else None


def argument_texts(docstring: str, section: str = "Args") -> dict[str, str]:
    """Return what a section of a docstring in Google style says of each argument.

    >>> argument_texts("Turn.\\n\\nArgs:\\n    x, y: a point\\n        of the plane.\\n\\nRaises:")
    {'x': 'a point of the plane.', 'y': 'a point of the plane.'}
    """
    texts: dict[str, str] = {}
    names: list[str] = []
    for line in docstring.partition(f"{section}:\n")[2].partition("\n\n")[0].splitlines():
        if line.startswith("    ") and not line.startswith("     "):
            head, _, line = line.partition(":")
            names = head.strip().split(", ")
        for name in names:
            texts[name] = f"{texts.get(name, '')} {line.strip()}".strip()
    return texts


def summary(function: Callable[..., Any]) -> str:
    """Return the first paragraph of the docstring on one line, without the full stop."""
    from inspect import getdoc

    first = (getdoc(function) or "").partition("\n\n")[0]
    return " ".join(first.split()).rstrip(".")


def described(texts: Mapping[str, str]) -> str:
    """Return arguments, each in a line with the first sentence of what is said of it."""
    lines = (re.split(r"\.(?= |$)|;", f"    {name}: {text}")[0] for name, text in texts.items())
    return "".join(f"\n{line.rstrip(': ')}" for line in lines)


def unknown_arguments(
    words: Iterable[str], known: Collection[str], synonyms: Mapping[str, str]
) -> str:
    """Return names of arguments that do not exist, and what to use in their place, if known."""
    from difflib import get_close_matches

    words, uses = list(words), []
    for word in words:
        use = synonyms.get(word, "")
        name = use.partition("=")[0]
        if not use or (name.isidentifier() and name not in known):
            use = " or ".join(get_close_matches(word, known, 2, _ALIKE))
        uses += [use] * bool(use)
    return ", ".join(words) + (f"; use {' and '.join(dict.fromkeys(uses))}" if uses else "")


def _refused_call(
    function: Callable[..., Any],
    values: tuple[Any, ...],
    options: Mapping[str, Any],
    synonyms: Mapping[str, str],
) -> TypeError | None:
    """Return the error for a call that does not fit a function, with one that does."""
    from inspect import getdoc, signature

    called: Any = function
    if function.__name__ == "__init__":
        if not values:  # called on the class: Python's own message fits
            return None
        called = type(values[0])
        synonyms = {word: use for word, use in called._synonyms.items() if use.isidentifier()}
    name, known = called.__name__, signature(function)
    needed, parameters = _needed(function), _parameters(function)
    try:
        known.bind(*values, **options)
        return None
    except TypeError as error:
        reason = f"{name} got {error}"
    unknown = [word for word in options if word not in parameters]
    if unknown and not any(x.kind is x.VAR_KEYWORD for x in parameters.values()):
        reason = f"{name} has no argument {unknown_arguments(unknown, parameters, synonyms)}"
    elif "missing" in reason:
        there = known.bind_partial(*values, **options).arguments
        missing = [word for word in needed if word.partition("=")[0] not in there]
        reason = f"{name} needs {' and '.join(missing)}"
    docstring = getdoc(called) or ""
    texts = argument_texts(docstring, "Attributes") | argument_texts(docstring)
    lines = {
        word if x.default is x.empty else f"{word}={x.default!r}": texts.get(word, "")
        for word, x in parameters.items()
    }
    first = [word for word, x in parameters.items() if x.kind is x.POSITIONAL_OR_KEYWORD][:1]
    does = summary(function)
    means = f": {does[:1].lower()}{does[1:]}" * (not any(lines.values()) and bool(does))
    means += described(lines)
    use = _renamed(known, values, options, synonyms) or ", ".join(_usual(function) or first)
    return TypeError(f"{reason}. Write {name}({use}){means}")


def _renamed(
    known: Any, values: Sequence[Any], options: Mapping[str, Any], synonyms: Mapping[str, str]
) -> str:
    """Return the arguments of a call by the names that there are; empty where that is no call."""
    given = {synonyms.get(word, word): value for word, value in options.items()}
    try:
        bound = known.bind(*values, **given)
    except TypeError:
        return ""
    bound.arguments.pop("self", None)
    texts = []
    for word, value in bound.arguments.items():
        text = _as_text(value, "float" in str(known.parameters[word].annotation))
        texts.append(f"{word}={text}" if text and word in given else text)
    return ", ".join(texts) if all(texts) else ""


def _as_text(value: Any, as_float: bool) -> str:
    """Return a number, a text or a list as it is written; empty for anything else."""
    value = getattr(value, "tolist", lambda: value)()
    if isinstance(value, float) and not as_float:
        return f'"{value}"'
    if isinstance(value, list | tuple) and len(value) <= _MANY:
        texts = [_as_text(x, as_float) for x in value]
        return f"[{', '.join(texts)}]" * all(texts)
    return repr(value) * isinstance(value, int | float | str)


def hints_on_arguments(
    synonyms: Mapping[str, str],
) -> Callable[[Callable[P, Returned]], Callable[P, Returned]]:
    """Let a function answer a call that does not fit with one that does.

    Args:
        synonyms: other names of the field, each with what to write here.
    """

    def decorate(function: Callable[P, Returned]) -> Callable[P, Returned]:
        @wraps(function)
        def call(*values: P.args, **options: P.kwargs) -> Returned:
            try:
                return function(*values, **options)
            except TypeError:
                error = _refused_call(function, values, options, synonyms)
                if error is None:
                    raise
            raise error

        return call

    return decorate


def _answering(name: str, value: Any) -> Any:
    """Return what stands in a class under a name, where it is public as a function that answers."""
    function = value.__func__ if isinstance(value, classmethod) else value
    if not isinstance(function, FunctionType) or hasattr(function, "__wrapped__"):
        return value
    if name[0] == "_" and name != "__init__":
        return value
    call: Any = hints_on_arguments({})(function)
    return call if function is value else classmethod(call)


class Hints(type):
    """The class of `HintsMixin`: its classes and their calls answer as their values do."""

    _synonyms: ClassVar[Mapping[str, str]]

    def __init__(cls, *values: Any, **options: Any) -> None:
        super().__init__(*values, **options)
        for name, value in vars(cls).copy().items():
            if (call := _answering(name, value)) is not value:
                setattr(cls, name, call)

    def __setattr__(cls, name: str, value: Any) -> None:
        super().__setattr__(name, _answering(name, value))  # the __init__ of a dataclass, too

    if not TYPE_CHECKING:

        def __getattr__(cls, name: str) -> Any:
            raise missing_attribute(cls, name, cls._synonyms)


class HintsMixin(metaclass=Hints):
    """A value that answers names which it does not have, and calls that do not fit its methods.

    Attributes:
        _synonyms: other names of the field, each with what to write here.
        _main: names that are shown where no synonym is near, by groups; if there are none, all.
    """

    __slots__ = ()
    _synonyms: ClassVar[Mapping[str, str]] = {}
    _main: ClassVar[Mapping[str, str]] = {}

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if hasattr(type(self), name):  # an error inside a property is not a missing name
                return object.__getattribute__(self, name)
            raise missing_attribute(self, name, self._synonyms)


Hinting = TypeVar("Hinting", bound=HintsMixin)


def hints_on_assignment(cls: type[Hinting]) -> type[Hinting]:
    """Let values of a frozen dataclass answer an assignment with what makes a changed copy."""

    def refuse(self: Hinting, name: str, value: object) -> None:
        known, this = cls._synonyms.get(name, name), cls.__name__.lower()
        use = f"; use dataclasses.replace({this}, {known}=...)" * (known in cls.__annotations__)
        if f"with_{known}" in dir(cls):
            use = f"; use {this}.with_{known}(...)"
        raise FrozenInstanceError(f"{cls.__name__} values are immutable, so {name} is not set{use}")

    cls.__setattr__ = refuse  # type: ignore[method-assign, assignment]
    return cls
