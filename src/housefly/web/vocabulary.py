"""What the browser and the server say to each other, one JSON object a message, told apart by
``type``.

``client/src/wire/messages.ts`` is generated from this file by ``housefly.web.typescript``. All
times are seconds of the server's monotonic clock, all lengths metres in the world frame, all angles
radians.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from pydantic import ConfigDict, Field, TypeAdapter

from housefly.geometry import Vec2, Vec3
from housefly.hub.api.queries import RoomView
from housefly.messages import (
    Action,
    Behavior,
    DroneStatus,
    LinkStatus,
    OrderKind,
    Phase,
    PlanAnswer,
    SafetyMode,
    Severity,
)

STRICT = ConfigDict(extra="forbid", allow_inf_nan=False, str_strip_whitespace=True)
PLACE_MAX, NAME_MAX = 60, 24

Number = Annotated[int, Field(ge=0, le=2**53)]
PlaceName = Annotated[str, Field(max_length=PLACE_MAX)]
Metres = Annotated[float, Field(ge=-1e4, le=1e4)]

# --- from the browser
# -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Hello:
    """First message of a socket: which tab it is (to be known again after a reconnect) and who sits
    before it.
    """

    __pydantic_config__: ClassVar[ConfigDict] = STRICT
    type: Literal["hello"]
    tab: Annotated[str, Field(min_length=8, max_length=64)]
    name: Annotated[str, Field(max_length=NAME_MAX)] = ""


@dataclass(frozen=True, slots=True)
class Ping:
    """A sign of life; ``sent`` is the browser's own clock and comes back unchanged."""

    __pydantic_config__: ClassVar[ConfigDict] = STRICT
    type: Literal["ping"]
    sent: float


@dataclass(frozen=True, slots=True)
class StopRequest:
    """STOP: hover and stay; passes every limit and every queue."""

    __pydantic_config__: ClassVar[ConfigDict] = STRICT
    type: Literal["stop"]
    id: Number = 0


@dataclass(frozen=True, slots=True)
class OrderRequest:
    """An order for the pilot; ``place`` or ``goal`` for those that go somewhere, ``look_s`` [s] for
    the service.
    """

    __pydantic_config__: ClassVar[ConfigDict] = STRICT
    type: Literal["order"]
    id: Number
    order: OrderKind
    place: PlaceName = ""
    goal: tuple[Metres, Metres] | None = None
    look_s: Annotated[float, Field(ge=0.0, le=60.0)] = 5.0


@dataclass(frozen=True, slots=True)
class PlanQuestion:
    """How would the drone fly there from where it is?"""

    __pydantic_config__: ClassVar[ConfigDict] = STRICT
    type: Literal["plan"]
    id: Number
    place: PlaceName = ""
    goal: tuple[Metres, Metres] | None = None


@dataclass(frozen=True, slots=True)
class LeaseRequest:
    """Take control, release it, or give it to viewer ``to``; ``held`` says that a take-over was
    confirmed by holding.
    """

    __pydantic_config__: ClassVar[ConfigDict] = STRICT
    type: Literal["lease"]
    id: Number
    action: Literal["take", "release", "give"]
    to: Number = 0
    held: bool = False


@dataclass(frozen=True, slots=True)
class InviteRequest:
    """Make a one-time link for another browser."""

    __pydantic_config__: ClassVar[ConfigDict] = STRICT
    type: Literal["invite"]
    id: Number


ClientMessage = (
    Hello | Ping | StopRequest | OrderRequest | PlanQuestion | LeaseRequest | InviteRequest
)

CLIENT_MESSAGE: TypeAdapter[ClientMessage] = TypeAdapter(
    Annotated[ClientMessage, Field(discriminator="type")]
)

# --- from the server
# --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class EventView:
    """One line of the event log; numbers rise by one, ``at`` is when the server heard of it."""

    number: int
    at: float
    severity: Severity
    code: str
    text: str


@dataclass(frozen=True, slots=True)
class Welcome:
    """Answer to Hello: who you are, and what happened before you came."""

    you: int
    now: float
    events: tuple[EventView, ...]
    trail: tuple[Vec2, ...]
    type: Literal["welcome"] = "welcome"


