"""What control is given on a trajectory in space: one command delay ahead, the lags inverted."""

from __future__ import annotations

from housefly.numeric import FloatArray, compiled, wrapped
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.trajectory_progress import HEADING_COLUMN
from housefly.pilot.control.steering import ControlReference, Gains
from housefly.pilot.planning.trajectory.kinematic_state import TICK
from housefly.pilot.planning.trajectory.time_scale import TimeScale, motion_at, row_at


@compiled
def feed_forward_reference(
    scale: TimeScale,
    profile: PathProfile,
    target: TrajectorySetpoint,
    yaw: float,
    gains: Gains,
    delay: float,
) -> ControlReference:
    """Return what control is given on a trajectory.

    A tilt u that acts ``delay`` later gives a = u - a' / lag, and the air takes drag v; so that the
    drone accelerates as planned, u = a + a' / lag + drag (v + a / lag), all of it ``delay`` ahead.
    Climbing likewise: v_z + a_z / climb_lag; where the law inverts that lag, what is left is 4 K2.
    A drone that turns leans along its heading of then.

    Args:
        scale: how far it has been flown.
        profile: of the trajectory.
        target: the reference now.
        yaw: heading to ask for [rad].
        gains: lags and drag of the drone.
        delay: from command to first reaction, as estimated [s].
    """
    rows = profile.motion
    climb_lag = gains.climb_lag
    if gains.inverts_climb:
        climb_lag = max(climb_lag, 4.0 * gains.height)
    rate = min(max(scale.rate + delay * scale.change, 0.0), 1.0)
    later = TimeScale(
        time=scale.time + 0.5 * delay * (scale.rate + rate), rate=rate, change=scale.change
    )
    ahead = motion_at(later, rows, TICK)
    row, _ = row_at(later.time, TICK, rows.shape[0])
    is_over = later.time >= TICK * (rows.shape[0] - 1)
    share = 0.0 if is_over else rate * rate * rate / (TICK * gains.lag)
    push_x = share * (rows[row + 1, 6] - rows[row, 6]) + gains.drag * ahead.ax / gains.lag
    push_y = share * (rows[row + 1, 7] - rows[row, 7]) + gains.drag * ahead.ay / gains.lag
    # The law looks up the place where the velocity leads in one delay; here it is known.
    return ControlReference(
        position=(ahead.x - delay * ahead.vx, ahead.y - delay * ahead.vy),
        velocity=(ahead.vx, ahead.vy),
        acceleration=(ahead.ax + push_x, ahead.ay + push_y),
        height=target.z,
        yaw=yaw,
        climb=ahead.vz + ahead.az / climb_lag,
        turn=0.0 if is_over else _turn_rate(rows, row, rate),
        lead=tilt_lead(gains),
    )


@compiled
def tilt_lead(gains: Gains) -> float:
    """Return how long after a command the drone leans as told [s]: the delay, then the lag."""
    return gains.delay + 1.0 / gains.lag


@compiled
def _turn_rate(rows: FloatArray, row: int, rate: float) -> float:
    """Return the yaw rate of a motion from one row to the next [rad/s]."""
    return rate * wrapped(rows[row + 1, HEADING_COLUMN] - rows[row, HEADING_COLUMN]) / TICK
