"""What a flight tells the room."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from housefly.bus.codec import from_cdr, to_cdr
from housefly.hub.api.answers import EventsAnswer
from housefly.hub.api.json import answer_from_json, answer_to_json
from housefly.hub.api.questions import EventsQuestion
from housefly.hub.flight_facts import FlightFacts
from housefly.hub.said import event_answer
from housefly.hub.store.open import open_store
from housefly.messages import (
    Action,
    Command,
    Estimate,
    Event,
    EventCode,
    Inputs,
    Observation,
    Order,
    OrderKind,
    Outputs,
    Phase,
    PilotStep,
    Pose,
    RoomEvent,
    Severity,
    Sighting,
)
from housefly.messages.words import Words, figure

ZERO = 1_000_000.0


def step(sequence: int, phase: Phase = Phase.IDLE, **inputs: object) -> PilotStep:
    outputs = Outputs(
        Command(Action.IDLE),
        Estimate(2.0, (1.0, 2.0, 3.0), (0.0, 0.0, 0.0), 0.0, 0.0, 0.1),
        phase=phase,
    )
    return PilotStep(sequence, 2.0, Inputs(**inputs), outputs)  # type: ignore[arg-type]


def told(facts: FlightFacts, *steps: PilotStep) -> list[Observation | RoomEvent]:
    return [item for one in steps for item in facts.items_of(one, ZERO)]


def test_a_sighting_is_an_observation_in_unix_time() -> None:
    sighting = Sighting("ardrone", Pose((1.0, 2.0, 3.0)), 1.9, 1.95)
    seen = FlightFacts("ardrone", "vicon", {"Chair 3": "chair"}).seen(sighting, ZERO)
    assert (seen.thing, seen.source, seen.captured_at, seen.position) == (
        "ardrone",
        "vicon",
        ZERO + 1.9,
        (1.0, 2.0, 3.0),
    )


def test_tracked_furniture_is_called_by_its_id_and_other_bodies_by_their_names() -> None:
    facts = FlightFacts("ardrone", "vicon", {"Chair 3": "chair"})
    for body, thing in (("Chair 3", "chair"), ("somebody", "somebody")):
        seen = facts.seen(Sighting(body, Pose((1.0, 2.0, 3.0)), 1.9, 1.95), ZERO)
        assert seen.thing == thing


def test_the_pilots_own_belief_comes_ten_times_a_second_with_its_variance() -> None:
    believed = told(
        FlightFacts("ardrone", "vicon", {"Chair 3": "chair"}),
        *(step(number) for number in range(30)),
    )
    assert len(believed) == 3
    assert believed[0].covariance == (0.1**2, 0.0, 0.0, 0.1**2, 0.0, 0.1**2)


def test_a_flight_begins_and_ends_once_and_says_who_asked() -> None:
    order = Order(OrderKind.SERVICE, "entrance", sender="somebody")
    flown = told(
        FlightFacts("ardrone", "vicon", {"Chair 3": "chair"}),
        step(1),
        step(2, Phase.TAKING_OFF, orders=(order,)),
        step(3, Phase.TAKING_OFF),
        step(4, Phase.OUTBOUND),
        step(5, Phase.LOOKING),
        step(6, Phase.LANDING),
        step(7, Phase.IDLE),
        step(8, Phase.IDLE),
    )
    assert [item.kind for item in flown] == ["flight started", "looking", "flight ended"]
    assert flown[0].cause == "somebody"


def test_what_the_pilot_says_to_people_is_remembered() -> None:
    outputs = Outputs(
        Command(Action.IDLE),
        events=(Event(1.5, Severity.WARNING, EventCode.TRACKING_LOST, "unseen for 2 s"),),
    )
    (event,) = told(
        FlightFacts("ardrone", "vicon", {"Chair 3": "chair"}), PilotStep(1, 2.0, Inputs(), outputs)
    )
    assert (event.kind, event.at) == ("tracking lost", ZERO + 1.5)
    assert dict(event.facts) == {"severity": "warning", "words": "unseen for 2 s"}


def test_what_the_pilot_says_keeps_its_template_in_the_memory(tmp_path: Path) -> None:
    text = Words("{d} m left", d=figure(3.2, ".1f"))
    event = Event(2.0, Severity.INFO, EventCode.GOING_ON, text)
    flown = replace(step(1), outputs=Outputs(Command(Action.IDLE), events=(event,)))
    (kept,) = told(FlightFacts("ardrone", "vicon", {}), flown)
    store = open_store(tmp_path / "room.db")
    store.write((), [kept])
    (read,) = store.events(0.0, 2.0 * ZERO)
    store.close()
    assert event_answer(read).words.template == text.template
    assert from_cdr(RoomEvent, to_cdr(read)) == read
    assert (
        answer_from_json(EventsQuestion(), answer_to_json(EventsAnswer((event_answer(read),))))
        .events[0]
        .words.values
        == text.values
    )


def test_of_what_0_2_0_kept_and_of_devices_the_text_is_said() -> None:
    old = RoomEvent("going on", "drone", 1.0, "pilot", facts=(("words", "going on: 2 m"),))
    assert event_answer(old).words == "going on: 2 m"
    assert event_answer(replace(old, source="bell", kind="bell pressed")).words == "bell pressed"
