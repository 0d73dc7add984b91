"""The log variables and parameters of the simulated Crazyflie: a part of the firmware's own.

Attitudes are in degrees, with a pitch that is positive with the nose up, as the firmware logs them.
"""

from __future__ import annotations

from collections.abc import Callable
from math import degrees, floor

from housefly.geometry import GRAVITY
from housefly.twin.contracts import OnboardState
from housefly.twin.crazyflie.firmware import CrazyflieFirmware
from housefly.wires.crazyflie.supervisor import SupervisorInfo
from housefly.wires.crazyflie.tables import TableEntry, ValueType

Told = tuple[CrazyflieFirmware, OnboardState]
"""What a log variable is read from."""
_CELLS = 3
"""The simulated battery has the voltage of so many cells in a row; this drone has one."""
_FLOAT, _UINT8, _UINT16 = ValueType.FLOAT, ValueType.UINT8, ValueType.UINT16
_I = SupervisorInfo


def _bit(bit: SupervisorInfo) -> Callable[[Told], float]:
    return lambda told: float(bit in told[0].info)


def _place(axis: int) -> Callable[[Told], float]:
    return lambda told: told[0].estimator.position[axis]


def _speed(axis: int) -> Callable[[Told], float]:
    return lambda told: told[0].estimator.velocity[axis]


def _variance(told: Told) -> float:
    return told[0].estimator.deviation(told[0].now) ** 2


def _charge(told: Told) -> float:
    """Return the charge in percent, in steps of ten as the drone tells it."""
    return 10.0 * floor(10.0 * told[1].battery)


_ATTITUDE: dict[str, Callable[[Told], float]] = {
    "roll": lambda told: degrees(told[1].phi),
    "pitch": lambda told: -degrees(told[1].theta),
    "yaw": lambda told: degrees(told[0].estimator.yaw),
}
_LOGGED: dict[str, tuple[ValueType, Callable[[Told], float]]] = {
    **{f"stateEstimate.{axis}": (_FLOAT, _place(n)) for n, axis in enumerate("xyz")},
    **{f"stateEstimate.v{axis}": (_FLOAT, _speed(n)) for n, axis in enumerate("xyz")},
    **{f"stateEstimate.{name}": (_FLOAT, angle) for name, angle in _ATTITUDE.items()},
    **{f"stabilizer.{name}": (_FLOAT, angle) for name, angle in _ATTITUDE.items()},
    **{f"kalman.varP{axis}": (_FLOAT, _variance) for axis in "XYZ"},
    "acc.x": (_FLOAT, lambda told: told[1].acceleration[0] / GRAVITY),
    "acc.y": (_FLOAT, lambda told: told[1].acceleration[1] / GRAVITY),
    "acc.z": (_FLOAT, lambda told: told[1].acceleration[2] / GRAVITY),
    "gyro.x": (_FLOAT, lambda told: degrees(told[1].angular_rate[0])),
    "gyro.y": (_FLOAT, lambda told: degrees(told[1].angular_rate[1])),
    "gyro.z": (_FLOAT, lambda told: degrees(told[1].angular_rate[2])),
    "pm.vbat": (_FLOAT, lambda told: told[1].battery_voltage / _CELLS),
    "pm.batteryLevel": (_UINT8, _charge),
    "supervisor.info": (_UINT16, lambda told: float(told[0].info)),
    "sys.canfly": (_UINT8, _bit(_I.CAN_FLY)),
    "sys.isFlying": (_UINT8, _bit(_I.IS_FLYING)),
    "sys.isTumbled": (_UINT8, _bit(_I.IS_TUMBLED)),
}
LOG_ENTRIES = tuple(TableEntry(name, kind) for name, (kind, _) in _LOGGED.items())
"""The table of log variables."""

_DEFAULTS: dict[str, tuple[ValueType, float]] = {
    "stabilizer.estimator": (_UINT8, 1.0),
    "stabilizer.controller": (_UINT8, 1.0),
    "stabilizer.stop": (_UINT8, 0.0),
    "commander.enHighLevel": (_UINT8, 0.0),
    "kalman.resetEstimation": (_UINT8, 0.0),
    "locSrv.extPosStdDev": (_FLOAT, 0.01),
    "locSrv.extQuatStdDev": (_FLOAT, 0.0045),
    "posCtlPid.xVelMax": (_FLOAT, 1.0),
    "posCtlPid.yVelMax": (_FLOAT, 1.0),
    "posCtlPid.zVelMax": (_FLOAT, 1.0),
    "posCtlPid.zKp": (_FLOAT, 2.0),
    "posCtlPid.zKi": (_FLOAT, 0.5),
    "posCtlPid.rLimit": (_FLOAT, 20.0),
    "posCtlPid.pLimit": (_FLOAT, 20.0),
    "pm.lowVoltage": (_FLOAT, 3.2),
    "pm.criticalLowVoltage": (_FLOAT, 3.0),
}
_READ_ONLY: dict[str, float] = {
    "deck.bcFlow2": 0.0,
    "deck.bcLighthouse4": 0.0,
    "deck.bcDWM1000": 0.0,
    "imu_sensors.BMI088": 1.0,
}
PARAMETER_ENTRIES = (
    *(TableEntry(name, kind) for name, (kind, _) in _DEFAULTS.items()),
    *(TableEntry(name, _UINT8, read_only=True) for name in _READ_ONLY),
)
"""The table of parameters."""


def logged(number: int, told: Told) -> float:
    """Return a log variable by its number in the table."""
    _, value = _LOGGED[LOG_ENTRIES[number].name]
    return value(told)


def default_parameters() -> dict[str, float]:
    """Return the parameters of a drone that was just switched on, by name."""
    return {**{name: value for name, (_, value) in _DEFAULTS.items()}, **_READ_ONLY}
