"""What the server says of the drone: the one message that headline, banner and buttons show."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Literal

from housefly.messages import OrderKind
from housefly.messages.words import UNSAID, Words


class HeadlineShape(Enum):
    """The drawing beside the headline, which says the same without colour."""

    READY = "ready"
    MOVING = "moving"
    HOLDING = "holding"
    STOPPED = "stopped"
    WARNING = "warning"
    LOST = "lost"


class Standing(Enum):
    """Where the drone is, as far as that is known now."""

    ON_PAD = "on the pad"
    OFF_PAD = "off the pad"
    ON_GROUND = "on the ground, nobody sees where"
    IN_AIR = "in the air"
    UNKNOWN = "unknown"


class StopProgress(Enum):
    """How far a STOP has come; CONFIRMED is the pilot's own word."""

    NONE = "none"
    SENT = "sent"
    CONFIRMED = "confirmed"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class FlightObjection:
    """One reason why the drone may not take off, and what to do about it."""

    code: str
    words: Words
    mend: Words


@dataclass(frozen=True, slots=True)
class OrderObjection:
    """Why an order would come to nothing now; who has control is not in it."""

    order: OrderKind
    words: Words


@dataclass(frozen=True, slots=True)
class StopView:
    """The STOP that holds, if any.

    Attributes:
        progress: how far it has come.
        by: who pressed it, "" when that is not known.
        words: what follows from it.
    """

    progress: StopProgress = StopProgress.NONE
    by: str = ""
    words: Words = UNSAID


@dataclass(frozen=True, slots=True)
class ConsoleVerdict:
    """What is known of the drone and follows from it; sent when it changes, and once a second.

    Attributes:
        at: when it was made, on the server's clock [s].
        shape, headline, detail: the state in one line.
        banner: what must be read first, or UNSAID.
        standing, place: where the drone is, as a value and in words.
        pad_distance: from its pad [m]; None when the place is not known.
        airborne: whether it flies; None when nobody knows.
        may_be_airborne: whether one must reckon with that.
        is_cut: whether its motors are cut, so that it needs a reset.
        pose_is_old: whether the place that the map shows is of the past.
        may_take_off, reasons: whether it may, and everything that speaks against it.
        known: what forbids nothing but should be known.
        orders: the first objection to each order that would come to nothing.
        next_order: what a person would most sensibly order next; None for nothing.
        if_contact_lost: what the drone would do if this page lost contact now.
        stop: the STOP that holds.
        pilot, control: number and name of who has control; None and "" for nobody.
        has_drone: whether there is a drone at all.
        is_showing: whether the camera is held on something for people: its picture counts now.
    """

    at: float
    shape: HeadlineShape
    headline: Words
    detail: Words
    banner: Words
    standing: Standing
    place: Words
    pad_distance: float | None
    airborne: bool | None
    may_be_airborne: bool
    is_cut: bool
    pose_is_old: bool
    may_take_off: bool
    reasons: tuple[FlightObjection, ...]
    known: tuple[Words, ...]
    orders: tuple[OrderObjection, ...]
    next_order: OrderKind | None
    if_contact_lost: Words
    stop: StopView
    pilot: int | None
    control: str
    has_drone: bool = True
    is_showing: bool = False
    type: Literal["verdict"] = "verdict"
