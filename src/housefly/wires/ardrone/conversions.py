"""The one place where the AR.Drone's signs and units are converted to ours and back.

The drone's body frame is forward-right-down with angles in millidegrees and lengths in millimetres;
PCMD has signs of its own. Ours is forward-left-up (REP-103), radians and metres. Facts: Parrot
ARDroneLib SDK 2.0.1, AutonomyLab/ardrone_autonomy.
"""

from __future__ import annotations

from math import degrees, isfinite, radians

from housefly.errors import WireError
from housefly.geometry import GRAVITY, Vec3, wrap_angle
from housefly.messages import DroneFault, DroneStatus, Setpoint, Telemetry
from housefly.messages.stick import Maxima, Stick, stick_fraction, stick_from_setpoint
from housefly.wires.ardrone.at import Pcmd, PcmdFlag
from housefly.wires.ardrone.navdata import NavdataPacket, StateBits
from housefly.wires.ardrone.navdata_options import Altitude, Demo, MajorState, PhysMeasures, Time

_STATUS = {
    MajorState.DEFAULT: DroneStatus.UNKNOWN,
    MajorState.INIT: DroneStatus.LANDED,
    MajorState.LANDED: DroneStatus.LANDED,
    MajorState.FLYING: DroneStatus.FLYING,
    MajorState.HOVERING: DroneStatus.FLYING,
    MajorState.TEST: DroneStatus.LANDED,
    MajorState.TAKING_OFF: DroneStatus.TAKING_OFF,
    MajorState.GOING_TO_FIX: DroneStatus.FLYING,
    MajorState.LANDING: DroneStatus.LANDING,
    MajorState.LOOPING: DroneStatus.FLYING,
}

_FAULTS: tuple[tuple[StateBits, DroneFault], ...] = (
    (StateBits.MOTORS_PROBLEM, DroneFault.MOTORS_PROBLEM),
    (StateBits.SOFTWARE_FAULT, DroneFault.SOFTWARE_FAULT),
    (StateBits.CUTOUT, DroneFault.MOTORS_CUT_OUT),
    (StateBits.BATTERY_LOW, DroneFault.BATTERY_LOW),
    (StateBits.ANGLES_OUT_OF_RANGE, DroneFault.TILTED_TOO_FAR),
    (StateBits.ULTRASOUND_DEAF, DroneFault.ULTRASOUND_DEAF),
    (StateBits.USER_EMERGENCY, DroneFault.USER_EMERGENCY),
    (StateBits.TIMER_ELAPSED, DroneFault.FLIGHT_TIMER_ELAPSED),
    (StateBits.WIND, DroneFault.WIND),
    (StateBits.ADC_WATCHDOG, DroneFault.SENSOR_BOARD_SILENT),
    (StateBits.COM_LOST, DroneFault.COMMANDS_LOST),
)
"""State bits that a person should know of."""
_ANY_FAULT = sum(int(bit) for bit, _ in _FAULTS)
_SILENT = int(StateBits.COM_WATCHDOG | StateBits.COM_LOST)
ULTRASOUND_MIN = 0.25
"""Raw ultrasound up to this may be anything nearer [m]: on the floor it tells 0.24."""


def telemetry_from_navdata(packet: NavdataPacket, received_at: float) -> Telemetry:
    """Return our telemetry of a packet that carries the demo option.

    Raises:
        WireError: no demo option (bootstrap packet), or a number that is not finite.
    """
    demo = packet.option(Demo)
    if demo is None:
        raise WireError("navdata without the demo option")
    if not all(map(isfinite, (demo.theta, demo.phi, demo.psi, demo.vx, demo.vy, demo.vz))):
        raise WireError("navdata with a number that is not finite")
    return Telemetry(
        received_at=received_at,
        status=status_of(packet, demo),
        battery=min(demo.battery_percent, 100) / 100.0,
        phi=_angle(demo.phi),
        theta=_angle(-demo.theta),
        psi=_angle(-demo.psi),
        height=_height(packet, demo),
        velocity=(demo.vx / 1000.0, -demo.vy / 1000.0, -demo.vz / 1000.0),
        faults=_faults(packet),
        acceleration=_acceleration(packet),
        drone_time=time.seconds if (time := packet.option(Time)) else None,
        hears_us=hears_us(packet),
    )