@dataclass(frozen=True, slots=True)
class RoomNews:
    """The room and its map."""

    room: RoomView
    type: Literal["room"] = "room"


@dataclass(frozen=True, slots=True)
class OtherBody:
    """Another tracked body: the visitor, or furniture, whose footprint has a size (length and width
    [m]) and a yaw [rad].
    """

    name: str
    position: Vec2
    size: Vec2 = (0.0, 0.0)
    yaw: float = 0.0


@dataclass(frozen=True, slots=True)
class State:
    """The newest step of the pilot, at most twenty times a second.

    Attributes:
        heard_at: when the server received the step [s].
        battery, battery_return: charge, and the share of it that the way home would cost, 0 to 1.
        flight_s: flight time that the charge gives [s].
        height: the drone's own height sensor [m].
        wanted: reference position [m].
        path: number of the path in use; the path itself comes as PathNews.
    """

    sequence: int
    heard_at: float
    status: DroneStatus | None
    battery: float | None
    battery_return: float
    flight_s: float | None
    telemetry_age: float | None
    faults: tuple[str, ...]
    height: float | None
    position: Vec3 | None
    velocity: Vec3 | None
    yaw: float | None
    pose_age: float | None
    position_std: float | None
    wanted: Vec3 | None
    behavior: Behavior
    phase: Phase
    safety: SafetyMode
    action: Action
    goal_name: str
    reason: str
    path: int
    waypoint: int
    others: tuple[OtherBody, ...]
    type: Literal["state"] = "state"


@dataclass(frozen=True, slots=True)
class PathNews:
    """The path that the pilot flies; empty when there is none."""

    number: int
    waypoints: tuple[Vec2, ...]
    length: float
    type: Literal["path"] = "path"


@dataclass(frozen=True, slots=True)
class LinkNews:
    """Health of the pilot's wires and loop, and when the server heard of it."""

    heard_at: float
    link: LinkStatus
    type: Literal["link"] = "link"


@dataclass(frozen=True, slots=True)
class EventNews:
    """New lines of the event log; none is ever left out."""

    events: tuple[EventView, ...]
    type: Literal["events"] = "events"


@dataclass(frozen=True, slots=True)
class ViewerView:
    """Someone who has the console open."""

    id: int
    name: str


@dataclass(frozen=True, slots=True)
class ViewersNews:
    """Who is here, and who has control (None: nobody)."""

    pilot: int | None
    viewers: tuple[ViewerView, ...]
    type: Literal["viewers"] = "viewers"


@dataclass(frozen=True, slots=True)
class PlanNews:
    """Answer to PlanQuestion ``id``."""

    id: int
    answer: PlanAnswer
    type: Literal["plan"] = "plan"


@dataclass(frozen=True, slots=True)
class Accepted:
    """Request ``id`` was passed on."""

    id: int
    type: Literal["accepted"] = "accepted"


@dataclass(frozen=True, slots=True)
class Refused:
    """Request ``id`` was not passed on, and why, in words."""

    id: int
    reason: str
    type: Literal["refused"] = "refused"


@dataclass(frozen=True, slots=True)
class Pong:
    """Answer to Ping: the browser's time as sent, the server's time now [s]."""

    sent: float
    now: float
    type: Literal["pong"] = "pong"


@dataclass(frozen=True, slots=True)
class InviteNews:
    """Answer to InviteRequest: the path of the one-time link, to be put behind the console's own
    address.
    """

    id: int
    path: str
    type: Literal["invite"] = "invite"


ServerMessage = (
    Welcome
    | RoomNews
    | State
    | PathNews
    | LinkNews
    | EventNews
    | ViewersNews
    | PlanNews
    | Accepted
    | Refused
    | Pong
    | InviteNews
)

_SERVER_MESSAGE: TypeAdapter[ServerMessage] = TypeAdapter(ServerMessage)


def to_text(message: ServerMessage) -> str:
    """Return the JSON text of a message; numbers that are not finite become null."""
    return _SERVER_MESSAGE.dump_json(message).decode()
