"""What a browser sends to the server, one JSON object each, told apart by ``type``.

``client/src/wire/messages.ts`` is generated from this file and ``server_messages.py`` by
``scripts/console_types.py``. All lengths are metres in the world frame, all angles radians.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from pydantic import ConfigDict, Field, TypeAdapter

from housefly.messages import OrderKind

_STRICT = ConfigDict(extra="forbid", allow_inf_nan=False, str_strip_whitespace=True)
_PLACE_MAX, _NAME_MAX = 60, 24

_RequestId = Annotated[int, Field(ge=0, le=2**53)]
_PlaceName = Annotated[str, Field(max_length=_PLACE_MAX)]
_Metres = Annotated[float, Field(ge=-1e4, le=1e4)]
_MetresPerSecond = Annotated[float, Field(ge=-2.0, le=2.0)]


@dataclass(frozen=True, slots=True)
class Hello:
    """First message of a socket: the tab, recognized after a reconnect, and the user's name."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["hello"]
    tab: Annotated[str, Field(min_length=8, max_length=64)]
    name: Annotated[str, Field(max_length=_NAME_MAX)] = ""


@dataclass(frozen=True, slots=True)
class PingRequest:
    """A sign of life; ``sent`` is the browser's own clock and comes back unchanged."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["ping"]
    sent: float


@dataclass(frozen=True, slots=True)
class StopRequest:
    """STOP: hover and stay; passes every limit and every queue."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["stop"]
    id: _RequestId = 0


@dataclass(frozen=True, slots=True)
class OrderRequest:
    """An order for the pilot.

    Attributes:
        place, goal: the target, one of the two, of an order that goes somewhere.
        look_s: how long a service looks at its target [s].
    """

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["order"]
    id: _RequestId
    order: OrderKind
    place: _PlaceName = ""
    goal: tuple[_Metres, _Metres] | None = None
    look_s: Annotated[float, Field(ge=0.0, le=60.0)] = 5.0


@dataclass(frozen=True, slots=True)
class NudgeRequest:
    """Move a drone that holds its place by hand, for the next moment; sent while a key is held.

    Attributes:
        velocity: wanted, along the axes of the map [m/s].
        sent: the browser's own clock, as in PingRequest [s].
    """

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["nudge"]
    id: _RequestId
    velocity: tuple[_MetresPerSecond, _MetresPerSecond, _MetresPerSecond]
    sent: float


@dataclass(frozen=True, slots=True)
class PlanQuestion:
    """Ask how the drone would fly there from where it is."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["plan"]
    id: _RequestId
    place: _PlaceName = ""
    goal: tuple[_Metres, _Metres] | None = None


@dataclass(frozen=True, slots=True)
class LeaseRequest:
    """Take control, release it, or give it to viewer ``to``.

    ``held``: the button was held to confirm a take-over.
    """

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["lease"]
    id: _RequestId
    action: Literal["take", "release", "give"]
    to: _RequestId = 0
    held: bool = False


@dataclass(frozen=True, slots=True)
class InviteRequest:
    """Make a one-time link for another browser, which then may do what the role allows."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    type: Literal["invite"]
    id: _RequestId
    role: Literal["watch", "ask", "fly"] = "watch"


ClientMessage = (
    Hello
    | PingRequest
    | StopRequest
    | OrderRequest
    | NudgeRequest
    | PlanQuestion
    | LeaseRequest
    | InviteRequest
)

CLIENT_MESSAGE: TypeAdapter[ClientMessage] = TypeAdapter(
    Annotated[ClientMessage, Field(discriminator="type")]
)
