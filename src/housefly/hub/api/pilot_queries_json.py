"""JSON of the pilot's queries, checked: no unknown keys, wrong types or infinite numbers."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any, TypeVar

from pydantic import ConfigDict, TypeAdapter, ValidationError

from housefly.config.pydantic_words import words_of
from housefly.config.validation import dotted
from housefly.errors import WireError
from housefly.hub.api.pilot_queries import PlanRequest, PreflightView, RoomView
from housefly.messages import PlanAnswer
from housefly.messages.words import with_trees

_Value = TypeVar("_Value", PlanRequest, RoomView, PlanAnswer, PreflightView)

_CONFIG = ConfigDict(extra="forbid", allow_inf_nan=False, strict=True)

_READERS: dict[Any, TypeAdapter[Any]] = {
    # A dataclass itself takes no configuration, a tuple of one does.
    kind: TypeAdapter(tuple[kind], config=_CONFIG)  # type: ignore[valid-type]
    for kind in (PlanRequest, RoomView, PlanAnswer, PreflightView)
}


def to_json(value: PlanRequest | RoomView | PlanAnswer | PreflightView) -> str:
    """Return the value as one JSON object; raises WireError for numbers that are not finite."""
    try:
        tree = asdict(value, dict_factory=with_trees)
        return json.dumps(tree, allow_nan=False, ensure_ascii=False)
    except ValueError as error:
        raise WireError(f"{type(value).__name__} has no JSON form: {error}") from error


def from_json(kind: type[_Value], text: str) -> _Value:
    """Return the value of a JSON object; raises WireError that names the first bad key."""
    try:
        (value,) = _READERS[kind].validate_json(f"[{text}]")
    except ValidationError as error:
        first = error.errors()[0]
        key = dotted(first["loc"][1:]) or kind.__name__
        raise WireError(f"{key}: {words_of(first)}") from error
    found: _Value = value
    return found
