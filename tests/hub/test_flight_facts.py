"""What a flight tells the room."""

from __future__ import annotations

from housefly.hub.flight_facts import FlightFacts
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
