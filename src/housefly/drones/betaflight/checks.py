"""What must be set on a controller before it takes off with us, in words. Pure."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, degrees

from housefly.drones.betaflight.height import HeightModel
from housefly.messages.words import Words, joined, literal
from housefly.wires.betaflight.arming import ArmingFlag, told_flags
from housefly.wires.betaflight.settings import (
    Box,
    FailsafeProcedure,
    FcSettings,
    RatesType,
    SilentChannel,
)
from housefly.wires.betaflight.sticks import throttle_position
from housefly.wires.betaflight.switches import Switches

THROTTLE = 3
"""Its number among the channels, in the order of the firmware."""
DELAY_MIN = 1.3
"""A driver that was killed is back after this [s]: the failsafe must wait for it."""
SINKING = (0.75, 1.0)
"""Thrust over weight of its automatic landing: least and most."""
_STICKS = ("roll", "pitch", "yaw", "throttle")


@dataclass(frozen=True, slots=True)
class _Need:
    """One setting.

    Attributes:
        setting: its name in the command line of the firmware.
        allowed: what is allowed, in words.
        value: what it is, in words.
        is_met: whether that is allowed.
        why: what it would do otherwise.
    """

    setting: str
    allowed: str
    value: str
    is_met: bool
    why: str


def lacking_settings(
    fc: FcSettings, switches: Switches | Box, model: HeightModel, tilt_max: float
) -> tuple[Words, ...]:
    """Return what is not set as it must be.

    Args:
        fc: how it is set.
        switches: what its switches do, or the mode that none turns on.
        model: gives the thrust of its automatic landing.
        tilt_max: largest lean that is asked for [rad].
    """
    return tuple(
        Words(
            "set {setting} to {allowed} on the drone (it is {value}): {why}",
            setting=need.setting,
            allowed=need.allowed,
            value=need.value,
            why=literal(need.why),
        )
        for need in _needs(fc, switches, model, tilt_max)
        if not need.is_met
    )


def _needs(
    fc: FcSettings, switches: Switches | Box, model: HeightModel, tilt_max: float
) -> Iterator[_Need]:
    if isinstance(switches, Box):
        yield _Need(
            f"aux {switches.name}", "a switch", "none", False, "nobody else turns that mode on"
        )
    has_override = Box.MSP_OVERRIDE in fc.boxes
    yield _Need(
        "msp_override_channels_mask",
        "what our sticks and switches are",
        "0",
        fc.receiver_is_msp or has_override,
        "it flies by a radio alone; or make MSP its receiver",
    )
    least = ceil(degrees(tilt_max) - 1e-6)
    yield _Need(
        *("angle_limit", f"{least} to 80", f"{fc.angle_limit}", least <= fc.angle_limit <= 80),
        "full sticks lean less than the site allows, or the drone falls over",
    )
    tuning = fc.tuning
    yield _Need(
        *("thr_expo", "0", f"{tuning.throttle_expo}", tuning.throttle_is_straight),
        "throttle must go to the motors as it comes: thr_hover as thr_mid, no throttle limit",
    )
    axes = (tuning.roll, tuning.pitch, tuning.yaw)
    is_bent = tuning.kind is RatesType.QUICK and any(axis.expo for axis in axes)
    yield _Need("roll_expo", "0", "more", not is_bent, "of quick rates that is not told enough")
    kind, value = fc.silent[THROTTLE] if len(fc.silent) > THROTTLE else (SilentChannel.AUTO, 0)
    yield _Need(
        *("rxfail 3", "h", kind.name.lower(), kind is SilentChannel.HOLD),
        f"it falls after 0.3 s of silence (now {value} us)",
    )
    yield from _failsafe_needs(fc, model)


def _failsafe_needs(fc: FcSettings, model: HeightModel) -> Iterator[_Need]:
    failsafe = fc.failsafe
    yield _Need(
        *("failsafe_delay", "13 to 50", f"{10 * failsafe.delay:.0f}"),
        DELAY_MIN <= failsafe.delay <= 5.0,
        "a driver that starts anew needs 1.3 s, and nobody waits longer",
    )
    yield _Need(
        *("failsafe_procedure", "AUTO-LAND", failsafe.procedure.name.replace("_", "-")),
        failsafe.procedure is FailsafeProcedure.AUTO_LAND,
        "it falls, or flies home, when nobody is heard",
    )
    low, high = (throttle_position(model.throttle(thrust), fc) for thrust in SINKING)
    yield _Need(
        *("failsafe_throttle", f"{low} to {high}", f"{failsafe.throttle}"),
        low <= failsafe.throttle <= high,
        "that sinks slowly",
    )
    yield _Need(
        *("failsafe_landing_time", "3 to 20", f"{failsafe.landing_time:g}"),
        3.0 <= failsafe.landing_time <= 20.0,
        "after that its motors are off",
    )


def lacking_channels(lacking: frozenset[int], fc: FcSettings) -> Words:
    """Return that channels are not ours, and which mask would make them so.

    Args:
        lacking: by their numbers, in the order of the firmware.
        fc: gives the order on the wire.
    """
    bits = {fc.order[one] if one < len(_STICKS) else one for one in lacking}
    mask = sum(1 << bit for bit in bits)
    names = [_STICKS[one] if one < len(_STICKS) else f"AUX{one - 3}" for one in sorted(lacking)]
    return Words(
        "set {setting} to {allowed} on the drone (it is {value}): {why}",
        setting="msp_override_channels_mask",
        allowed=f"... | {mask}",
        value=f"without {mask}",
        why=literal(f"these are not ours: {', '.join(names)}"),
    )


def refusal(blocked: ArmingFlag) -> Words | None:
    """Return why it does not arm, in its own words; None for nothing."""
    told = told_flags(blocked)
    if not told:
        return None
    why = joined("; ", tuple(map(literal, told)))
    return joined(": ", (Words("the drone will not {what}", what="arm"), why))
