"""What disturbs the simulated drone: air, load, motors, battery, sensors; neutral by default.

Neutral values leave every number of a flight as it is without them, bit for bit. What a value does
stands in ``twin.external_forces``, ``twin.quadrotor.motors`` and ``twin.quadrotor.sensor_faults``.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from math import isfinite

from housefly.errors import ConfigError
from housefly.geometry import Vec2, Vec3

MotorGains = tuple[float, float, float, float]
"""One number per motor: front left, front right, rear right, rear left."""
_CALM: Vec3 = (0.0, 0.0, 0.0)


def _check(key: str, unit: str, low: float, high: float, *values: float) -> None:
    """Raise ConfigError unless every value lies in its range."""
    if any(not isfinite(value) or not low <= value <= high for value in values):
        got = values[0] if len(values) == 1 else values
        raise ConfigError(f"disturbances.{key}", f"must be {low:g} to {high:g} {unit}, not {got}")


class Motor(Enum):
    """The four motors; the value is the place in ``MotorGains``."""

    FRONT_LEFT = 0
    FRONT_RIGHT = 1
    REAR_RIGHT = 2
    REAR_LEFT = 3


class SensorCondition(Enum):
    """How a sensor of the drone is: OFF reads 0 (a deaf sonar keeps its last echo and says so)."""

    OK = "ok"
    STUCK = "stuck"
    OFF = "off"


@dataclass(frozen=True, slots=True)
class CeilingFan:
    """Air that falls below a fan.

    Attributes:
        place: world xy of its axis [m].
        radius: of its blades [m].
        downwash: speed of the air below it, 0 to 10 m/s; fades to none at 1.5 times the radius.
    """

    place: Vec2
    radius: float = 0.6
    downwash: float = 1.5

    def __post_init__(self) -> None:
        _check("fan.place", "m", -1000.0, 1000.0, *self.place)
        _check("fan.radius", "m", 0.05, 10.0, self.radius)
        _check("fan.downwash", "m/s", 0.0, 10.0, self.downwash)


@dataclass(frozen=True, slots=True)
class Payload:
    """A load that the drone carries.

    Attributes:
        mass: 0 to 0.5 kg.
        offset: from the drone's centre of mass, body frame [m], each -0.5 to 0.5.
    """

    mass: float
    offset: Vec3 = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        _check("payload.mass", "kg", 0.0, 0.5, self.mass)
        _check("payload.offset", "m", -0.5, 0.5, *self.offset)


@dataclass(frozen=True, slots=True)
class Tether:
    """A line from the drone's centre to a fixed point; it pulls only when taut.

    Attributes:
        anchor: its other end, world [m].
        length: when it becomes taut, 0 to 100 m.
        stiffness: pull per stretch, 0.1 to 1000 N/m.
    """

    anchor: Vec3
    length: float
    stiffness: float = 50.0

    def __post_init__(self) -> None:
        _check("tether.anchor", "m", -1000.0, 1000.0, *self.anchor)
        _check("tether.length", "m", 0.0, 100.0, self.length)
        _check("tether.stiffness", "N/m", 0.1, 1000.0, self.stiffness)


@dataclass(frozen=True, slots=True)
class PropellerDamage:
    """A damaged propeller.

    Attributes:
        motor: which.
        thrust: share of its thrust that is left, 0 to 1.
        vibration: one-sigma noise on the accelerometers while the motors turn, 0 to 50 m/s^2; the
            gyros shake with 0.05 rad/s per m/s^2.
    """

    motor: Motor
    thrust: float = 0.8
    vibration: float = 3.0

    def __post_init__(self) -> None:
        _check("propeller_damage.thrust", "of its thrust", 0.0, 1.0, self.thrust)
        _check("propeller_damage.vibration", "m/s^2", 0.0, 50.0, self.vibration)


@dataclass(frozen=True, slots=True)
class SensorFaults:
    """What is wrong with the drone's own sensors; its firmware flies by what they say.

    Attributes:
        attitude: OK or STUCK: roll, pitch and yaw keep their last values; the gyros go on.
        flow: optical flow; OFF reads 0.
        flow_gain: factor of its speeds, 0 to 10.
        flow_bias: added to its speeds, forward and left, -10 to 10 m/s.
        flow_noise: added one-sigma noise, 0 to 10 m/s.
        sonar: STUCK keeps its last value in silence; OFF does so and raises "ultrasound deaf".
        sonar_bias: added to its height, -5 to 5 m.
        sonar_noise: added one-sigma noise, 0 to 5 m.
        tilt_bias: added to roll and pitch, each -0.5 to 0.5 rad.
        gyro_noise: added one-sigma noise, 0 to 10 rad/s.
        acceleration_noise: added one-sigma noise, 0 to 100 m/s^2.
    """

    attitude: SensorCondition = SensorCondition.OK
    flow: SensorCondition = SensorCondition.OK
    flow_gain: float = 1.0
    flow_bias: Vec2 = (0.0, 0.0)
    flow_noise: float = 0.0
    sonar: SensorCondition = SensorCondition.OK
    sonar_bias: float = 0.0
    sonar_noise: float = 0.0
    tilt_bias: Vec2 = (0.0, 0.0)
    gyro_noise: float = 0.0
    acceleration_noise: float = 0.0

    def __post_init__(self) -> None:
        if self.attitude is SensorCondition.OFF:
            raise ConfigError("sensors.attitude", "must be ok or stuck: the drone cannot lose it")
        _check("sensors.flow_gain", "", 0.0, 10.0, self.flow_gain)
        _check("sensors.flow_bias", "m/s", -10.0, 10.0, *self.flow_bias)
        _check("sensors.flow_noise", "m/s", 0.0, 10.0, self.flow_noise)
        _check("sensors.sonar_bias", "m", -5.0, 5.0, self.sonar_bias)
        _check("sensors.sonar_noise", "m", 0.0, 5.0, self.sonar_noise)
        _check("sensors.tilt_bias", "rad", -0.5, 0.5, *self.tilt_bias)
        _check("sensors.gyro_noise", "rad/s", 0.0, 10.0, self.gyro_noise)
        _check("sensors.acceleration_noise", "m/s^2", 0.0, 100.0, self.acceleration_noise)


SENSORS_OK = SensorFaults()


@dataclass(frozen=True, slots=True)
class Disturbances:
    """Everything that disturbs the simulated drone at one time.

    Attributes:
        wind: steady speed of the air, world, each -20 to 20 m/s.
        gust: one-sigma speed of gusts along x and y, 0 to 10 m/s; half of it along z.
        gust_time: correlation time of the gusts, 0.05 to 60 s.
        fan: a ceiling fan, or None.
        motor_thrust: share of its thrust that each motor has, 0 to 1.
        voltage_sag: voltage lost under load, 0 to 5 V: the drone measures it, and full thrust falls
            with the square of the voltage.
        charge: a new charge of the battery, 0 to 1, set once when this is handed over; None leaves
            it.
        battery_gauge_stuck: the drone keeps its last charge and voltage for true; at a truly empty
            battery its motors still stop.
        payload, tether, propeller_damage: None for none.
        sensors: the drone's own.

    Raises:
        ConfigError: a value out of its range.
    """

    wind: Vec3 = _CALM
    gust: float = 0.0
    gust_time: float = 1.0
    fan: CeilingFan | None = None
    motor_thrust: MotorGains = (1.0, 1.0, 1.0, 1.0)
    voltage_sag: float = 0.0
    charge: float | None = None
    battery_gauge_stuck: bool = False
    payload: Payload | None = None
    tether: Tether | None = None
    propeller_damage: PropellerDamage | None = None
    sensors: SensorFaults = SENSORS_OK

    def __post_init__(self) -> None:
        _check("wind", "m/s", -20.0, 20.0, *self.wind)
        _check("gust", "m/s", 0.0, 10.0, self.gust)
        _check("gust_time", "s", 0.05, 60.0, self.gust_time)
        _check("motor_thrust", "of its thrust", 0.0, 1.0, *self.motor_thrust)
        _check("voltage_sag", "V", 0.0, 5.0, self.voltage_sag)
        if self.charge is not None:
            _check("charge", "of a full battery", 0.0, 1.0, self.charge)
        if len(self.motor_thrust) != len(Motor):
            raise ConfigError("motor_thrust", "must be four numbers, one per motor")

    @property
    def motor_gains(self) -> MotorGains:
        """What is left of each motor's thrust, damage of its propeller included, 0 to 1."""
        damage = self.propeller_damage
        if damage is None:
            return self.motor_thrust
        gains = list(self.motor_thrust)
        gains[damage.motor.value] *= damage.thrust
        front_left, front_right, rear_right, rear_left = gains
        return front_left, front_right, rear_right, rear_left


NEUTRAL = Disturbances()
