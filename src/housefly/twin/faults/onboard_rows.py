"""Rows of the fault matrix in which what a rescue flies by fails, and a person gives an order.

The drone's own sensors, its reports, the scanners, a draught that its own hover cannot hold, and
the room's process, in which tracking and scanners end together.
"""

from __future__ import annotations

from math import inf

from housefly.twin.faults.fault import Fault
from housefly.twin.faults.fault_row import FaultRow, FaultVariant
from housefly.twin.faults.vocabulary import (
    LOCKSTEP,
    WIRES,
    FaultComponent,
    FaultKind,
    Injection,
)

_C, _K = FaultComponent, FaultKind
_TWIN = LOCKSTEP | WIRES


def _variant(
    name: str,
    component: FaultComponent,
    kind: FaultKind,
    size: float | None = None,
    aspect: str = "",
) -> FaultVariant:
    return FaultVariant(name, (Fault(component, kind, aspect, magnitude=size),))


def _blind(name: str, lasting: float) -> FaultVariant:
    """Return the end of all that the room senses, for so long [s]."""
    ends = (Fault(part, _K.OFF, duration=lasting) for part in (_C.MOCAP, _C.LASER))
    return FaultVariant(name, tuple(ends))


ONBOARD_ROWS: tuple[FaultRow, ...] = (
    FaultRow(
        "F46", "the drone's optical flow fails",
        "told; held, stopped and landed by tracking; without tracking it sinks level", _TWIN,
        (
            _variant("stuck", _C.FLOW, _K.STUCK),
            _variant("off", _C.FLOW, _K.OFF),
            _variant("bias_0.6", _C.FLOW, _K.WRONG, 0.6, "bias"),
            _variant("bias_-0.4", _C.FLOW, _K.WRONG, -0.4, "bias"),
            _variant("bias_left_0.5", _C.FLOW, _K.WRONG, 0.5, "bias_left"),
            _variant("half", _C.FLOW, _K.WRONG, 0.5, "gain"),
            _variant("threefold", _C.FLOW, _K.WRONG, 3.0, "gain"),
            _variant("noise", _C.FLOW, _K.GARBAGE, 0.5),
            _variant("bias_0.2", _C.FLOW, _K.WRONG, 0.2, "bias"),
        ), True, crossed=True,
    ),
    FaultRow(
        "F47", "the drone's sonar fails",
        "told where it is far off; flown by the tracked height, and landed by it", _TWIN,
        (
            _variant("off", _C.SONAR, _K.OFF),
            _variant("stuck", _C.SONAR, _K.STUCK),
            _variant("high", _C.SONAR, _K.WRONG, 0.4),
            _variant("low", _C.SONAR, _K.WRONG, -0.4),
            _variant("noise", _C.SONAR, _K.GARBAGE, 0.3),
        ), crossed=True,
    ),
    FaultRow(
        "F48", "the drone's gyros or accelerometers fail",
        "flown on or landed by tracking, which sees how a drone leans whose attitude is stuck",
        _TWIN,
        (
            _variant("nose_up", _C.IMU, _K.WRONG, 0.05),
            _variant("nose_down", _C.IMU, _K.WRONG, -0.05),
            _variant("gyro_noise", _C.IMU, _K.GARBAGE, 0.2, "gyro"),
            _variant("acceleration_noise", _C.IMU, _K.GARBAGE, 2.0, "acceleration"),
            _variant("stuck", _C.IMU, _K.STUCK),
        ), crossed=True,
    ),
    FaultRow(
        "F49", "the scanners fail",
        "told where they fall silent; what they show for an obstacle is kept away from", _TWIN,
        (
            _variant("off", _C.LASER, _K.OFF),
            _variant("stuck", _C.LASER, _K.STUCK),
            _variant("garbage", _C.LASER, _K.GARBAGE),
            _variant("wrong", _C.LASER, _K.WRONG),
            _variant("slow", _C.LASER, _K.SLOW),
            _variant("delayed", _C.LASER, _K.DELAYED),
            _variant("intermittent", _C.LASER, _K.INTERMITTENT),
        ), crossed=True,
    ),
    FaultRow(
        "F50", "the drone's reports fail",
        "held or landed by tracking; a report that lies blames neither without a witness", _TWIN,
        (
            _variant("off", _C.TELEMETRY, _K.OFF),
            _variant("stuck", _C.TELEMETRY, _K.STUCK),
            _variant("garbage", _C.TELEMETRY, _K.GARBAGE),
            _variant("slow", _C.TELEMETRY, _K.SLOW),
            _variant("delayed", _C.TELEMETRY, _K.DELAYED),
            _variant("intermittent", _C.TELEMETRY, _K.INTERMITTENT, 0.6),
            _variant("order", _C.TELEMETRY, _K.WRONG, 0.3, "order"),
            _variant("yaw", _C.TELEMETRY, _K.WRONG, 0.5, "yaw"),
            _variant("height", _C.TELEMETRY, _K.WRONG, 0.4, "height"),
            _variant("velocity", _C.TELEMETRY, _K.WRONG, 0.5, "velocity"),
        ), crossed=True,
    ),
    FaultRow(
        "F51", "a draught that the drone's own hover does not hold",
        "held, stopped and landed at its place, by tracking", _TWIN,
        (
            _variant("0.7", _C.WIND, _K.WRONG, 0.7),
            _variant("1.0", _C.WIND, _K.WRONG, 1.0),
            _variant("none", _C.WIND, _K.WRONG, 0.0),
        ), crossed=True,
    ),
    FaultRow(
        "F52", "the room's process is killed or stalls: no tracking, no scanner",
        "as lost tracking: hovers, lands after 2 s or when asked; flies on when the room is back",
        LOCKSTEP | frozenset({Injection.PROCESS}),
        (
            _blind("dead", inf),
            _blind("back_after_1s", 1.0),
            _blind("back_after_4s", 4.0),
        ), crossed=True,
    ),
)  # fmt: skip
"""Each is flown with each of a person's orders, too."""
