"""What the fields of our messages are on the wire."""

from __future__ import annotations

from dataclasses import MISSING, fields
from enum import Enum
from typing import Any, get_args, get_type_hints

from rosbags.interfaces import Nodetype
from rosbags.typesys.store import Typestore

from housefly.bus.interfaces import ros_name
from housefly.errors import WireError
from housefly.messages import Fact
from housefly.messages.words import Words

TUPLES = {
    "geometry_msgs/msg/Point": ("x", "y", "z"),
    "geometry_msgs/msg/Vector3": ("x", "y", "z"),
    "geometry_msgs/msg/Quaternion": ("w", "x", "y", "z"),
    ros_name("Point2"): ("x", "y"),
    ros_name("Fact"): ("name", "form", "text", "number"),
}
"""The types that our messages hold as tuples, and the fields in the order of the tuple."""


FACT = ros_name("Fact")
"""The type of a named value of ``messages.world.Facts``."""
WORDS = ros_name("Words")
"""The type of ``messages.words.Words``."""
EnumCodes = dict[Enum, int | str]
"""What stands for each member on the wire: its number, or its value where that is a text."""


def fields_of(kind: type[Any], store: Typestore) -> list[tuple[str, Any, EnumCodes | None]]:
    """Return name, description and, of an enum or a tuple of one, its codes, field by field."""
    name = kind.__name__
    constants, written = store.fielddefs[
        "geometry_msgs/msg/Pose" if name == "Pose" else ros_name(name)
    ]
    hints = get_type_hints(kind)
    _check_fields(kind, [field for field, _ in written])
    numbers = {constant: int(value) for constant, _, value in constants}
    return [(field, of, _enumerated(field, of, hints[field], numbers)) for field, of in written]


def fact_fields(fact: tuple[str, Fact]) -> tuple[str, int, str, float]:
    """Return name, form, text and number of a named value; raises TypeError for another form."""
    name, value = fact
    if isinstance(value, str):
        return name, _TEXT, value, 0.0
    if not isinstance(value, bool | float | int):
        raise TypeError(f"the fact {name!r} is neither text nor number nor boolean")
    return name, _BOOLEAN if isinstance(value, bool) else _NUMBER, "", value


def fact_of(name: str, form: int, text: str, number: float) -> tuple[str, Fact]:
    """Return a named value; raises ValueError for a form that there is not."""
    values: tuple[Fact, ...] = (text, number, number != 0.0)
    if form >= len(values):
        raise ValueError(f"the fact {name!r} has the form {form}")
    return name, values[form]


_TEXT, _NUMBER, _BOOLEAN = range(3)


def was_plain_text(kind: type[Any], field: str, description: Any) -> bool:
    """Return whether a field of words, or of several, holds texts: an older version wrote it."""
    hint = get_type_hints(kind)[field]
    return next(iter(get_args(hint)), hint) is Words and _base_type(description) == "string"


def _check_fields(kind: type[Any], written: list[str]) -> None:
    """Raise WireError when a message cannot be made of the fields that were written."""
    ours = {field.name: field for field in fields(kind)}
    unknown = [name for name in written if name not in ours]
    lacking = [
        name
        for name, field in ours.items()
        if name not in written and field.default is MISSING and field.default_factory is MISSING
    ]
    if unknown or lacking:
        raise WireError(f"{kind.__name__}: other fields: {', '.join(unknown + lacking)}")


def _enumerated(
    name: str, description: Any, hint: Any, numbers: dict[str, int]
) -> EnumCodes | None:
    """Return the code of each member, or None for what is no enum."""
    kind = next(iter(get_args(hint)), hint)
    if not (isinstance(kind, type) and issubclass(kind, Enum)):
        return None
    if _base_type(description) == "string":  # of an older version
        return {member: member.value for member in kind}
    names = {member: f"{name.upper()}_{member.name}" for member in kind}
    return {member: numbers[text] for member, text in names.items() if text in numbers}


def _base_type(description: Any) -> str:
    """Return the plain type of a field, or of the elements of a sequence."""
    shape, content = description
    if shape == Nodetype.NAME:
        return str(content)
    return str(content[0] if shape == Nodetype.BASE else content[0][1][0])
