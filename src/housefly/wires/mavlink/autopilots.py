"""The table of what ArduCopter and PX4 do differently, by the model of drone.

Facts: the autopilots' own parameter descriptions and user guides (docs/drones/mavlink.md).
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages.words import Words

TAKE_OFF_HEIGHT = 1.0
"""A take-off goes to this height [m]."""


@dataclass(frozen=True, slots=True)
class FlightMode:
    """A flight mode as a command names it: PX4 has a main and a sub mode, ArduPilot one number."""

    main: int
    sub: int = 0
    is_packed: bool = False

    @property
    def number(self) -> int:
        """The custom mode of a heartbeat."""
        return (self.main << 16) | (self.sub << 24) if self.is_packed else self.main


@dataclass(frozen=True, slots=True)
class ParameterNeed:
    """A parameter without which it does not take off with us.

    Attributes:
        name: of the autopilot.
        least, most: what is allowed, both included.
        why: what it would do otherwise, in words.
    """

    name: str
    least: float
    most: float
    why: Words

    def meets(self, value: float) -> bool:
        """Return whether a value is allowed."""
        return self.least - 1e-6 <= value <= self.most + 1e-6

    @property
    def allowed(self) -> str:
        """What is allowed, in words."""
        if self.least == self.most:
            return f"{self.least:g}"
        return f"{self.least:g} to {self.most:g}"


@dataclass(frozen=True, slots=True)
class Autopilot:
    """One autopilot.

    Attributes:
        name: as its makers call it.
        number: MAV_AUTOPILOT in its heartbeats.
        udp_port, tcp_port: where it listens unless it is told otherwise.
        own_port: from where it expects us on UDP; 0 for anywhere.
        steered: the mode that heeds our setpoints.
        ready: the mode in which it is armed and told to take off.
        landing: the mode that lands where it is.
        passing: modes that it goes through by itself between take-off and ours.
        stream_first: setpoints must come for a while before the mode is accepted.
        take_off_height: told with the command [m]; None where a parameter says it.
        forgets_origin: whether an origin that it took before its estimator began is lost then.
        counts_by_bits: whether whole numbers among its parameters are sent as bits of a float.
        needs: parameters without which it does not take off with us.
        modes: names for people, by number.
    """

    name: str
    number: int
    udp_port: int
    tcp_port: int
    own_port: int
    steered: FlightMode
    ready: FlightMode
    landing: FlightMode
    passing: frozenset[int]
    stream_first: bool
    take_off_height: float | None
    forgets_origin: bool
    counts_by_bits: bool
    needs: tuple[ParameterNeed, ...]
    modes: dict[int, str]

    def mode_name(self, number: int) -> str:
        """Return a mode's name for people."""
        return self.modes.get(number, str(number))


def _px4(main: int, sub: int = 0) -> FlightMode:
    return FlightMode(main, sub, is_packed=True)


_GUIDED, _COPTER_LAND = FlightMode(4), FlightMode(9)
_OFFBOARD, _HOLD, _PX4_TAKE_OFF, _PX4_LAND = _px4(6), _px4(4, 3), _px4(4, 2), _px4(4, 6)

_FLIES_ON = Words("it flies on when the ground falls silent")
_NO_POSES = Words("it does not fly by the poses that we send")

AUTOPILOTS: dict[str, Autopilot] = {
    "arducopter": Autopilot(
        name="ArduCopter",
        number=3,
        udp_port=14550,
        tcp_port=5760,
        own_port=0,
        steered=_GUIDED,
        ready=_GUIDED,
        landing=_COPTER_LAND,
        passing=frozenset(),
        stream_first=False,
        take_off_height=TAKE_OFF_HEIGHT,
        forgets_origin=True,
        counts_by_bits=False,
        needs=(
            ParameterNeed("FS_GCS_ENABLE", 5, 5, _FLIES_ON),
            ParameterNeed("GUID_TIMEOUT", 0.1, 3, _FLIES_ON),
            ParameterNeed("EK3_SRC1_POSXY", 6, 6, _NO_POSES),
            ParameterNeed("EK3_SRC1_YAW", 6, 6, _NO_POSES),
        ),
        modes={
            0: "STABILIZE", 2: "ALT_HOLD", 3: "AUTO", 4: "GUIDED", 5: "LOITER", 6: "RTL",
            9: "LAND", 16: "POSHOLD", 17: "BRAKE", 20: "GUIDED_NOGPS", 21: "SMART_RTL",
        },
    ),
    "px4": Autopilot(
        name="PX4",
        number=12,
        udp_port=14580,
        tcp_port=5760,
        own_port=14540,
        steered=_OFFBOARD,
        ready=_HOLD,
        landing=_PX4_LAND,
        passing=frozenset({_PX4_TAKE_OFF.number, _HOLD.number}),
        stream_first=True,
        take_off_height=None,
        forgets_origin=False,
        counts_by_bits=True,
        needs=(
            ParameterNeed("COM_OBL_RC_ACT", 4, 4, _FLIES_ON),
            ParameterNeed("COM_OF_LOSS_T", 0, 1, _FLIES_ON),
            ParameterNeed("EKF2_EV_CTRL", 9, 15, _NO_POSES),
            ParameterNeed(
                "MIS_TAKEOFF_ALT", 0.8, 1.2,
                Words("it does not fly as it is told"),
            ),
        ),
        modes={
            _px4(1).number: "MANUAL", _px4(2).number: "ALTCTL", _px4(3).number: "POSCTL",
            _PX4_TAKE_OFF.number: "TAKEOFF", _HOLD.number: "HOLD", _px4(4, 5).number: "RTL",
            _PX4_LAND.number: "LAND", _OFFBOARD.number: "OFFBOARD", _px4(7).number: "STABILIZED",
        },
    ),
}  # fmt: skip
"""By the model of drone that a site names."""
