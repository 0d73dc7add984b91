"""The console's verdict in a room without a drone: what is watched, and that nothing flies."""

from __future__ import annotations

from housefly.messages import OrderKind
from housefly.messages.words import UNSAID, Words
from housefly.web.messages.verdict_message import (
    ConsoleVerdict,
    HeadlineShape,
    OrderObjection,
    Standing,
)
from housefly.web.status.console_knowledge import PILOT_TIMEOUT, ConsoleKnowledge

_NO_DRONE = Words("This room has no drone.")


def watching_verdict(known: ConsoleKnowledge) -> ConsoleVerdict:
    """Return what is to be said of a room that is watched."""
    heard = known.link is not None and known.now - known.link.at <= PILOT_TIMEOUT
    notes = known.link.notes if known.link is not None and heard else ()
    return ConsoleVerdict(
        at=known.now,
        shape=HeadlineShape.READY if heard else HeadlineShape.LOST,
        headline=Words("Watching the room") if heard else Words("Waiting for tracking"),
        detail=Words("no drone"),
        banner=UNSAID,
        standing=Standing.UNKNOWN,
        place=UNSAID,
        pad_distance=None,
        airborne=False,
        may_be_airborne=False,
        is_cut=False,
        pose_is_old=False,
        may_take_off=False,
        reasons=(),
        known=notes,
        orders=tuple(OrderObjection(kind, _NO_DRONE) for kind in OrderKind),
        next_order=None,
        if_contact_lost=UNSAID,
        stop=known.stop,
        pilot=known.pilot,
        control=known.control,
        has_drone=False,
    )
