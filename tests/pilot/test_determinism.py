from __future__ import annotations

from collections.abc import Callable
from math import isfinite
from typing import Any

from branched import branched
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lying_tracking import LiedFlight

import housefly
from housefly.geometry import quaternion_from_euler
from housefly.messages import (
    Action,
    DroneStatus,
    Inputs,
    Order,
    OrderKind,
    Pose,
    Sighting,
    Telemetry,
)
from housefly.pilot.assembly import make_pilot, warm_up
from housefly.twin.disturbance import Disturbances

Fly = Callable[..., Any]
unit = st.floats(0.0, 1.0)
poses = st.builds(
    lambda x, y, z, yaw: Pose((x, y, z), quaternion_from_euler(0.0, 0.0, yaw)),
    st.floats(1.8, 2.2),
    st.floats(1.0, 1.5),
    st.floats(0.5, 1.5),
    st.floats(-0.2, 0.2),
)
statuses = st.sampled_from(list(DroneStatus)) | st.just(DroneStatus.FLYING)
ticks = st.tuples(
    st.floats(-0.02, 0.3),
    st.none() | st.tuples(poses, st.floats(-0.02, 0.2)),
    st.none() | st.tuples(statuses, st.floats(0.0, 1.0)),
    st.none()
    | st.tuples(
        st.sampled_from(OrderKind),
        st.sampled_from(["", "entrance", "home", "moon"]),
        st.floats(0.0, 1.0),
    ),
)


def stream(series: list[Any]) -> list[tuple[float, Inputs]]:
    made, now = [], 1.0
    for step, sight, told, asked in series:
        now += step
        sightings = (Sighting("ardrone", sight[0], now - sight[1], now),) if sight else ()
        telemetry = Telemetry(now, told[0], told[1]) if told else None
        orders = (Order(asked[0], asked[1], issued_at=now - asked[2]),) if asked else ()
        made.append((now, Inputs(sightings, telemetry, orders)))
    return made


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(mode=st.sampled_from(["default", "paper"]), series=st.lists(ticks, min_size=1, max_size=30))
def test_any_input_gives_a_lawful_command_and_the_same_input_the_same_outputs(
    fly: Fly, mode: str, series: list[Any]
) -> None:
    flight = fly(mode=mode)
    one, two = (make_pilot(flight.site, flight.room, flight.grid) for _ in range(2))
    limits = flight.site.limits
    for now, inputs in stream(series):
        outputs = one.step(now, inputs)
        assert outputs == two.step(now, inputs)
        s = outputs.command.setpoint
        assert all(isfinite(value) for value in (s.theta, s.phi, s.vz, s.yaw_rate))
        assert max(abs(s.theta), abs(s.phi)) <= limits.tilt_max
        assert abs(s.vz) <= limits.full_climb and abs(s.yaw_rate) <= limits.yaw_rate_max
        assert outputs.command.action is Action.FLY or (s.theta, s.phi, s.vz, s.yaw_rate) == (
            0.0,
            0.0,
            0.0,
            0.0,
        )


def test_a_recorded_flight_replayed_gives_the_same_commands_bit_for_bit(fly: Fly) -> None:
    flight = fly(tracking={"rate_hz": 30.0, "latency": 0.03, "loss": 0.2})
    step, record = flight.pilot.step, []

    def recording(now: float, inputs: Inputs) -> Any:
        outputs = step(now, inputs)
        record.append((now, inputs, outputs))
        return outputs

    flight.pilot.step = recording
    flight.service()
    again = make_pilot(flight.site, flight.room, flight.grid)
    for now, inputs, outputs in record:
        assert again.step(now, inputs) == outputs


def test_a_flight_that_branches_off_goes_on_bit_for_bit_and_the_first_one_stays(fly: Fly) -> None:
    """Tests share how flights begin: what they then see is what each would have seen alone."""
    first, alone = fly(), fly()
    for flight in (first, alone):
        flight.take_off()
        flight.step(flight.order(OrderKind.GO, place="entrance"))
        flight.run(3.0)
    second = branched(first)
    second.wind = (0.3, 0.2)
    second.run(1.0)
    third, ahead = branched(first), []
    for _ in range(200):
        ahead.append(repr(alone.step()))
        assert repr(first.step()) == ahead[-1] == repr(third.step())
    assert second.body != first.body == third.body == alone.body


def test_a_room_that_branches_off_goes_on_bit_for_bit_and_the_first_one_stays() -> None:
    loaded = housefly.load_site("bsen")
    first, alone = (LiedFlight(housefly.Simulation(loaded)) for _ in range(2))
    for flight in (first, alone):
        flight.begin()
        flight.run(7.0)
    second = branched(first)
    second.sim.world.disturb(Disturbances(wind=(0.5, 0.0, 0.0)))
    second.run(1.0)
    third = branched(first)
    for _ in range(200):
        ahead = repr(alone.step())
        assert repr(first.step()) == ahead == repr(third.step())
    truth = alone.sim.world.truth()
    assert second.sim.world.truth() != truth == third.sim.world.truth() == first.sim.world.truth()


def test_asking_for_a_plan_changes_nothing_in_the_flight(fly: Fly) -> None:
    quiet, asked = fly(), fly()
    for flight in (quiet, asked):
        flight.take_off()
    for _ in range(100):
        answer = asked.pilot.plan((10.75, 1.25))
        assert answer.path is not None
        assert asked.step() == quiet.step()


def test_a_plan_starts_at_the_pad_before_the_drone_was_seen_then_where_it_is(fly: Fly) -> None:
    flight = fly()
    assert flight.pilot.plan((4.0, 3.0)).start == flight.room.home
    flight.run(0.5)
    start = flight.pilot.plan((4.0, 3.0)).start
    assert start != flight.room.home and abs(start[0] - flight.room.home[0]) < 0.01
    assert flight.pilot.plan((4.0, 3.0), (1.0, 3.0)).start == (1.0, 3.0)
    assert flight.pilot.plan((6.0, 1.0)).reason


def test_warming_up_compiles_without_touching_a_pilot(fly: Fly) -> None:
    for mode in ("default", "paper"):
        flight = fly(mode=mode)
        warm_up(flight.site, flight.room, flight.grid)


def test_time_that_stands_still_or_runs_backwards_does_no_harm(fly: Fly) -> None:
    flight = fly()
    flight.take_off()
    before = flight.outputs.estimate
    outputs = flight.pilot.step(flight.now - 1.0, Inputs())
    assert outputs.estimate is not None and outputs.estimate.at == before.at
