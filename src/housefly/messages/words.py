"""What people are told: a sentence in English that still knows its template and its values.

``Words("going around {thing}", thing="chair")`` is the text ``going around chair``. Whoever reads
it in another language looks the template up, and puts the values into that: numbers with their
decimal sign, names as they are, words again by their own template.

On the wire words are a flat list in preorder, each item marked by its first letter: a template
(``%``), a number (``#``) or a name (``=``). A sentence without a template is a name alone.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from enum import Enum
from functools import lru_cache
from typing import Any

from pydantic_core import core_schema

_PLACEHOLDER = re.compile(r"\{(\w+)\}")
_TEMPLATE, _NUMBER, _NAME = "%", "#", "="
_DEPTH_MAX = 20
"""Words in words in words: nothing that is said is deeper."""
JOINED = {", ": "{why}, {more}", "; ": "{why}; {more}", ": ": "{why}: {more}"}
_TEMPLATES_KEPT = 2000
_TEXT_SCHEMA = {"type": "string"}


class Number(str):
    """A number in a sentence, with its decimals, by ``figure`` or ``percentage``."""

    __slots__ = ()


class Words(str):
    """A sentence, or part of one, for people; equal to its English text.

    Args:
        template: in English, with names in braces.
        values: of each name: a number, a name of something, or words. A list of names is a name.

    Attributes:
        template: "" of a text that is no sentence of ours: a name, or what an older version wrote.
        values: in the order of the template; of a text without one, that text.

    Raises TypeError where names and values do not match.
    """

    __slots__ = ("template", "values")
    template: str
    values: tuple[str, ...]

    def __new__(cls, template: str, /, **values: str) -> Words:
        """Return the sentence."""
        form, names = _form(template)
        given = tuple(values.values())
        if tuple(values) != names:
            if values.keys() != set(names):
                raise TypeError(f"{template!r} is given {sorted(values)}")
            given = tuple(map(values.__getitem__, names))
        return _made(template, given, form)

    def value(self, name: str) -> str:
        """Return the value of a name of the template, "" where it has no such name."""
        names = _form(self.template)[1]
        return self.values[names.index(name)] if name in names else ""

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: Any) -> core_schema.CoreSchema:
        """Return how pydantic reads and writes words: as their ``tree``."""
        return core_schema.no_info_plain_validator_function(
            from_tree, serialization=core_schema.plain_serializer_function_ser_schema(tree)
        )

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: Any, handler: Any) -> dict[str, Any]:
        """Return what a ``tree`` is for JSON schema: a text, or a list that begins with one."""
        return {"anyOf": [{"type": "string"}, {"type": "array", "prefixItems": [_TEXT_SCHEMA]}]}

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("words are what they are")

    def __reduce__(self) -> tuple[Any, ...]:
        """Return how it is made again from template and values."""
        return (_again, (self.template, self.values))


def figure(value: float, form: str = "") -> Number:
    """Return a number for a sentence; ``form`` as in an f-string, for example ``.1f``."""
    return Number(format(value, form))


def percentage(share: float) -> Number:
    """Return a share, 0 to 1, as a whole number of percent."""
    return Number(format(share, ".0%")[:-1])


def said(member: Enum) -> Words:
    """Return the words that are the value of a member: a template without values."""
    return Words(member.value)


def joined(sign: str, parts: Iterable[str]) -> Words:
    """Return words one after another, with ", ", "; " or ": " between them; UNSAID for none."""
    several = tuple(parts)
    half = len(several) // 2
    if not half:
        return literal(several[0]) if several else UNSAID
    first, rest = joined(sign, several[:half]), joined(sign, several[half:])
    return Words(JOINED[sign], why=first, more=rest)


def literal(text: str) -> Words:
    """Return a text that has no template; words stay what they are."""
    return text if isinstance(text, Words) else _made("", (text,), "%s")


def error_words(error: BaseException) -> Words:
    """Return what an error says: the words that it was raised with, or its text."""
    said_by = error.args[0] if len(error.args) == 1 else ""
    return said_by if isinstance(said_by, Words) else literal(str(error))


def parts_of(words: str) -> Iterator[str]:
    """Yield words and all that they are made of."""
    yield words
    for one in words.values if isinstance(words, Words) and words.template else ():
        yield from parts_of(one)


def flat(words: str) -> list[str]:
    """Return words as they go over the wire; nothing to say is an empty list."""
    return list(_flattened(words)) if words else []


def _flattened(value: str) -> Iterator[str]:
    if isinstance(value, Words) and value.template:
        yield _TEMPLATE + value.template
        for one in value.values:
            yield from _flattened(one)
    else:
        yield (_NUMBER if isinstance(value, Number) else _NAME) + value


def unflattened(parts: Sequence[str]) -> Words:
    """Return the words in a list from the wire; raises ValueError for anything else."""
    if not parts:
        return UNSAID
    rest = iter(parts)
    words = _read(rest, _DEPTH_MAX)
    if next(rest, None) is not None:
        raise ValueError("more values than the words have names")
    return literal(words)


def _read(rest: Iterator[str], depth: int) -> str:
    part = next(rest, "")
    mark, text = part[:1], part[1:]
    if mark == _NAME:
        return text
    if mark == _NUMBER:
        return Number(text)
    if mark != _TEMPLATE or not text or not depth:
        raise ValueError(f"no words: {part[:40]!r}")
    form, names = _form(text)
    return _made(text, tuple(_read(rest, depth - 1) for _ in names), form)


def tree(words: str) -> Any:
    """Return words as JSON for pages.

    A name, and a text without a template, is a text; a number is ``{"n": "1.5"}``; words are a list
    of the template and its values.
    """
    if isinstance(words, Words) and words.template:
        return [words.template, *map(tree, words.values)]
    return {"n": str(words)} if isinstance(words, Number) else str(words)


def from_tree(value: Any) -> Words:
    """Return the words of a ``tree``; raises ValueError for anything else."""
    return literal(_of_tree(value, _DEPTH_MAX))


def _of_tree(value: Any, depth: int) -> str:
    match value:
        case str():
            return value
        case {"n": str(digits)} if len(value) == 1:
            return Number(digits)
        case [str(template), *values] if template and depth:
            form, names = _form(template)
            if len(values) != len(names):
                raise ValueError(f"not as many values as {template[:40]!r} has names")
            return _made(template, tuple(_of_tree(one, depth - 1) for one in values), form)
    raise ValueError("no words")


def with_trees(items: Iterable[tuple[str, Any]]) -> dict[str, Any]:
    """Return a dict in which words are ``tree``s: the ``dict_factory`` of ``asdict`` for JSON."""
    return {name: tree(one) if isinstance(one, Words) else one for name, one in items}


@lru_cache(_TEMPLATES_KEPT)
def _form(template: str) -> tuple[str, tuple[str, ...]]:
    """Return what ``%`` makes the sentence of, and the names of its values.

    Raises ValueError where a name stands twice: words within words must not grow without end.
    """
    pieces = _PLACEHOLDER.split(template)
    names = tuple(pieces[1::2])
    if len(set(names)) < len(names):
        raise ValueError(f"a name stands twice in {template[:40]!r}")
    return "%s".join(text.replace("%", "%%") for text in pieces[::2]), names


def _made(template: str, values: tuple[str, ...], form: str) -> Words:
    words = str.__new__(Words, form % values)
    _SET_TEMPLATE(words, template)
    _SET_VALUES(words, values)
    return words


_SET_TEMPLATE, _SET_VALUES = Words.template.__set__, Words.values.__set__  # type: ignore[attr-defined]


def _again(template: str, values: tuple[str, ...]) -> Words:
    return _made(template, values, _form(template)[0] if template else "%s")


UNSAID = literal("")
"""Nothing to say."""
