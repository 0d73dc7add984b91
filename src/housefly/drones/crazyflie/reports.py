"""What the drone logs by itself, and the report that is made of it; pure."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf, isfinite, radians

from housefly.errors import WireError
from housefly.geometry import Vec3, wrap_angle
from housefly.messages import DroneFault, DroneStatus, Telemetry
from housefly.messages.words import Words
from housefly.wires.crazyflie.crtp import Packet
from housefly.wires.crazyflie.log_blocks import read_values
from housefly.wires.crazyflie.supervisor import SupervisorInfo, info_of
from housefly.wires.crazyflie.tables import ValueType

MOTION_BLOCK, STATE_BLOCK = 0, 1
MOTION_PERIOD, STATE_PERIOD = 0.01, 0.1
"""How often the drone sends how it leans, and where it believes to be [s]."""
LOW_VOLTAGE = 3.2
"""Below it the drone itself says that its battery is low [V]."""
_TURN_RATE_MAX, _TURN_SLACK, _GAP_MAX = 3.5, 0.05, 0.5
"""It turns no faster [rad/s], its heading is no rougher [rad], and no longer gap counts [s]."""
_FLOAT = ValueType.FLOAT
BLOCKS: dict[int, tuple[float, dict[str, ValueType]]] = {
    MOTION_BLOCK: (
        MOTION_PERIOD,
        {
            "stateEstimate.roll": _FLOAT,
            "stateEstimate.pitch": _FLOAT,
            "stateEstimate.yaw": _FLOAT,
            "stateEstimate.z": _FLOAT,
            "supervisor.info": ValueType.UINT16,
        },
    ),
    STATE_BLOCK: (
        STATE_PERIOD,
        {
            "stateEstimate.x": _FLOAT,
            "stateEstimate.y": _FLOAT,
            "stateEstimate.z": _FLOAT,
            "pm.vbat": _FLOAT,
            "pm.batteryLevel": ValueType.UINT8,
        },
    ),
}
"""Period and variables of each block that is asked for; 26 bytes at most."""
_NOTHING = SupervisorInfo(0)
_GROUNDED = SupervisorInfo.IS_LOCKED | SupervisorInfo.IS_CRASHED | SupervisorInfo.IS_TUMBLED
_WORDS: tuple[tuple[SupervisorInfo, Words], ...] = (
    (
        SupervisorInfo.IS_LOCKED,
        Words("the drone has locked itself: switch it off and on"),
    ),
    (SupervisorInfo.IS_TUMBLED, Words("the drone leans")),
    (SupervisorInfo.IS_CRASHED, Words("the drone has crashed: look it over, then reset")),
    (
        SupervisorInfo.DECK_FAULT,
        Words("a deck on the drone reports a fault: switch it off and look at the deck"),
    ),
)


@dataclass(frozen=True, slots=True)
class OwnState:
    """What the drone told last.

    Attributes:
        at: when it came [s].
        phi, theta, yaw: attitude [rad], our signs; the heading is the room's once it is told.
        turned: since it was first heard, by its own word [rad].
        place: where it believes to be [m].
        info: what its supervisor says.
        voltage: of its battery [V].
        charge: 0 to 1, in steps of a tenth.
        drone_time: its clock [s].
        has_state: whether place, voltage and charge were told.
    """

    at: float = -inf
    phi: float = 0.0
    theta: float = 0.0
    yaw: float = 0.0
    turned: float = 0.0
    place: Vec3 = (0.0, 0.0, 0.0)
    info: SupervisorInfo = _NOTHING
    voltage: float = 0.0
    charge: float = 0.0
    drone_time: float = 0.0
    has_state: bool = False

    @property
    def is_flying(self) -> bool:
        """Whether it flies, by its own word."""
        return SupervisorInfo.IS_FLYING in self.info

    @property
    def is_grounded(self) -> bool:
        """Whether it does not fly, whatever it is told."""
        return bool(self.info & _GROUNDED)

    def taken_in(self, packet: Packet, now: float) -> OwnState:
        """Return it with a log packet that came now [s].

        Raises:
            WireError: of another block, too short, or with numbers that are none.
        """
        block = packet.data[0] if packet.data else -1
        if block not in BLOCKS:
            raise WireError(f"a log block that was not asked for: {block}")
        clock, values = read_values(packet, tuple(BLOCKS[block][1].values()))
        if not all(map(isfinite, values)):
            raise WireError(f"numbers that are none in log block {block}: {values}")
        if block == STATE_BLOCK:
            x, y, z, voltage, charge = values
            level = min(max(charge / 100.0, 0.0), 1.0)
            return replace(self, place=(x, y, z), voltage=voltage, charge=level, has_state=True)
        roll, pitch, heading, z, info = values
        yaw = radians(heading)
        return replace(
            self,
            at=now,
            phi=radians(roll),
            theta=-radians(pitch),
            yaw=yaw,
            turned=self._turned_to(yaw, clock / 1000.0),
            place=(self.place[0], self.place[1], z),
            info=info_of(int(info)),
            drone_time=clock / 1000.0,
        )

    def _turned_to(self, yaw: float, drone_time: float) -> float:
        """Return how far it has turned [rad]: what it takes over from poses at once is no turn."""
        if self.at == -inf:
            return 0.0
        by = wrap_angle(yaw - self.yaw)
        passed = min(abs(drone_time - self.drone_time), _GAP_MAX)
        is_turn = abs(by) <= _TURN_RATE_MAX * passed + _TURN_SLACK
        return wrap_angle(self.turned + by) if is_turn else self.turned

    def report(
        self, status: DroneStatus, *, configured: bool, notes: tuple[Words, ...]
    ) -> Telemetry:
        """Return the report; height and velocity are not measured, so they stay zero."""
        is_low = self.has_state and self.voltage < LOW_VOLTAGE
        faults = (
            *((DroneFault.BATTERY_LOW,) if is_low else ()),
            *((DroneFault.TILTED_TOO_FAR,) if SupervisorInfo.IS_TUMBLED in self.info else ()),
        )
        return Telemetry(
            received_at=self.at,
            status=status,
            battery=self.charge,
            phi=self.phi,
            theta=self.theta,
            psi=self.turned,
            faults=faults,
            configured=configured and self.has_state,
            notes=notes,
            drone_time=self.drone_time,
        )


def complaints(info: SupervisorInfo) -> tuple[Words, ...]:
    """Return what keeps a drone on the floor, in words."""
    return tuple(words for bit, words in _WORDS if bit in info)
