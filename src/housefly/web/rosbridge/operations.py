"""What a client of rosbridge v2 says: one JSON object a message, told apart by ``op``.

Source: ROSBRIDGE_PROTOCOL.md, sections 2 and 3. Keys that are not named here are not read.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar, Literal

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from housefly.config.pydantic_words import words_of
from housefly.config.validation import dotted
from housefly.errors import WireError

_STRICT = ConfigDict(strict=True, allow_inf_nan=False)
_Name = Annotated[str, Field(max_length=256)]
_Id = Annotated[str, Field(max_length=256)] | int | None
_Milliseconds = Annotated[float, Field(ge=0.0, le=3_600_000.0)]
_Count = Annotated[int, Field(ge=0, le=1_000_000)]


@dataclass(frozen=True, slots=True)
class Subscribe:
    """Hear a topic.

    Attributes:
        throttle_rate: least time between two messages [ms].
        queue_length: messages that may wait; 0 leaves it to the topic.
    """

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    op: Literal["subscribe"]
    topic: _Name
    id: _Id = None
    type: _Name | None = None
    throttle_rate: _Milliseconds | None = None
    queue_length: _Count | None = None
    fragment_size: int | None = None
    compression: str | None = None


@dataclass(frozen=True, slots=True)
class Unsubscribe:
    """Hear a topic no more; without an id none of its subscriptions is left."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    op: Literal["unsubscribe"]
    topic: _Name
    id: _Id = None


@dataclass(frozen=True, slots=True)
class Advertise:
    """Say that one will publish to a topic."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    op: Literal["advertise"]
    topic: _Name
    type: _Name
    id: _Id = None


@dataclass(frozen=True, slots=True)
class Unadvertise:
    """Say that one will not."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    op: Literal["unadvertise"]
    topic: _Name
    id: _Id = None


@dataclass(frozen=True, slots=True)
class Publish:
    """Publish a message to a topic."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    op: Literal["publish"]
    topic: _Name
    msg: Any = field(default_factory=dict)
    id: _Id = None


@dataclass(frozen=True, slots=True)
class CallService:
    """Call a service; ``args`` is an object, or the values in order."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    op: Literal["call_service"]
    service: _Name
    args: dict[str, Any] | list[Any] | None = None
    id: _Id = None
    fragment_size: int | None = None
    compression: str | None = None


@dataclass(frozen=True, slots=True)
class SetLevel:
    """From which level on the client is told what went wrong."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    op: Literal["set_level", "status_level"]
    level: Literal["info", "warning", "error", "none"]
    id: _Id = None


Operation = Subscribe | Unsubscribe | Advertise | Unadvertise | Publish | CallService | SetLevel

_OPERATION: TypeAdapter[Operation] = TypeAdapter(Annotated[Operation, Field(discriminator="op")])


def operation_of(text: str) -> Operation:
    """Return what a message says.

    Raises:
        WireError: it cannot be read; nested too deep it cannot, either.
    """
    try:
        return _OPERATION.validate_json(text)
    except ValidationError as error:
        first = error.errors()[0]
        raise WireError(f"{dotted(first['loc']) or 'message'}: {words_of(first)}") from error


def shape_objection(operation: Operation) -> str:
    """Return why an answer cannot have the shape that is asked for, in words, or ""."""
    compression = getattr(operation, "compression", None)
    if compression not in (None, "", "none"):
        return f'compression {compression!r} is not served here; allowed: "none"'
    if getattr(operation, "fragment_size", None) is not None:
        return "fragments are not served here: leave out fragment_size"
    return ""
