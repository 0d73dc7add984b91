"""The simulated devices: they send what their kind's table reads and what the scene holds."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest

from housefly.messages import Observation, RoomEvent
from housefly.twin.people import Act, Posture, load_scene, scene_from_tree
from housefly.twin.sensors.devices import DeviceMessage, SimulatedDevices
from housefly.wires.devices import Channel, Delivered, Placement, Reading, decode_reading

UNIX = 1_800_000_000.0
BSEN = load_scene("bsen")
THINGS = Placement(things={thing.tag: thing.name for thing in BSEN.script.things})


def play(seconds: float, period: float = 0.05) -> list[tuple[float, DeviceMessage]]:
    devices = SimulatedDevices(BSEN, "bsen")
    steps = range(round(seconds / period) + 1)
    return [
        (n * period, message)
        for n in steps
        for message in devices.messages(n * period, UNIX + n * period)
    ]


def read(now: float, message: DeviceMessage) -> Reading:
    return decode_reading(
        Delivered(message.address, message.channel, message.payload, UNIX + now), THINGS
    )


SENT = play(BSEN.length)


def told(kind: str) -> list[tuple[float, Reading]]:
    return [(now, read(now, message)) for now, message in SENT if message.address.kind == kind]


def facts(value: Observation | RoomEvent) -> dict[str, object]:
    return dict(value.facts)


def test_everything_that_is_sent_can_be_read_with_its_time() -> None:
    for now, message in SENT:
        reading = read(now, message)
        assert reading.unknown == () and reading.clock_error is None
        for seen in reading.observations:
            assert seen.captured_at == pytest.approx(UNIX + now, abs=0.002)


def test_the_same_scene_sends_the_same_bytes() -> None:
    assert play(20.0) == SENT[: len(play(20.0))]


def test_the_floor_sees_who_stands_in_its_area_ten_times_a_second_with_its_noise() -> None:
    readings = told("floor")
    assert len(readings) == pytest.approx(10 * BSEN.length, abs=12)
    errors = []
    for now, reading in readings:
        people = {person.name: person for person in BSEN.at(now).people}
        expected = {
            name
            for name, person in people.items()
            if person.present and person.posture is not Posture.LYING and person.position[0] > 4.8
        }
        seen = {row.thing: row for row in reading.observations[1:]}
        assert set(seen) == expected
        for name, row in seen.items():
            assert row.position is not None
            errors += [row.position[axis] - people[name].position[axis] for axis in (0, 1)]
    assert np.std(errors) == pytest.approx(0.03, rel=0.1)


def test_the_cabinet_knows_the_cup_while_it_is_in_there() -> None:
    contents = {
        now: facts(reading.observations[0])["contents"]
        for now, reading in told("cabinet")
        if reading.observations
    }
    assert set(contents.values()) == {"book,cup", "book"}
    assert [h.kind for _, reading in told("cabinet") for h in reading.events] == [
        "object taken",
        "object put",
    ]
    cup = next(
        row for _, reading in told("cabinet") for row in reading.observations if row.thing == "cup"
    )
    assert (cup.inside, facts(cup)["weight"]) == ("cabinet", 0.21)


def test_the_refrigerator_is_open_while_somebody_takes_from_it() -> None:
    taken = next(
        now
        for now, reading in told("refrigerator")
        for h in reading.events
        if h.kind == "object taken"
    )
    states = [
        (now, facts(reading.observations[0]))
        for now, reading in told("refrigerator")
        if reading.observations
    ]
    _, at_that_time = max((row for row in states if row[0] <= taken), key=lambda row: row[0])
    assert at_that_time["open"] is True
    assert states[-1][1]["open"] is False


def test_the_bed_feels_who_lies_in_it() -> None:
    states = [facts(reading.observations[0]) for _, reading in told("bed")]
    assert {state["occupied"] for state in states} == {True, False}
    assert max(float(str(state["load"])) for state in states) == pytest.approx(58.0, abs=1.0)


def test_the_bell_rings_once_and_then_the_door_opens_and_closes() -> None:
    events = [
        (now, h.kind)
        for kind in ("doorbell", "door")
        for now, reading in told(kind)
        for h in reading.events
    ]
    assert [kind for _, kind in events] == ["bell pressed", "door opened", "door closed"]
    assert [now for now, _ in events] == sorted(now for now, _ in events)


def test_somebody_moves_in_the_corridor_at_some_time() -> None:
    assert {facts(reading.observations[0])["motion"] for _, reading in told("motion")} == {
        True,
        False,
    }


def test_states_are_kept_by_the_broker_and_events_are_not() -> None:
    for _, message in SENT:
        assert message.retain is (message.channel is Channel.STATE)


def test_a_floor_sensor_that_is_turned_reports_in_its_own_frame() -> None:
    person = {"name": "ann", "start": [3.0, 4.0], "steps": []}
    floor = {"kind": "floor", "id": "f", "position": [1.0, 2.0, 0.0], "yaw": 1.2}
    devices = SimulatedDevices(
        scene_from_tree({"name": "t", "people": [person], "devices": [floor]}), "bsen"
    )
    (message,) = devices.messages(0.0)
    row = decode_reading(
        Delivered(message.address, message.channel, message.payload, UNIX),
        Placement((1.0, 2.0, 0.0), 1.2),
    ).observations[1]
    assert row.position is not None
    assert hypot(row.position[0] - 3.0, row.position[1] - 4.0) < 1e-3


def test_a_stove_draws_its_power_from_when_somebody_switches_it_on_until_off() -> None:
    readings = [
        (now, float(str(facts(seen)["power"])))
        for now, reading in told("power")
        for seen in reading.observations
    ]
    (on,), (off,) = (
        [event.at for event in BSEN.between(-1.0, BSEN.length) if event.act is act]
        for act in (Act.ON, Act.OFF)
    )
    for now, power in readings:
        if on < now < off:
            assert power == pytest.approx(1420.0, abs=25.0)
        elif now < on or now > off + 0.1:
            assert abs(power) < 25.0
    assert any(on < now < on + 0.1 for now, _ in readings)  # a change is told at once


def test_each_measuring_device_says_what_it_measures_when_on_and_off() -> None:
    kinds = ("switch", "power", "temperature", "contact", "level")
    scene = scene_from_tree(
        {
            "name": "switches",
            "devices": [
                *({"kind": kind, "id": kind} for kind in kinds),
                {"kind": "level", "id": "tank", "value_on": 99.0, "value_off": 1.0},
            ],
            "people": [
                {
                    "name": "ann",
                    "start": [0.0, 0.0],
                    "steps": [
                        {"do": "wait", "seconds": 1.0},
                        *({"do": "on", "what": what} for what in (*kinds[:3], "level", "tank")),
                        {"do": "open", "what": "contact"},
                    ],
                }
            ],
        }
    )
    devices = SimulatedDevices(scene, "bsen")
    first, last = (
        {
            seen.thing: dict(seen.facts)
            for message in devices.messages(now)
            for seen in decode_reading(
                Delivered(message.address, message.channel, message.payload, UNIX)
            ).observations
        }
        for now in (0.0, 10.0)
    )
    assert first == {
        "switch": {"on": False},
        "power": {"power": 0.4},
        "temperature": {"temperature_c": 21.0},
        "contact": {"open": False, "kind": "contact"},
        "level": {"level_percent": 20.0},
        "tank": {"level_percent": 1.0},
    }
    assert last == {
        "switch": {"on": True},
        "power": {"power": 1400.0},
        "temperature": {"temperature_c": 180.0},
        "contact": {"open": True, "kind": "contact"},
        "level": {"level_percent": 80.0},
        "tank": {"level_percent": 99.0},
    }


def test_the_floor_feels_who_lies_on_it_over_their_length_and_nobody_in_bed() -> None:
    def floor(height: float) -> list[dict[str, object]]:
        steps = [{"do": "lie", "at": [1.0, 1.0], "height": height, "seconds": 5.0}]
        scene = scene_from_tree(
            {
                "name": "lying",
                "devices": [{"kind": "floor", "id": "floor-1"}],
                "people": [{"name": "ann", "start": [0.0, 0.0], "height": 1.7, "steps": steps}],
            }
        )
        (message,) = SimulatedDevices(scene, "bsen").messages(1.0)
        reading = decode_reading(Delivered(message.address, message.channel, message.payload, UNIX))
        return [dict(seen.facts) for seen in reading.observations[1:]]

    assert floor(0.5) == []
    (felt,) = floor(0.0)
    assert felt["extent"] == pytest.approx(1.6, abs=0.1)