def _height(packet: NavdataPacket, demo: Demo) -> float:
    """Return how far the next surface is below the drone [m].

    Raw ultrasound tells that, where the packet has it. The demo option tells a blend with pressure
    and motion, which does not drop above a table, and drifts (AutonomyLab, ardrone_autonomy, issues
    145 and 185); only what is too near for ultrasound is left to it.
    """
    told, raw = demo.altitude / 1000.0, packet.option(Altitude)
    if raw is None or raw.raw <= 0:
        return told
    measured = raw.raw / 1000.0
    return measured if measured > ULTRASOUND_MIN else min(measured, told)


def hears_us(packet: NavdataPacket) -> bool:
    """Return whether our commands reach the drone, by its own word."""
    return not packet.state & _SILENT


def _faults(packet: NavdataPacket) -> tuple[DroneFault, ...]:
    if not packet.state & _ANY_FAULT:
        return ()
    return tuple(fault for bit, fault in _FAULTS if packet.has(bit))


def _acceleration(packet: NavdataPacket) -> Vec3 | None:
    """Return the specific force in the body [m/s^2], None where the packet does not tell it."""
    measures = packet.option(PhysMeasures)
    if measures is None or not all(map(isfinite, measures.accelerations)):
        return None
    forward, right, down = (milli_g * GRAVITY / 1e3 for milli_g in measures.accelerations)
    return flu_from_frd((forward, right, down))


def status_of(packet: NavdataPacket, demo: Demo) -> DroneStatus:
    """Return the drone's status; the emergency bit overrides the control state."""
    if packet.has(StateBits.EMERGENCY):
        return DroneStatus.EMERGENCY
    try:
        return _STATUS[MajorState(demo.major)]
    except ValueError:
        return DroneStatus.UNKNOWN


def native_demo(
    major: MajorState,
    battery: float,
    *,
    phi: float,
    theta: float,
    psi: float,
    height: float,
    velocity: Vec3,
) -> Demo:
    """Return the demo option of a drone whose state is given in our signs.

    The inverse of ``telemetry_from_navdata``, for the twin.
    """
    forward, left, up = velocity
    return Demo(
        ctrl_state=int(major) << 16,
        battery_percent=round(100.0 * battery),
        theta=-_millidegrees(theta),
        phi=_millidegrees(phi),
        psi=-_millidegrees(psi),
        altitude=round(1000.0 * height),
        vx=1000.0 * forward,
        vy=-1000.0 * left,
        vz=-1000.0 * up,
    )


def flu_from_frd(vector: Vec3) -> Vec3:
    """Turn a body vector from forward-right-down to forward-left-up; it is its own inverse."""
    x, y, z = vector
    return x, -y, -z


def pcmd_from_setpoint(setpoint: Setpoint, maxima: Maxima) -> Pcmd:
    """Return the progressive PCMD of a setpoint, as ``stick_from_setpoint``."""
    stick = stick_from_setpoint(setpoint, maxima)
    return Pcmd(
        PcmdFlag.PROGRESSIVE, roll=-stick.left, pitch=-stick.forward, gaz=stick.up, yaw=-stick.turn
    )


def stick_from_pcmd(pcmd: Pcmd) -> Stick:
    """Return the stick of a PCMD, each part cut to -1..1, for the twin."""
    return Stick(
        forward=-stick_fraction(pcmd.pitch, 1.0),
        left=-stick_fraction(pcmd.roll, 1.0),
        up=stick_fraction(pcmd.gaz, 1.0),
        turn=-stick_fraction(pcmd.yaw, 1.0),
        hover=PcmdFlag.PROGRESSIVE not in pcmd.flags,
    )


def _angle(millidegrees: float) -> float:
    return wrap_angle(radians(millidegrees / 1000.0))


def _millidegrees(angle: float) -> float:
    return 1000.0 * degrees(angle)
