"""Every rule of the last gate: what breaks it, and what just does not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf, nan

from gate_flight import AIRFRAME, FENCE, FINE, HERE, LIMITS, REPORT

from housefly.messages import DroneFault, DroneStatus, Phase, Reference, SafetyMode, Setpoint
from housefly.pilot.behavior.mission import PEOPLE_SILENCE_MAX, PeopleSilence
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.gate import Gate, GateAssessment
from housefly.pilot.safety.inputs import GateInputs
from housefly.pilot.safety.motion_rules import TILT_WRONG_MAX
from housefly.pilot.safety.tracking_rules import (
    DRIFT_LAND,
    DRIFT_WARN,
    FRAME_ERROR_MAX,
    LATENCY_HOLD,
    LATENCY_SLOW,
)

FLOOR = (5.0, 2.0, 0.05)
STOOD = replace(FINE, status=DroneStatus.LANDED, phase=Phase.IDLE, position=FLOOR, yaw=0.0)
TICK = 0.05
SETTLED = 8.0
SUDDEN: dict[str, tuple[str, ...]] = {"too_fast": ("contact",)}
"""Rules that the case of a rule breaks for a moment, because its numbers come and go at once."""
Change = Callable[[GateInputs, float], GateInputs]
"""What becomes of the inputs so long [s] after everything was fine."""


def drained(inputs: GateInputs) -> GateInputs:
    """A battery that lasts for ten minutes, as its gauge shows it."""
    return replace(inputs, battery=round(inputs.battery - inputs.now / 600.0, 2))


def now(**changes: object) -> Change:
    """These values from the first moment on."""
    return lambda inputs, _: replace(inputs, **changes)  # type: ignore[arg-type]


def told(**changes: object) -> Change:
    """The drone reports these values."""
    report = replace(REPORT, **changes)  # type: ignore[arg-type]
    return lambda inputs, _: replace(inputs, telemetry=report)


def seen(**changes: object) -> Change:
    """Tracking against the drone's own report."""
    known = replace(FINE.consistency, **changes)  # type: ignore[arg-type]
    return now(consistency=known)


def at(z: float, **changes: object) -> Change:
    """The drone is at this height."""
    return now(position=(5.0, 2.0, z), **changes)


def off(distance: float) -> Change:
    """The drone is so far from where it should be."""
    return now(position=(5.0 + distance, 2.0, 1.1))


def moving(vx: float, vz: float = 0.0, **changes: object) -> Change:
    """The drone moves along x and z; the reference with it, if not told otherwise."""
    reference = Reference(HERE, (vx, 0.0, 0.0), 0.0)
    return now(**{"velocity": (vx, 0.0, vz), "reference": reference, **changes})


def pulsed(period: float, length: float, change: Change) -> Change:
    """A change that comes for a length and goes, once a period [s]."""
    return lambda inputs, t: change(inputs, t) if t % period < length - 1e-9 else inputs


def lying(speed: float = 0.0, z: float = 0.06) -> Change:
    """It lies on the floor, or nearly so, told to land."""
    still = replace(REPORT, velocity=(speed, 0.0, 0.0), height=0.0)
    return now(position=(5.0, 2.0, z), phase=Phase.LANDING, telemetry=still)


def taking_off(aside: float, z: float) -> Change:
    """It takes off and is so far aside, drifting at 0.1 m/s, so high by tracking and by itself."""
    report = replace(REPORT, status=DroneStatus.TAKING_OFF, height=z - 0.05)
    return now(
        status=DroneStatus.TAKING_OFF,
        phase=Phase.TAKING_OFF,
        position=(5.0 + aside, 2.0, z),
        velocity=(0.1, 0.0, 0.2),
        reference=None,
        telemetry=report,
    )


def turned(angle: float) -> Change:
    """It takes off where it stood, and has turned so far [rad]."""
    rises = taking_off(0.0, 0.15)
    return lambda inputs, t: replace(rises(inputs, t), yaw=angle)


def landing(aside: float, height: float) -> Change:
    """It lands and moves aside so fast, so far above the floor by tracking and by itself."""
    report = replace(REPORT, status=DroneStatus.LANDING, height=height)
    return now(
        status=DroneStatus.LANDING,
        phase=Phase.LANDING,
        position=(5.0, 2.0, height),
        velocity=(aside, 0.0, -0.3),
        reference=None,
        telemetry=report,
    )


UNCHANGED = now()
CONFIGURED_LATE = told(configured=False)
DAWDLING = now(flown=Setpoint(theta=0.12))

