from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.bus.local import LocalBus
from housefly.bus.topics import LINK, ORDER, STEP
from housefly.clock import SteppedClock
from housefly.config.furniture import FurnitureConfig
from housefly.messages import (
    Event,
    LinkStatus,
    Order,
    OrderKind,
    PilotStep,
    Pose,
    Severity,
    Sighting,
)
from housefly.web.news import PilotNews
from housefly.web.rehearsal import PretendedPilot
from housefly.web.rehearsal_room import example_room


@pytest.fixture
def heard() -> tuple[PilotNews, PretendedPilot, SteppedClock, LocalBus]:
    bus, clock = LocalBus(), SteppedClock(100.0)
    news = PilotNews(clock, "ardrone")
    news.listen(bus)
    return news, PretendedPilot(bus.join(), example_room(), clock), clock, bus


Heard = tuple[PilotNews, PretendedPilot, SteppedClock, LocalBus]


def test_before_the_first_step_there_is_nothing_to_show(heard: Heard) -> None:
    news, *_ = heard
    assert news.state(0.0) is None
    assert news.age == float("inf")


def test_the_state_is_the_newest_step(heard: Heard) -> None:
    news, pilot, clock, _ = heard
    pilot.advance(0.01)
    clock.advance(0.3)
    state = news.state(36.0)
    assert state is not None
    assert state.position == (1.0, 1.0, 0.0)
    assert state.battery_return == pytest.approx(0.05)
    assert state.heard_at == 100.0
    assert news.age == pytest.approx(0.3)


def test_no_event_is_ever_lost_between_two_looks(heard: Heard) -> None:
    news, pilot, _, _ = heard
    for n in range(50):
        pilot.say(Severity.INFO, "test", f"event {n}")
        pilot.advance(0.01)
    first = news.events_after(0)
    assert [event.text for event in first] == [f"event {n}" for n in range(50)]
    assert [event.number for event in first] == list(range(1, 51))
    pilot.say(Severity.FAULT, "test", "one more")
    pilot.advance(0.01)
    assert [event.text for event in news.events_after(50)] == ["one more"]


def test_a_pilot_that_counts_anew_is_noticed(heard: Heard) -> None:
    news, pilot, _, _ = heard
    pilot.advance(0.01)
    pilot.advance(0.01)
    assert news.restarts == 0
    pilot.sequence = 0
    pilot.advance(0.01)
    assert news.restarts == 1


def test_the_trail_grows_with_the_way_and_not_with_time(heard: Heard) -> None:
    news, pilot, _, _ = heard
    for _ in range(10):
        pilot.advance(0.01)
    assert len(news.trail()) == 1
    pilot.position = (2.0, 1.0)
    pilot.advance(0.01)
    assert news.trail() == ((1.0, 1.0), (2.0, 1.0))


def test_each_flight_has_a_trail_of_its_own(heard: Heard) -> None:
    news, pilot, _, bus = heard
    pilot.advance(0.01)
    pilot.position = (2.0, 1.0)
    pilot.advance(0.01)
    bus.publish(ORDER, Order(OrderKind.TAKE_OFF))
    pilot.advance(0.01)
    assert news.trail() == ((2.0, 1.0),)


def test_other_bodies_are_shown_until_they_are_not_seen_any_more(heard: Heard) -> None:
    news, pilot, clock, bus = heard
    pilot.advance(0.01)
    state = news.state(0.0)
    assert state is not None and [body.name for body in state.others] == ["visitor"]
    step = news.step
    assert step is not None
    clock.advance(3.0)
    bus.publish(STEP, replace(step, sequence=99, inputs=replace(step.inputs, sightings=())))
    state = news.state(0.0)
    assert state is not None and state.others == ()


def test_furniture_is_shown_as_it_lies_for_as_long_as_the_pilot_remembers_it(heard: Heard) -> None:
    news, pilot, clock, bus = heard
    cart = FurnitureConfig(
        name="the cart", body="Cart", length=0.8, width=0.4, x=0.1, remembered=10.0
    )
    sofa = FurnitureConfig(name="the sofa", body="Sofa", model="sofa", length=2.4, width=0.9)
    news.furniture = (cart, sofa)
    pilot.advance(0.01)
    step = news.step
    assert step is not None
    seen = tuple(
        Sighting(body, Pose((2.0, 1.0, 0.5)), step.now, step.now) for body in ("Cart", "Sofa")
    )
    bus.publish(STEP, replace(step, sequence=99, inputs=replace(step.inputs, sightings=seen)))
    shown: list[list[str]] = []
    for _ in range(2):
        state = news.state(0.0)
        assert state is not None
        shown.append([body.name for body in state.others if body.size[0]])
        if shown == [["the cart", "the sofa"]]:
            assert (state.others[-2].position, state.others[-2].size) == ((2.1, 1.0), (0.8, 0.4))
        clock.advance(11.0)
    assert shown == [["the cart", "the sofa"], ["the sofa"]]


def test_link_and_notes_of_our_own_are_kept(heard: Heard) -> None:
    news, _, _, bus = heard
    bus.publish(LINK, LinkStatus(1.0, tracking_rate_hz=99.0))
    link = news.link()
    assert link is not None and link.link.tracking_rate_hz == 99.0
    news.note(Severity.WARNING, "order", "Anna: STOP")
    assert news.events_after(0)[-1].text == "Anna: STOP"


def test_a_step_without_telemetry_and_estimate_can_be_shown(heard: Heard) -> None:
    news, pilot, _, bus = heard
    pilot.advance(0.01)
    step = news.step
    assert step is not None
    outputs = replace(
        step.outputs, estimate=None, reference=None, events=(Event(1.0, Severity.INFO, "x", "y"),)
    )
    bus.publish(
        STEP, PilotStep(step.sequence + 1, 1.0, replace(step.inputs, telemetry=None), outputs)
    )
    state = news.state(0.0)
    assert state is not None and state.position is None and state.battery is None
