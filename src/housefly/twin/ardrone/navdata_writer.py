"""Navdata packets of the simulated drone: state bits, numbering, and the kind the client chose."""

from __future__ import annotations

from housefly.twin.ardrone.altitude_estimator import AltitudeEstimator
from housefly.twin.ardrone.link import Link
from housefly.twin.ardrone.navdata_options import DEMO_OPTIONS, demo_options, full_options
from housefly.twin.contracts import FlightState, OnboardState
from housefly.wires.ardrone.layout import Structure
from housefly.wires.ardrone.navdata import RawOption, StateBits, encode_navdata

_ALWAYS_SET = (
    StateBits.ALTITUDE_CONTROL
    | StateBits.CAMERA_READY
    | StateBits.PIC_VERSION_OK
    | StateBits.AT_THREAD
    | StateBits.NAVDATA_THREAD
    | StateBits.VIDEO_THREAD
    | StateBits.ACQUISITION_THREAD
)
"""Bits set in every recorded packet, landed or flying."""


def _state_bits(onboard: OnboardState, link: Link, demo: bool) -> int:
    """Return the 32 state bits of the header; ``demo`` is the chosen kind of navdata."""
    flying = onboard.flight.airborne
    conditions = (
        (flying, StateBits.FLYING | StateBits.VISION | StateBits.USER_START),
        (link.acknowledged, StateBits.COMMAND_ACK),
        (demo and not link.bootstrap, StateBits.NAVDATA_DEMO),
        (link.bootstrap, StateBits.NAVDATA_BOOTSTRAP),
        (onboard.motors_problem, StateBits.MOTORS_PROBLEM),
        (onboard.com_lost, StateBits.COM_LOST),
        (onboard.low_battery, StateBits.BATTERY_LOW),
        (onboard.angles_out_of_range, StateBits.ANGLES_OUT_OF_RANGE),
        (onboard.com_watchdog, StateBits.COM_WATCHDOG),
        (onboard.ultrasound_deaf, StateBits.ULTRASOUND_DEAF),
        (onboard.flight is FlightState.EMERGENCY, StateBits.EMERGENCY),
    )
    bits = int(_ALWAYS_SET)
    for holds, flag in conditions:
        if holds:
            bits |= flag.value
    return bits


class NavdataWriter:
    """Numbers the packets and writes the kind that the client chose.

    Attributes:
        demo: True for the short packets; ``general:navdata_demo``.
        demo_options: a bit for each tag that is in them; ``general:navdata_options``.
    """

    def __init__(self, link: Link, tells_vertical_speed: bool) -> None:
        self.demo, self.demo_options = False, DEMO_OPTIONS
        self._link = link
        self._tells_vertical_speed = tells_vertical_speed
        self._sequence = 0
        self._altitude = AltitudeEstimator()

    @property
    def full(self) -> bool:
        """Whether the next packet is a full one."""
        return not (self.demo or self._link.bootstrap)

    def packet(self, onboard: OnboardState) -> bytes:
        """Return the next packet: bootstrap, demo or full."""
        self._sequence = self._sequence % 0xFFFFFFFF + 1
        return encode_navdata(
            _state_bits(onboard, self._link, self.demo), self._sequence, self._options(onboard)
        )

    def _options(self, onboard: OnboardState) -> tuple[Structure | RawOption, ...]:
        altitude = self._altitude.altitude(onboard)
        if self._link.bootstrap:
            return ()
        if not self.demo:
            return full_options(onboard, altitude, self._tells_vertical_speed)
        return demo_options(onboard, altitude, self._tells_vertical_speed, self.demo_options)
