from __future__ import annotations

from dataclasses import replace

import pytest
from fake_pilot import FakePilot
from fake_room import example_room

from housefly.bus.local import LocalBus
from housefly.bus.topics import FRAME_TOPIC, DroneTopics
from housefly.clock import SteppedClock
from housefly.config.furniture import FurnitureConfig
from housefly.messages import (
    Event,
    EventCode,
    LinkStatus,
    Order,
    OrderKind,
    Path,
    PilotStep,
    PlannedTrajectory,
    Pose,
    Severity,
    Sighting,
    TrackedFrame,
    TrajectoryPoint,
)
from housefly.pilot.behavior.way_home import charge_for
from housefly.web.status.state_feed import StateFeed

TOPICS = DroneTopics()


@pytest.fixture
def listening() -> tuple[StateFeed, FakePilot, SteppedClock, LocalBus]:
    bus, clock = LocalBus(), SteppedClock(100.0)
    feed = StateFeed(clock, "ardrone")
    feed.listen(bus)
    return feed, FakePilot(bus.join(), example_room(), clock), clock, bus


Listening = tuple[StateFeed, FakePilot, SteppedClock, LocalBus]


def test_before_the_first_step_there_is_nothing_to_show(listening: Listening) -> None:
    feed, *_ = listening
    assert feed.state(0.0) is None
    assert feed.age == float("inf")


def test_the_state_is_the_newest_step(listening: Listening) -> None:
    feed, pilot, clock, _ = listening
    pilot.advance(0.01)
    clock.advance(0.3)
    state = feed.state(36.0)
    assert state is not None
    assert state.position == (1.0, 1.0, 0.0)
    assert state.heard_at == 100.0
    assert feed.age == pytest.approx(0.3)


@pytest.mark.parametrize(("charge", "home"), [(0.9, 36.0), (0.2, 0.0), (0.17, 36.0), (0.1, 0.0)])
def test_the_minutes_that_are_told_end_where_it_must_turn_home(
    listening: Listening, charge: float, home: float
) -> None:
    feed, pilot, _, _ = listening
    pilot.battery = charge
    pilot.advance(0.01)
    state, limits = feed.state(home), feed.limits
    assert state is not None and state.flight_s is not None
    usable = charge - limits.battery_floor - state.battery_return
    assert state.flight_s == pytest.approx(max(0.0, usable * limits.flight_time), abs=1e-6)
    left = charge - state.flight_s / limits.flight_time
    needed = charge_for(home, 1.0 / limits.flight_time, limits)
    assert state.flight_s == 0.0 or left == pytest.approx(needed)


def test_what_the_drone_notes_of_its_settings_and_sensors_is_part_of_the_state(
    listening: Listening,
) -> None:
    feed, pilot, _, _ = listening
    pilot.notes = ("the ultrasound sensor is deaf",)
    pilot.advance(0.01)
    state = feed.state(0.0)
    assert state is not None and state.notes == pilot.notes


def test_no_event_is_ever_lost_between_two_looks(listening: Listening) -> None:
    feed, pilot, _, _ = listening
    for n in range(50):
        pilot.add_event(Severity.INFO, "going_on", f"event {n}")
        pilot.advance(0.01)
    first = feed.events_after(0)
    assert [event.text for event in first] == [f"event {n}" for n in range(50)]
    assert [event.number for event in first] == list(range(1, 51))
    pilot.add_event(Severity.FAULT, "going_on", "one more")
    pilot.advance(0.01)
    assert [event.text for event in feed.events_after(50)] == ["one more"]


def test_a_pilot_that_counts_anew_is_noticed(listening: Listening) -> None:
    feed, pilot, _, _ = listening
    pilot.advance(0.01)
    pilot.advance(0.01)
    assert feed.restarts == 0
    pilot.sequence = 0
    pilot.advance(0.01)
    assert feed.restarts == 1