BROKEN: dict[str, tuple[Change, Change, float]] = {
    # code: (broken, just within bounds, how long after it begins it is wrong by its condition [s])
    "cut": (now(cutting=True), now(), 0.0),
    "emergency": (now(status=DroneStatus.EMERGENCY), now(), 0.0),
    "motors_running": (lying(), lying(speed=0.12), 0.0),
    "landing_refused": (now(phase=Phase.LANDING), lying(), LIMITS.landing_timeout),
    "telemetry_lost": (now(telemetry_age=1.01), now(telemetry_age=1.0), 0.0),
    "drone_fault": (
        told(faults=(DroneFault.MOTORS_PROBLEM,)),
        told(faults=(DroneFault.ULTRASOUND_DEAF,)),
        0.0,
    ),
    "not_configured": (CONFIGURED_LATE, pulsed(5.0, 4.9, CONFIGURED_LATE), 0.0),
    "battery_low": (now(battery=0.149), now(battery=0.151), 0.0),
    "battery_cliff": (now(battery=0.72), now(battery=0.75), 0.0),
    "flight_time_over": (now(), now(), inf),
    "loop_stalled": (now(late=1.01), now(late=1.0), 0.0),
    "held_too_often": (
        pulsed(0.5, 0.25, now(pose_age=0.5)),
        pulsed(0.5, 0.15, now(pose_age=0.5)),
        7.0,
    ),
    "stopped": (now(stopped=True), now(), 0.0),
    "battery_return": (now(battery=0.227), now(battery=0.24), 0.0),
    "flight_time": (now(home_time=440.0), now(home_time=350.0), 0.0),
    "configuring": (CONFIGURED_LATE, now(), 0.0),
    "commands_unheard": (told(hears_us=False), pulsed(0.4, 0.25, told(hears_us=False)), 0.3),
    "loop_late": (now(late=0.26), now(late=0.25), 0.0),
    "loop_slow": (pulsed(0.3, 0.05, now(late=0.06)), pulsed(0.6, 0.05, now(late=0.06)), 0.6),
    "people_unseen": (
        now(silence=PeopleSilence(inf)),
        now(silence=PeopleSilence(PEOPLE_SILENCE_MAX)),
        0.0,
    ),
    "drone_complains": (
        told(faults=(DroneFault.ULTRASOUND_DEAF,)),
        told(faults=(DroneFault.MOTORS_PROBLEM,)),
        0.0,
    ),
    "drone_settings": (told(notes=("tilt limit refused",)), now(), 0.0),
    "battery_weak": (now(battery=0.27), now(battery=0.29), 0.0),
    "battery_gauge": (now(battery=0.8), now(), 60.0),
    "tracking_lost": (now(pose_age=2.01), now(pose_age=2.0), 0.0),
    "nothing_believed": (
        now(pose_age=0.26, consistency=TrackingConsistency(drift=0.0, flow_wrong=True)),
        now(pose_age=0.25, consistency=TrackingConsistency(drift=0.0, flow_wrong=True)),
        0.0,
    ),
    "flow_wrong": (seen(flow_wrong=True), seen(flow_untold=True), 0.0),
    "flow_untold": (seen(flow_untold=True), seen(flow_wrong=True), 0.0),
    "poses_refused_long": (seen(refused_for=2.01), seen(refused_for=2.0), 0.0),
    "tracking_drift": (seen(drift=DRIFT_LAND + 0.01), seen(drift=DRIFT_LAND), 0.0),
    "tracking_frame": (
        seen(frame_error=-FRAME_ERROR_MAX - 0.01),
        seen(frame_error=FRAME_ERROR_MAX - 0.01),
        0.0,
    ),
    "tracking_mirrored": (seen(mirrored=True), seen(), 0.0),
    "tracking_height": (seen(height_error=-0.31), seen(height_error=-0.29), 0.0),
    "tracking_old": (now(pose_age=0.26), now(pose_age=0.25), 0.0),
    "poses_refused": (seen(refused_for=0.31), seen(refused_for=0.3), 0.0),
    "tracking_late": (
        seen(latency_error=LATENCY_HOLD + 0.01),
        seen(latency_error=LATENCY_HOLD),
        0.0,
    ),
    "tracking_slow": (
        seen(latency_error=LATENCY_SLOW + 0.01),
        seen(latency_error=LATENCY_SLOW),
        0.0,
    ),
    "tracking_drifted": (seen(drift=DRIFT_WARN + 0.01), seen(drift=DRIFT_WARN), 0.0),
    "tracking_unchecked": (seen(drift=nan), seen(drift=DRIFT_WARN), 0.0),
    "tracking_drifting": (seen(drift=DRIFT_WARN + 0.01), seen(drift=DRIFT_WARN), 0.0),
    "tracking_gap": (
        now(status=DroneStatus.TAKING_OFF, pose_age=0.26),
        now(status=DroneStatus.TAKING_OFF, pose_age=0.25),
        0.0,
    ),
    "tracking_on_ground": (
        now(status=DroneStatus.LANDED, consistency=TrackingConsistency(height_error=0.31)),
        now(status=DroneStatus.LANDED, consistency=TrackingConsistency(height_error=0.29)),
        0.0,
    ),
    "tracking_height_off": (seen(height_error=0.31), seen(height_error=0.29), 0.0),
    "outside_fence": (now(position=(11.01, 2.0, 1.1)), now(position=(10.99, 2.0, 1.1)), 0.0),
    "too_high": (at(2.31), at(2.3), 0.0),
    "take_off_drift": (taking_off(0.09, 0.15), taking_off(0.07, 0.15), 0.0),
    "take_off_turn": (turned(0.81), turned(-0.79), 0.0),
    "take_off_aborted": (taking_off(0.15, 0.07), taking_off(0.15, 0.18), 0.0),
    "landing_drift": (landing(0.26, 0.05), landing(0.26, 0.1), 0.0),
    "blown_about": (now(velocity=(0.2, 0.0, 0.0)), now(velocity=(0.0, -0.14, 0.0)), 3.4),
    "too_low": (at(0.29), at(0.31), 0.0),
    "height_error": (at(1.51), at(1.49), 0.0),
    "height_not_reached": (at(0.84), at(0.86), 0.0),
    "vertical_speed": (moving(0.0, 1.11), moving(0.0, -1.09), 0.0),
    "tilt_error": (told(phi=-0.21), told(phi=0.19), 0.0),
    "tilt_lost": (told(phi=-0.21), pulsed(2.0, 0.15, told(phi=0.21)), TILT_WRONG_MAX),
    "contact": (told(acceleration=(6.0, 0.0, 15.0)), told(acceleration=(4.0, 0.0, 14.0)), 0.0),
    "stuck": (DAWDLING, now(flown=Setpoint(theta=0.12), velocity=(0.13, 0.0, 0.0)), 0.4),
    "control_lost": (off(1.01), off(0.99), 0.0),
    "near_fence": (
        moving(0.5, position=(9.9, 2.0, 1.1), reference=None),
        moving(0.5, position=(9.8, 2.0, 1.1), reference=None),
        0.0,
    ),
    "control_error": (off(0.51), off(-0.49), 0.0),
    "drifting": (
        now(velocity=(0.0, 0.31, 0.0)),
        moving(0.3, reference=Reference(HERE, (0.01, 0.0, 0.0), 0.0)),
        0.0,
    ),
    "tracking_height_drift": (seen(height_drift=0.31), seen(height_drift=0.29), 0.0),
    "too_fast": (
        now(velocity=(0.0, 1.71, 0.0), reference=None),
        now(velocity=(1.69, 0.0, 3.0), reference=None),
        0.0,
    ),
    "height_off": (at(1.36), at(1.34), 0.0),
    "not_on_floor": (
        now(status=DroneStatus.LANDED, position=(5.0, 2.0, 0.21)),
        now(status=DroneStatus.LANDED, position=(5.0, 2.0, 0.19)),
        0.0,
    ),
}


def assessed(change: Change, seconds: float) -> list[tuple[float, GateAssessment]]:
    """Return what a gate finds in the time after the change, on top of a flight that is fine."""
    gate = Gate(LIMITS, FENCE, AIRFRAME)
    gate.assess(replace(STOOD, now=-TICK))
    found = []
    for n in range(round((SETTLED + seconds) / TICK)):
        inputs = drained(replace(FINE, now=TICK * n))
        since = inputs.now - SETTLED
        if since >= -1e-9:
            found.append((since, gate.assess(change(inputs, max(since, 0.0)))))
        else:
            assert gate.assess(inputs).mode is SafetyMode.NOMINAL
    return found


def times(code: str, change: Change, seconds: float) -> list[float]:
    """Return when a rule was broken after a change [s]."""
    found = assessed(change, seconds)
    return [at for at, each in found if any(rule.code == code for rule in each.broken)]
