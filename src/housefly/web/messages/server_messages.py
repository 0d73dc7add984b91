"""What the server sends to a browser, one JSON object each, told apart by ``type``.

``client/src/wire/messages.ts`` is generated from this file and ``client_messages.py`` by
``scripts/console_types.py``. All times are seconds of the server's monotonic clock, all lengths
metres in the world frame, all angles radians.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from pydantic import TypeAdapter

from housefly.geometry import Vec2, Vec3
from housefly.hub.api.pilot_queries import PreflightView, RoomView
from housefly.messages import (
    Action,
    Behavior,
    Clearing,
    DroneStatus,
    LinkStatus,
    OrderKind,
    Phase,
    PlanAnswer,
    SafetyMode,
    Severity,
)
from housefly.messages.words import Words
from housefly.tasks.api.answers import TaskBoard
from housefly.web.http.qr_code import QrView
from housefly.web.messages.role import Role
from housefly.web.messages.verdict_message import ConsoleVerdict


@dataclass(frozen=True, slots=True)
class EventView:
    """One line of the event log; numbers rise by one, ``at`` is when the server received it."""

    number: int
    at: float
    severity: Severity
    code: str
    text: Words


@dataclass(frozen=True, slots=True)
class Welcome:
    """Answer to Hello: the viewer's number, what the role may do, and what happened before.

    ``simulated`` tells whether the room is, and things may be done to it.
    """

    you: int
    role: Role
    now: float
    events: tuple[EventView, ...]
    trail: tuple[Vec2, ...]
    simulated: bool
    type: Literal["welcome"] = "welcome"


@dataclass(frozen=True, slots=True)
class RoomMessage:
    """The room and its map."""

    room: RoomView
    type: Literal["room"] = "room"


@dataclass(frozen=True, slots=True)
class PreflightMessage:
    """What the pre-flight checks found; no checks in flight, or while nobody has looked."""

    preflight: PreflightView
    type: Literal["preflight"] = "preflight"


@dataclass(frozen=True, slots=True)
class OtherBody:
    """Another tracked body: the visitor, or furniture with length and width [m] and yaw [rad]."""

    name: str
    position: Vec2
    size: Vec2 = (0.0, 0.0)
    yaw: float = 0.0


@dataclass(frozen=True, slots=True)
class StateMessage:
    """The newest step of the pilot, at most twenty times a second.

    Attributes:
        heard_at: when the server received the step [s].
        battery, battery_return: charge, and the share above the floor that the way home and the
            landing need, 0 to 1.
        flight_s: for how long it may fly before it must turn home [s].
        faults, notes: the drone's complaints, and what is not as it should be with its settings or
            sensors.
        height: the drone's own height sensor [m].
        wanted: reference position [m].
        clears: what ends what the safety gate does, where it does anything.
        path: number of the path in use; the path itself comes as PathMessage.
        stopping_distance: that a drone this fast needs to come to rest, reaction included [m].
        height_std: one-sigma uncertainty of the height [m].
    """

    sequence: int
    heard_at: float
    status: DroneStatus | None
    battery: float | None
    battery_return: float
    flight_s: float | None
    telemetry_age: float | None
    faults: tuple[str, ...]
    notes: tuple[str, ...]
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
    clears: Clearing
    action: Action
    goal_name: str
    reason: Words
    path: int
    waypoint: int
    others: tuple[OtherBody, ...]
    stopping_distance: float | None = None
    height_std: float | None = None
    type: Literal["state"] = "state"


@dataclass(frozen=True, slots=True)
class PathMessage:
    """The path that the pilot flies; empty when there is none.

    Attributes:
        heights, times, speeds: planned at the waypoints [m, s, m/s]; empty of a path in the plane.
    """

    number: int
    waypoints: tuple[Vec2, ...]
    length: float
    heights: tuple[float, ...] = ()
    times: tuple[float, ...] = ()
    speeds: tuple[float, ...] = ()
    type: Literal["path"] = "path"


@dataclass(frozen=True, slots=True)
class LinkMessage:
    """Health of the pilot's links and loop, and when the server received it."""

    heard_at: float
    link: LinkStatus
    type: Literal["link"] = "link"


@dataclass(frozen=True, slots=True)
class EventsMessage:
    """New lines of the event log; none is ever skipped."""

    events: tuple[EventView, ...]
    type: Literal["events"] = "events"


@dataclass(frozen=True, slots=True)
class ViewerView:
    """Someone who has the console open."""

    id: int
    name: str


@dataclass(frozen=True, slots=True)
class ViewersMessage:
    """Who is here, and who has control (None: nobody)."""

    pilot: int | None
    viewers: tuple[ViewerView, ...]
    type: Literal["viewers"] = "viewers"


@dataclass(frozen=True, slots=True)
class TasksMessage:
    """The tasks.

    Attributes:
        running: whether somebody keeps the board now; without, it is of the past.
        heard_at: when the server received the board [s].
        board: the newest, or None before the first.
    """

    running: bool
    heard_at: float
    board: TaskBoard | None
    type: Literal["tasks"] = "tasks"


@dataclass(frozen=True, slots=True)
class PlanReply:
    """Answer to PlanQuestion ``id``."""

    id: int
    answer: PlanAnswer
    type: Literal["plan"] = "plan"


@dataclass(frozen=True, slots=True)
class AcceptedReply:
    """Request ``id`` was passed on."""

    id: int
    type: Literal["accepted"] = "accepted"


@dataclass(frozen=True, slots=True)
class RefusedReply:
    """Request ``id`` was not passed on; the reason is in words."""

    id: int
    reason: Words
    type: Literal["refused"] = "refused"


@dataclass(frozen=True, slots=True)
class OrderRefused:
    """The pilot refused an order of this page that was passed on."""

    order: OrderKind
    reason: Words
    type: Literal["order_refused"] = "order_refused"


@dataclass(frozen=True, slots=True)
class PongReply:
    """Answer to PingRequest: the browser's time as sent, the server's time now [s]."""

    sent: float
    now: float
    type: Literal["pong"] = "pong"


@dataclass(frozen=True, slots=True)
class InviteReply:
    """Answer to InviteRequest.

    Attributes:
        name: of the link, by which InvitationUsed tells it.
        origin: address of the console for other machines; "" where none gets in.
        path: the one-time link below it.
        until: when it is over [s].
        qr: the link as a QR code, for a phone; None where none gets in.
    """

    id: int
    name: str
    origin: str
    path: str
    until: float
    qr: QrView | None
    type: Literal["invite"] = "invite"


@dataclass(frozen=True, slots=True)
class InvitationUsed:
    """The link with this name has opened a browser; told to who made it."""

    name: str
    type: Literal["invitation_used"] = "invitation_used"


ServerMessage = (
    Welcome
    | RoomMessage
    | PreflightMessage
    | StateMessage
    | PathMessage
    | LinkMessage
    | ConsoleVerdict
    | EventsMessage
    | ViewersMessage
    | TasksMessage
    | PlanReply
    | AcceptedReply
    | RefusedReply
    | OrderRefused
    | PongReply
    | InviteReply
    | InvitationUsed
)

_SERVER_MESSAGE: TypeAdapter[ServerMessage] = TypeAdapter(ServerMessage)


def to_text(message: ServerMessage) -> str:
    """Return the JSON text of a message; numbers that are not finite become null."""
    return _SERVER_MESSAGE.dump_json(message).decode()
