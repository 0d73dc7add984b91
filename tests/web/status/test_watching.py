"""What the console says of a room without a drone."""

from __future__ import annotations

from dataclasses import replace

from housefly.messages import LinkStatus, OrderKind
from housefly.web.messages.verdict_message import HeadlineShape
from housefly.web.status.console_knowledge import ConsoleKnowledge
from housefly.web.status.verdict import console_verdict

KNOWN = ConsoleKnowledge(
    now=100.0, link=LinkStatus(at=99.8, notes=("connected, but silent",)), has_drone=False
)


def test_it_is_watched_no_order_is_open_and_nothing_is_asked_for() -> None:
    told = console_verdict(KNOWN)
    assert (told.headline, told.shape) == ("Watching the room", HeadlineShape.READY)
    assert not told.has_drone and told.reasons == () and told.next_order is None
    assert told.known == ("connected, but silent",)
    assert {one.order for one in told.orders} == set(OrderKind)
    assert not told.may_be_airborne and not told.may_take_off


def test_an_observer_that_is_not_heard_is_told() -> None:
    for known in (replace(KNOWN, now=105.0), replace(KNOWN, link=None)):
        assert console_verdict(known).shape is HeadlineShape.LOST
