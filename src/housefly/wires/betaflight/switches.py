"""Which positions of the switches arm a Betaflight, hold it level, and leave all else off."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.wires.betaflight.settings import Box, ModeRange

STICKS = 4
SWITCHES_MAX = 14
CHANNELS_MIN = 8
"""Fewer channels are not sent: some receivers' code expects as many."""
_POSITIONS = (1000, 1100, 1200, 1300, 1400, 1500, 1600, 1700, 1800, 1900, 2000)
_WANTED = frozenset({Box.ANGLE, Box.PREARM})
_UNWANTED = frozenset(Box) - _WANTED - {Box.ARM}


@dataclass(frozen=True, slots=True)
class Switches:
    """Positions of all switches [us], the first behind the sticks.

    Attributes:
        armed, disarmed: positions that arm it, and that do not.
        own: which switches have to be ours: those that arm it, and those that hold it level.
    """

    armed: tuple[int, ...]
    disarmed: tuple[int, ...]
    own: frozenset[int]


def switches_of(ranges: tuple[ModeRange, ...]) -> Switches | Box:
    """Return the positions, or the mode that no position turns on: ARM or ANGLE.

    Args:
        ranges: how the controller is set.
    """
    count = max([CHANNELS_MIN - STICKS, *(one.switch + 1 for one in ranges)])
    count = min(count, SWITCHES_MAX)
    armed = tuple(_position(ranges, switch, arms=True) for switch in range(count))
    disarmed = tuple(_position(ranges, switch, arms=False) for switch in range(count))
    for box, positions in ((Box.ARM, armed), (Box.ANGLE, armed), (Box.ANGLE, disarmed)):
        if box not in boxes_at(ranges, positions):
            return box
    if Box.ARM in boxes_at(ranges, disarmed):
        return Box.ARM
    own = {one.switch for one in ranges if one.box in (Box.ARM, Box.ANGLE) and one.switch < count}
    return Switches(armed, disarmed, frozenset(own))


def boxes_at(ranges: tuple[ModeRange, ...], positions: tuple[int, ...]) -> frozenset[int]:
    """Return the modes that are on with the switches at some positions [us]."""
    return frozenset(
        one.box
        for one in ranges
        if one.switch < len(positions) and one.holds(positions[one.switch])
    )


def _position(ranges: tuple[ModeRange, ...], switch: int, *, arms: bool) -> int:
    """Return the lowest position of a switch that turns on most of what is wanted, least else."""
    here = tuple(one for one in ranges if one.switch == switch)

    def harm(position: int) -> tuple[int, int]:
        on = {one.box for one in here if one.holds(position)}
        worst = sum(box in _UNWANTED for box in on) + ((Box.ARM in on) is not arms)
        return worst - len(on & _WANTED), position

    has_arm = any(one.box == Box.ARM for one in here)
    if not has_arm:
        arms = False
    return min(_POSITIONS, key=harm)
