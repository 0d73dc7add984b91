"""Checks plain values against a section, and puts what is wrong into words: the only place."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar, get_args

from pydantic import ValidationError
from pydantic.fields import FieldInfo

from housefly.config.pydantic_words import words_of
from housefly.config.section import Section
from housefly.config.text import names_like
from housefly.errors import ConfigError, HouseflyError, MissingPartError
from housefly.messages.words import Words, error_words, figure, joined

AnySection = TypeVar("AnySection", bound=Section)
Location = tuple[int | str, ...]
"""The keys and list indices that lead to a value, as pydantic reports them."""


def dotted(location: Iterable[int | str]) -> str:
    """Return a location as one key: ("limits", "speed") is "limits.speed"."""
    return ".".join(str(part) for part in location)


def validated(
    kind: type[AnySection],
    tree: Any,
    whole: str,
    source: str = "",
    key_of: Callable[[Location], str] = dotted,
) -> AnySection:
    """Return plain values as a section.

    Args:
        kind: the section.
        tree: the values, as read from a file.
        whole: names the tree when no single key is to blame.
        source: path of the file, "" when there is none.
        key_of: makes a key of a location.

    Raises:
        ConfigError: names the first bad key, its value and what is allowed.
    """
    try:
        return kind.model_validate(tree)
    except ValidationError as error:
        first = error.errors()[0]
        key = key_of(first["loc"]) or whole
        raise ConfigError(key, explain(first, kind), source) from error


def explain(
    problem: Any, root: type[Section] | None = None, units: Mapping[int | str, str] | None = None
) -> Words:
    """Return one of pydantic's problems in words: the value, what is allowed, the unit.

    Args:
        problem: an item of ``ValidationError.errors()``.
        root: declares the keys; without it, pydantic's own words say what is allowed.
        units: units by key, where the declarations do not hold them.
    """
    kind, value = problem["type"], problem["input"]
    if kind == "extra_forbidden":
        return _unknown_key(problem["loc"], root)
    if kind == "missing":
        return Words("is missing")
    if kind == "value_error":
        return error_words(problem["ctx"]["error"])
    field = _field_at(problem["loc"], root) if root else None
    bounds = _bounds(field)
    if bounds:
        return out_of_range(repr(value), *bounds, _unit(field))
    unit = next((units[key] for key in problem["loc"] if key in units), "") if units else ""
    words = Words("is {name}; {words}", name=repr(value), words=words_of(problem))
    return Words("{words} {unit}", words=words, unit=unit) if unit else words


def out_of_range(shown: str, low: float, high: float, unit: str) -> Words:
    """Return that a value is out of its range, with the unit, "" for none."""
    a, b = figure(low, ".9g"), figure(high, ".9g")
    if not unit:
        return Words("is {name}; allowed: a number from {a} to {b}", name=shown, a=a, b=b)
    return Words(
        "is {name}; allowed: a number from {a} to {b} {unit}", name=shown, a=a, b=b, unit=unit
    )


def refusal_words(error: HouseflyError) -> Words:
    """Return what an error says, with the key of a wrong value, without the file."""
    match error:
        case ConfigError():
            return joined(": ", (error.key, error.problem))
        case MissingPartError():
            return Words(
                "{part} is missing; install it with: {name}", part=error.part, name=error.remedy
            )
    return error_words(error)


def _unknown_key(location: Location, root: type[Section] | None) -> Words:
    """Return that a key is not known, and which one may have been meant."""
    *parents, key = location
    holders = _sections_at(tuple(parents), root) if root else []
    close = names_like(str(key), (name for one in holders for name in one.model_fields))
    if not close:
        return Words("is not a known key")
    return Words("is not a known key: did you mean {names}?", names=close)


def _field_at(location: Location, root: type[Section]) -> FieldInfo | None:
    """Return the declaration of the key at a location, through lists and alternatives."""
    return _walked(location, root)[1]


def _sections_at(location: Location, root: type[Section]) -> list[type[Section]]:
    """Return the sections that a location may hold."""
    return _walked(location, root)[0]


def _walked(
    location: Location, root: type[Section]
) -> tuple[list[type[Section]], FieldInfo | None]:
    sections, field = [root], None
    for part in location:
        if isinstance(part, int):
            continue
        field = next(
            (section.model_fields[part] for section in sections if part in section.model_fields),
            None,
        )
        sections = (
            _sections(field.annotation)
            if field
            else [section for section in sections if _is_chosen_by(section, part)]
        )
    return sections, field


def _sections(annotation: Any) -> list[type[Section]]:
    """Return the sections that a key may hold."""
    if isinstance(annotation, type) and issubclass(annotation, Section):
        return [annotation]
    return [section for part in get_args(annotation) for section in _sections(part)]


def _is_chosen_by(section: type[Section], word: str) -> bool:
    """Return whether a word in a location names this alternative."""
    return any(word in get_args(field.annotation) for field in section.model_fields.values())


def _bounds(field: FieldInfo | None) -> tuple[float, float] | None:
    if field is None:
        return None
    low = next((item.ge for item in field.metadata if hasattr(item, "ge")), None)
    high = next((item.le for item in field.metadata if hasattr(item, "le")), None)
    return (float(low), float(high)) if low is not None and high is not None else None


def _unit(field: FieldInfo | None) -> str:
    extra = field.json_schema_extra if field else None
    unit = extra.get("unit", "1") if isinstance(extra, dict) else "1"
    return "" if unit in (None, "1") else str(unit)
