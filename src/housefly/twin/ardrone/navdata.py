"""Navdata packets of the simulated drone: state bits, numbering, and the kind that the client
chose.
"""

from __future__ import annotations

from housefly.twin.ardrone.link import Link
from housefly.twin.ardrone.options import demo_options, full_options
from housefly.twin.contracts import Flight, Onboard
from housefly.wires.ardrone.layout import Structure
from housefly.wires.ardrone.navdata import DroneState, RawOption, encode_navdata

ALWAYS = (
    DroneState.ALTITUDE_CONTROL
    | DroneState.CAMERA_READY
    | DroneState.PIC_VERSION_OK
    | DroneState.AT_THREAD
    | DroneState.NAVDATA_THREAD
    | DroneState.VIDEO_THREAD
    | DroneState.ACQUISITION_THREAD
)
"""Bits set in every recorded packet, landed or flying."""

AIRBORNE = frozenset({Flight.TAKING_OFF, Flight.FLYING, Flight.HOVERING, Flight.LANDING})


def state_bits(onboard: Onboard, link: Link, demo: bool) -> int:
    """Return the 32 state bits of the header; ``demo`` tells the chosen kind of navdata."""
    flying = onboard.flight in AIRBORNE
    conditions = (
        (flying, DroneState.FLYING | DroneState.VISION | DroneState.USER_START),
        (link.acknowledged, DroneState.COMMAND_ACK),
        (demo and not link.bootstrap, DroneState.NAVDATA_DEMO),
        (link.bootstrap, DroneState.NAVDATA_BOOTSTRAP),
        (onboard.motors_problem, DroneState.MOTORS_PROBLEM),
        (onboard.com_lost, DroneState.COM_LOST),
        (onboard.low_battery, DroneState.BATTERY_LOW),
        (onboard.angles_out_of_range, DroneState.ANGLES_OUT_OF_RANGE),
        (onboard.com_watchdog, DroneState.COM_WATCHDOG),
        (onboard.flight is Flight.EMERGENCY, DroneState.EMERGENCY),
    )
    bits = int(ALWAYS)
    for holds, flag in conditions:
        if holds:
            bits |= flag.value
    return bits


class NavdataWriter:
    """Numbers the packets and writes the kind that the client chose.

    Attributes:
        demo: True for the short packets; ``general:navdata_demo``.
    """

    def __init__(self, link: Link, tells_vertical_speed: bool) -> None:
        self.demo = False
        self._link = link
        self._tells_vertical_speed = tells_vertical_speed
        self._sequence = 0

    @property
    def full(self) -> bool:
        """Whether the next packet is a full one."""
        return not (self.demo or self._link.bootstrap)

    def packet(self, onboard: Onboard) -> bytes:
        """Return the next packet: bootstrap, demo or full."""
        self._sequence = self._sequence % 0xFFFFFFFF + 1
        return encode_navdata(
            state_bits(onboard, self._link, self.demo), self._sequence, self._options(onboard)
        )

    def _options(self, onboard: Onboard) -> tuple[Structure | RawOption, ...]:
        if self._link.bootstrap:
            return ()
        return (demo_options if self.demo else full_options)(onboard, self._tells_vertical_speed)
