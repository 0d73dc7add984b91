"""The simulated controller: arming, modes, what it does with old sticks and with none."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.drone import DroneConfig
from housefly.twin.betaflight.failsafe import Phase
from housefly.twin.betaflight.firmware import BetaflightFirmware
from housefly.twin.betaflight.receiver import FRESH_FOR, LOST_AFTER
from housefly.twin.simulated_body import CONTROL_PERIOD, SensorReading, Wrench
from housefly.wires.betaflight.arming import ArmingFlag
from housefly.wires.betaflight.settings import (
    Box,
    FailsafeProcedure,
    FailsafeSettings,
    FcSettings,
    SilentChannel,
)

STILL = SensorReading(0.0, 0.0, 0.0, (0.0, 0.0, 0.0), 0.05, 0.0, 0.0, 0.0, (0.0, 0.0, 9.8))
OFF, ON = 1000, 1800
VOLTS = 12.0


def sticks(throttle: int = 1000, arm: int = OFF, angle: int = ON) -> tuple[int, ...]:
    """Return channels in the order of the wire."""
    return 1500, 1500, throttle, 1500, arm, angle, OFF, OFF


def made() -> BetaflightFirmware:
    return BetaflightFirmware(DroneConfig(kind="betaflight"))


def run(
    firmware: BetaflightFirmware,
    seconds: float,
    channels: tuple[int, ...] | None = None,
    measured: SensorReading = STILL,
) -> Wrench:
    """Let it run; channels come fifty times a second, None lets it hear nothing."""
    wrench = Wrench(0.0, 0.0, 0.0, 0.0)
    for step in range(round(seconds / CONTROL_PERIOD)):
        if channels is not None and step % 4 == 0:
            firmware.hear(channels)
        wrench = firmware.step(measured, VOLTS, 0.0)
    return wrench


def armed() -> BetaflightFirmware:
    firmware = made()
    run(firmware, 0.7, sticks())
    run(firmware, 0.1, sticks(arm=ON))
    assert firmware.is_armed
    return firmware


def test_it_arms_by_its_switch_once_sticks_have_come_for_half_a_second() -> None:
    firmware = made()
    run(firmware, 0.3, sticks())
    assert ArmingFlag.RX_FAILSAFE in firmware.blocked
    run(firmware, 0.4, sticks())
    assert firmware.blocked == ArmingFlag(0)
    run(firmware, 0.05, sticks(arm=ON))
    assert firmware.is_armed and firmware.box_bits & 1


@pytest.mark.parametrize(
    ("channels", "measured", "flag"),
    [
        (sticks(throttle=1200, arm=ON), STILL, ArmingFlag.THROTTLE),
        (sticks(arm=ON), STILL._replace(phi=0.6), ArmingFlag.ANGLE),
    ],
)
def test_what_forbids_arming_is_told_and_the_switch_must_go_off_first(
    channels: tuple[int, ...], measured: SensorReading, flag: ArmingFlag
) -> None:
    firmware = made()
    run(firmware, 0.7, sticks())
    run(firmware, 0.2, channels, measured)
    assert not firmware.is_armed
    assert flag in firmware.blocked and ArmingFlag.ARM_SWITCH in firmware.blocked
    run(firmware, 0.2, sticks(arm=ON))
    assert not firmware.is_armed and firmware.blocked == ArmingFlag.ARM_SWITCH
    run(firmware, 0.1, sticks())
    run(firmware, 0.1, sticks(arm=ON))
    assert firmware.is_armed


def test_its_switch_stops_its_motors_at_once() -> None:
    firmware = armed()
    assert run(firmware, 0.3, sticks(1400, ON)).thrust > 1.0
    assert run(firmware, CONTROL_PERIOD, sticks(1400, OFF)).thrust == 0.0


def test_throttle_is_thrust_and_nothing_holds_a_height() -> None:
    thrusts = []
    for throttle in (1000, 1200, 1400, 1800):
        firmware = armed()
        thrusts.append(run(firmware, 0.5, sticks(throttle, ON)).thrust)
    assert thrusts == sorted(thrusts) and thrusts[0] < 0.2
    fallen = armed()
    run(fallen, 0.5, sticks(1400, ON))
    sinking = run(fallen, 0.1, sticks(1400, ON), STILL._replace(climb=-2.0, height=1.0))
    assert sinking.thrust == pytest.approx(thrusts[2], rel=0.01)


def test_without_the_angle_mode_a_centred_stick_does_not_level_it() -> None:
    leaning = STILL._replace(phi=0.2)
    levelled, turned = armed(), armed()
    assert run(levelled, 0.2, sticks(1400, ON), leaning).roll < -0.01
    assert run(turned, 0.2, sticks(1400, ON, angle=OFF), leaning).roll == 0.0


@given(st.floats(0.0, 1.4))
def test_in_silence_sticks_are_held_for_three_tenths_then_centred(silence: float) -> None:
    firmware = armed()
    tilted = (1600, 1500, 1400, 1500, ON, ON, OFF, OFF)
    run(firmware, 0.2, tilted)
    run(firmware, silence)
    roll, _, _, throttle = firmware.receiver.channels[:4]
    assert throttle == 1400, "rxfail 3 h"
    if silence < FRESH_FOR - 0.03:
        assert roll == 1600
    elif silence > FRESH_FOR + 0.01:
        assert roll == 1500
    if silence > LOST_AFTER + 0.01:
        assert firmware.com_lost


def test_by_its_own_default_the_throttle_goes_first_and_it_disarms_after_a_second_and_a_half() -> (
    None
):
    firmware = armed()
    firmware.settings = replace(
        firmware.settings, failsafe=FailsafeSettings(), silent=FcSettings().silent
    )
    run(firmware, 0.2, sticks(1400, ON))
    assert run(firmware, 0.28).thrust > 3.0
    assert run(firmware, 0.3).thrust < 0.5 and firmware.is_armed
    run(firmware, 0.85)
    assert firmware.is_armed
    run(firmware, 0.15)
    assert not firmware.is_armed and ArmingFlag.FAILSAFE in firmware.blocked


def test_as_the_page_sets_it_it_sinks_level_and_disarms_after_its_landing_time() -> None:
    firmware = armed()
    run(firmware, 0.2, sticks(1400, ON))
    run(firmware, 1.6)
    assert firmware.failsafe.phase is Phase.LANDING and firmware.is_armed
    body = DroneConfig(kind="betaflight").airframe.body
    wrench = run(firmware, 1.0)
    assert wrench.thrust == pytest.approx(0.97 * 9.80665 * body.mass, rel=0.02)
    run(firmware, firmware.settings.failsafe.landing_time)
    assert not firmware.is_armed


def test_sticks_that_come_back_take_it_over_from_its_landing() -> None:
    firmware = armed()
    run(firmware, 0.2, sticks(1400, ON))
    run(firmware, 2.0)
    run(firmware, 0.7, sticks(1400, ON))
    assert firmware.failsafe.phase is Phase.IDLE and firmware.is_armed


def test_a_channel_overrides_a_radio_only_with_mask_switch_and_while_it_is_fresh() -> None:
    firmware = made()
    firmware.settings = replace(firmware.settings, features=0)
    receiver = firmware.receiver
    receiver.radio, receiver.override_mask = (1500, 1500, 1000, 1500, OFF, OFF, ON, OFF), 0b0011
    ours = (1600, 1600, 1600, 1600, ON, ON, OFF, OFF)
    run(firmware, 0.2, ours)
    assert receiver.channels[:4] == (1600, 1600, 1500, 1000), "roll and pitch are in the mask"
    assert Box.MSP_OVERRIDE in firmware.boxes and Box.MSP_OVERRIDE in firmware.on
    run(firmware, FRESH_FOR + 0.02)
    assert receiver.channels[:2] == (1500, 1500), "ours are too old"
    receiver.radio = (1500, 1500, 1000, 1500, OFF, OFF, OFF, OFF)
    run(firmware, 0.2, ours)
    assert receiver.channels[:2] == (1500, 1500), "its switch is off"


@pytest.mark.parametrize("procedure", FailsafeProcedure)
def test_a_drone_that_stood_with_its_motors_idle_is_switched_off_by_any_failsafe(
    procedure: FailsafeProcedure,
) -> None:
    firmware = armed()
    failsafe = replace(firmware.settings.failsafe, procedure=procedure)
    firmware.settings = replace(firmware.settings, failsafe=failsafe)
    run(firmware, 10.5, sticks(arm=ON))
    run(firmware, 1.6)
    assert not firmware.is_armed


def test_a_channel_that_is_set_for_silence_says_that() -> None:
    firmware = armed()
    silent = ((SilentChannel.SET, 1234), *firmware.settings.silent[1:])
    firmware.settings = replace(firmware.settings, silent=silent)
    run(firmware, 0.2, sticks(1400, ON))
    run(firmware, 0.4)
    assert firmware.receiver.channels[0] == 1234
