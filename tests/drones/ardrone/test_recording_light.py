"""The drone blinks while its camera is recorded, and its commands keep their time."""

from __future__ import annotations

import asyncio
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.drones.ardrone.recording_light import (
    LED_INTERVAL_MIN,
    LIGHT_TIMEOUT,
    RECORDING_LED,
    REPEAT_PERIOD,
    STANDARD_LED,
    RecordingLight,
)
from housefly.messages import Action, DroneStatus, Setpoint
from housefly.wires.ardrone import at

TICK = 0.035
STANDARD = STANDARD_LED.animation


def played(sent: list[tuple[float, at.Led]], now: float) -> int:
    """Return what a drone shows that heard these."""
    for when, led in reversed(sent):
        if when <= now:
            return led.animation if now < when + led.seconds else STANDARD
    return STANDARD


@given(st.lists(st.tuples(st.floats(0.02, 4.0), st.booleans()), max_size=20))
def test_it_blinks_exactly_while_it_is_said_and_never_floods(
    said: list[tuple[float, bool]],
) -> None:
    light, now, was, changed_at = RecordingLight(), 100.0, False, 100.0
    sent: list[tuple[float, at.Led]] = []
    for lasts, records in said:
        light.ask(records, now)
        said_at, until = now, now + lasts
        while now < until:
            if (led := light.due(now)) is not None:
                sent.append((now, led))
            wanted = records and now - said_at <= LIGHT_TIMEOUT
            changed_at, was = changed_at if wanted is was else now, wanted
            if now - changed_at > LED_INTERVAL_MIN + TICK:
                assert (played(sent, now) == RECORDING_LED.animation) is wanted, now
            now += TICK
    assert all(b[0] - a[0] >= LED_INTERVAL_MIN for a, b in pairwise(sent))
    assert len(sent) <= 6 * len(said) + (now - 100.0) / REPEAT_PERIOD


def test_a_drone_that_is_never_recorded_hears_nothing_of_lights() -> None:
    light = RecordingLight()
    assert [light.due(0.035 * n) for n in range(200)] == [None] * 200
    light.ask(False, 7.0)
    assert light.due(7.0) is None


@pytest.mark.wire
@pytest.mark.virtual_time
async def test_the_drone_blinks_while_it_is_said_and_commands_keep_their_cadence(flight) -> None:
    await flight.drone.connect()
    await flight.until(lambda: flight.drone.telemetry.status is DroneStatus.FLYING, Action.TAKE_OFF)
    assert flight.world.truth().leds == STANDARD
    flight.radio.commands.clear()
    for _ in range(8):
        flight.drone.show_recording(True)
        await flight.hold(Action.FLY, Setpoint(theta=0.05), seconds=0.25)
        assert flight.world.truth().leds == RECORDING_LED.animation
    flight.drone.show_recording(False)
    await flight.until(
        lambda: flight.world.truth().leds == STANDARD, Action.FLY, Setpoint(theta=0.05), seconds=1.0
    )
    parsed = [at.parse_datagram(one).commands for one in flight.radio.commands]
    lights = [one for one in parsed if isinstance(one[0].command, at.Led)]
    assert all(len(one) == 1 for one in lights), "in datagrams of their own"
    assert 4 <= len(lights) <= 8
    numbers = [command.sequence for one in parsed for command in one]
    assert numbers == sorted(numbers)
    moves = sum(any(isinstance(one.command, at.Pcmd) for one in each) for each in parsed)
    usual = 2.0 / airframe_named("ardrone").link.interval
    assert moves >= 0.5 * usual, "as many setpoints as without a light"
    assert flight.server.counters.stale_commands == 0
    assert flight.server.counters.malformed == 0


@pytest.mark.wire
@pytest.mark.virtual_time
async def test_without_another_word_and_over_a_bad_radio_no_light_stays_on(flight) -> None:
    flight.radio.loss = 0.3
    await flight.drone.connect()
    async with asyncio.timeout(30.0):
        # A lost datagram lets the light go out for a moment.
        while flight.world.truth().leds != RECORDING_LED.animation:
            flight.drone.show_recording(True)
            await flight.hold(Action.IDLE, seconds=0.25)
    await flight.hold(Action.IDLE, seconds=LIGHT_TIMEOUT)
    await flight.until(lambda: flight.world.truth().leds == STANDARD, Action.IDLE)
    await asyncio.sleep(0.3)
    assert flight.world.truth().leds == STANDARD
