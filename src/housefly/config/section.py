"""A table of a configuration file as a type: quantities with range and unit, and problems told in
words.
"""

from __future__ import annotations

from ipaddress import IPv4Address
from typing import Any, get_args

from pydantic import BaseModel, ConfigDict, Field
from pydantic.fields import FieldInfo


def quantity(default: float, low: float, high: float, unit: str, meaning: str) -> Any:
    """Declare a number with its default, inclusive range, unit and one-line meaning."""
    return Field(
        default,
        ge=low,
        le=high,
        allow_inf_nan=False,
        description=meaning,
        json_schema_extra={"unit": unit},
    )


def port_number(default: int, meaning: str) -> Any:
    """Declare a port with its default and one-line meaning."""
    return Field(default, ge=1, le=65535, description=meaning, json_schema_extra={"unit": "1"})


def is_multicast_group(address: str) -> bool:
    """Tell whether a text is an IPv4 multicast address."""
    try:
        return IPv4Address(address).is_multicast
    except ValueError:
        return False


class Section(BaseModel):
    """A frozen table of the site file that knows all its keys."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False)


def explain(problem: Any, root: type[Section]) -> str:
    """Return one of pydantic's problems in words: the value, what is allowed, the unit; ``root``
    declares the keys.
    """
    kind, value = problem["type"], problem["input"]
    if kind == "extra_forbidden":
        return "is not a known key"
    if kind == "missing":
        return "is missing"
    if kind == "value_error":
        return str(problem["ctx"]["error"])
    found = _field_at(problem["loc"], root)
    bounds = _bounds(found)
    unit = (
        (found.json_schema_extra or {})
        if found and isinstance(found.json_schema_extra, dict)
        else {}
    ).get("unit")
    unit_text = f" {unit}" if unit not in (None, "1") else ""
    if bounds:
        return f"is {value!r}; allowed: a number from {bounds[0]:.9g} to {bounds[1]:.9g}{unit_text}"
    return f"is {value!r}; {problem['msg'][0].lower()}{problem['msg'][1:]}"


def _field_at(location: tuple[int | str, ...], root: type[Section]) -> FieldInfo | None:
    """Return the declaration of the key at a location, through lists and alternatives."""
    sections, found = [root], None
    for part in location:
        if isinstance(part, int):
            continue
        found = next(
            (section.model_fields[part] for section in sections if part in section.model_fields),
            None,
        )
        sections = (
            _sections(found.annotation)
            if found
            else [section for section in sections if _is_chosen_by(section, part)]
        )
    return found


def _sections(annotation: Any) -> list[type[Section]]:
    """Return the tables that a key may hold."""
    if isinstance(annotation, type) and issubclass(annotation, Section):
        return [annotation]
    return [section for part in get_args(annotation) for section in _sections(part)]


def _is_chosen_by(section: type[Section], word: str) -> bool:
    """Tell whether a word in a location names this alternative."""
    return any(word in get_args(found.annotation) for found in section.model_fields.values())


def _bounds(found: FieldInfo | None) -> tuple[float, float] | None:
    if found is None:
        return None
    low = next((item.ge for item in found.metadata if hasattr(item, "ge")), None)
    high = next((item.le for item in found.metadata if hasattr(item, "le")), None)
    return (float(low), float(high)) if low is not None and high is not None else None