def test_the_trail_grows_with_the_way_and_not_with_time(listening: Listening) -> None:
    feed, pilot, _, _ = listening
    for _ in range(10):
        pilot.advance(0.01)
    assert len(feed.trail()) == 1
    pilot.position = (2.0, 1.0)
    pilot.advance(0.01)
    assert feed.trail() == ((1.0, 1.0), (2.0, 1.0))


def test_each_flight_has_a_trail_of_its_own(listening: Listening) -> None:
    feed, pilot, _, bus = listening
    pilot.advance(0.01)
    pilot.position = (2.0, 1.0)
    pilot.advance(0.01)
    bus.publish(TOPICS.order, Order(OrderKind.TAKE_OFF))
    pilot.advance(0.01)
    assert feed.trail() == ((2.0, 1.0),)


def test_other_bodies_are_shown_until_they_are_not_seen_any_more(listening: Listening) -> None:
    feed, pilot, clock, bus = listening
    pilot.advance(0.01)
    state = feed.state(0.0)
    assert state is not None and [body.name for body in state.others] == ["visitor"]
    clock.advance(3.0)
    bus.publish(FRAME_TOPIC, TrackedFrame(()))
    state = feed.state(0.0)
    assert state is not None and state.others == ()


def test_bodies_under_ever_new_names_take_the_place_of_none_that_is_still_seen(
    listening: Listening,
) -> None:
    feed, pilot, clock, bus = listening
    sofa = FurnitureConfig(name="the sofa", body="Sofa", model="sofa", length=2.4, width=0.9)
    feed.furniture = (sofa,)
    pilot.advance(0.01)
    pose = Pose((2.0, 1.0, 0.5))
    for turn in range(20):
        names = ["visitor", *(["Sofa"] if turn == 0 else []), *(f"{turn}.{n}" for n in range(100))]
        seen = tuple(Sighting(name, pose, clock.now(), clock.now()) for name in names)
        bus.publish(FRAME_TOPIC, TrackedFrame(seen))
        clock.advance(0.1)
    assert len(feed._others) == 256
    state = feed.state(0.0)
    assert state is not None
    shown = {body.name for body in state.others}
    assert {"visitor", "the sofa", "19.99"} <= shown and "0.0" not in shown
    clock.advance(3.0)
    state = feed.state(0.0)
    assert state is not None and [body.name for body in state.others] == ["the sofa"]
    assert list(feed._others) == ["Sofa"]


def test_furniture_is_shown_as_it_lies_for_as_long_as_the_pilot_remembers_it(
    listening: Listening,
) -> None:
    feed, pilot, clock, bus = listening
    cart = FurnitureConfig(
        name="the cart", body="Cart", length=0.8, width=0.4, x=0.1, remembered=10.0
    )
    sofa = FurnitureConfig(name="the sofa", body="Sofa", model="sofa", length=2.4, width=0.9)
    feed.furniture = (cart, sofa)
    pilot.advance(0.01)
    now = clock.now()
    seen = tuple(Sighting(body, Pose((2.0, 1.0, 0.5)), now, now) for body in ("Cart", "Sofa"))
    bus.publish(FRAME_TOPIC, TrackedFrame(seen))
    shown: list[list[str]] = []
    for _ in range(2):
        state = feed.state(0.0)
        assert state is not None
        shown.append([body.name for body in state.others if body.size[0]])
        if shown == [["the cart", "the sofa"]]:
            assert (state.others[-2].position, state.others[-2].size) == ((2.1, 1.0), (0.8, 0.4))
        clock.advance(11.0)
    assert shown == [["the cart", "the sofa"], ["the sofa"]]


def test_link_and_notes_of_our_own_are_kept(listening: Listening) -> None:
    feed, _, _, bus = listening
    bus.publish(TOPICS.link, LinkStatus(1.0, tracking_rate_hz=99.0))
    link = feed.link()
    assert link is not None and link.link.tracking_rate_hz == 99.0
    feed.log_event(Severity.WARNING, "order", "Anna: STOP")
    assert feed.events_after(0)[-1].text == "Anna: STOP"


def test_a_step_without_telemetry_and_estimate_can_be_shown(listening: Listening) -> None:
    feed, pilot, _, bus = listening
    pilot.advance(0.01)
    step = feed.step
    assert step is not None
    outputs = replace(
        step.outputs,
        estimate=None,
        reference=None,
        events=(Event(1.0, Severity.INFO, EventCode.GOING_ON, "y"),),
    )
    bus.publish(
        TOPICS.step,
        PilotStep(step.sequence + 1, 1.0, replace(step.inputs, telemetry=None), outputs),
    )
    state = feed.state(0.0)
    assert state is not None and state.position is None and state.battery is None


def test_a_new_pilot_that_is_not_stopped_is_no_resume(listening: Listening) -> None:
    feed, pilot, _, _ = listening
    pilot.stopped = True
    pilot.advance(0.01)
    pilot.advance(0.01)
    assert feed.stop.holds and feed.stop.is_confirmed
    pilot.stopped, pilot.sequence = False, 0
    pilot.advance(0.01)
    assert feed.stop.holds and not feed.stop.is_confirmed
    pilot.stopped = True
    pilot.advance(0.01)
    pilot.stopped = False
    pilot.advance(0.01)
    assert not feed.stop.holds


WAY = ((1.0, 1.0), (2.0, 1.5), (3.0, 1.5))
IN_SPACE = PlannedTrajectory(
    100.0,
    tuple(TrajectoryPoint((x, y, 1.0 + 0.1 * k), 0.5 * k, 0.2 * k) for k, (x, y) in enumerate(WAY)),
)


@pytest.mark.parametrize("path_first", [True, False])
def test_a_path_in_space_is_shown_with_heights_times_and_speeds_whichever_comes_first(
    listening: Listening, *, path_first: bool
) -> None:
    feed, pilot, _, bus = listening
    pilot.path = Path(WAY, 2.1, 0.4)
    if path_first:
        pilot.advance(0.0)
        shown = feed.path()
        assert (shown.waypoints, shown.speeds) == (WAY, ())
    bus.publish(TOPICS.trajectory, IN_SPACE)
    pilot.advance(0.0)
    shown = feed.path()
    assert shown.heights == (1.0, 1.1, 1.2)
    assert (shown.times, shown.speeds) == ((0.0, 0.5, 1.0), (0.0, 0.2, 0.4))
    state = feed.state(0.0)
    assert state is not None and state.path == shown.number
    bus.publish(TOPICS.trajectory, replace(IN_SPACE, at=101.0))
    assert feed.path().number == shown.number, "the same again is nothing new"
    later = tuple(replace(point, time=2.0 * point.time) for point in IN_SPACE.points)
    bus.publish(TOPICS.trajectory, replace(IN_SPACE, points=later))
    assert feed.path().times == (0.0, 1.0, 2.0) and feed.path().number > shown.number


def test_speeds_of_another_path_are_never_shown_on_this_one(listening: Listening) -> None:
    feed, pilot, _, bus = listening
    pilot.path = Path(WAY, 2.1, 0.4)
    pilot.advance(0.0)
    bus.publish(TOPICS.trajectory, IN_SPACE)
    pilot.path = Path(tuple(reversed(WAY)), 2.1, 0.4)
    pilot.advance(0.0)
    assert feed.path().speeds == feed.path().heights == feed.path().times == ()


def test_the_stopping_distance_is_that_of_the_collision_monitor(listening: Listening) -> None:
    feed, pilot, _, bus = listening
    pilot.advance(0.01)
    step = feed.step
    assert step is not None and step.outputs.estimate is not None
    for speed in (0.0, 0.5, 1.5):
        flown = replace(step.outputs.estimate, velocity=(0.6 * speed, 0.8 * speed, 0.0))
        bus.publish(TOPICS.step, replace(step, outputs=replace(step.outputs, estimate=flown)))
        state = feed.state(0.0)
        assert state is not None
        assert state.stopping_distance == pytest.approx(speed**2 / 2.0 + 0.3 * speed)
