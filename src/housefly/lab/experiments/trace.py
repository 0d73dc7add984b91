"""One flight, tick by tick: the signals at every arrow of the loop."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.tracking_noise import FRAME
from housefly.numeric import compiled
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.control.model import DroneState
from housefly.pilot.control.steering import ControlOutput
from housefly.pilot.estimation.estimator_state import PoseEstimate

TRUTH = ("x", "y", "z", "psi", "vx", "vy", "vz", "theta", "phi")
ESTIMATE = ("est_x", "est_y", "est_z", "est_vx", "est_vy", "est_vz", "est_psi", "pose_age")
REFERENCE = ("ref_x", "ref_y", "ref_z", "ref_vx", "ref_vy", "ref_vz", "ref_psi")
ASKED = ("ask_theta", "ask_phi", "ask_vz", "ask_yaw_rate", "ask_tilt")
COMMAND = ("cmd_theta", "cmd_phi", "cmd_vz", "cmd_yaw_rate")
TRACE = np.dtype(
    [("t", "f8")]
    + [(name, "f8") for name in TRUTH + ESTIMATE + REFERENCE + ASKED + COMMAND]
    + [(name, "i8") for name in ("flying", "behavior", "safety", "waypoint", "sightings")]
    + [(f"seen_{name}", FRAME[name]) for name in FRAME.names or ()]
)
"""One tick. SI units; truth without prefix, ``est_`` estimate, ``ref_`` reference, ``ask_`` what
control asks (``ask_tilt``: the length that it would tilt without a limit), ``cmd_`` what left the
gate. ``flying`` 0: the drone's own hover. ``behavior``: an ``AcceptorState``. ``safety``: a
``SafetyModeCode``. ``sightings``: how many arrived; ``seen_*``: the newest of them.
"""
Trace = NDArray[Any]
"""Structured array of dtype ``TRACE``."""
SEEN = np.dtype([("tick", "i8"), *((name, FRAME[name]) for name in FRAME.names or ())])
"""One sighting and the tick at which the pilot got it."""


@compiled
def traced_truth(row: Any, now: float, body: DroneState) -> None:
    """Write time and truth into one row."""
    row.t = now
    row.x, row.y, row.z, row.psi = body.x, body.y, body.z, body.psi
    row.vx, row.vy, row.vz, row.theta, row.phi = body.vx, body.vy, body.vz, body.theta, body.phi


@compiled
def traced_sighting(row: Any, frame: Any) -> None:
    """Write one more sighting into a row."""
    row.sightings += 1
    row.seen_captured_at, row.seen_received_at = frame.captured_at, frame.received_at
    row.seen_x, row.seen_y, row.seen_z, row.seen_yaw = frame.x, frame.y, frame.z, frame.yaw


@compiled
def noted(seen: Any, number: int, tick: int, frame: Any) -> None:
    """Write one sighting into the list of all, as far as it has room."""
    if number < seen.size:
        row = seen[number]
        row.tick, row.captured_at, row.received_at = tick, frame.captured_at, frame.received_at
        row.x, row.y, row.z, row.yaw = frame.x, frame.y, frame.z, frame.yaw


@compiled
def traced_thoughts(
    row: Any,
    here: PoseEstimate,
    age: float,
    target: TrajectorySetpoint,
    yaw: float,
    asked: ControlOutput,
) -> None:
    """Write estimate, reference and what control asks into a row."""
    row.est_x, row.est_y, row.est_z = here.x, here.y, here.z
    row.est_vx, row.est_vy, row.est_vz, row.est_psi, row.pose_age = (
        here.vx,
        here.vy,
        here.vz,
        here.yaw,
        age,
    )
    row.ref_x, row.ref_y, row.ref_z = target.x, target.y, target.z
    row.ref_vx, row.ref_vy, row.ref_vz = target.vx, target.vy, target.vz
    row.ref_psi, row.waypoint = yaw, target.waypoint
    row.ask_theta, row.ask_phi, row.ask_vz = asked.theta, asked.phi, asked.vz
    row.ask_yaw_rate, row.ask_tilt = asked.yaw_rate, asked.wish


@compiled
def traced_command(row: Any, order: Any, state: int, safety: int) -> None:
    """Write what left the gate and the states into a row."""
    row.flying, row.behavior, row.safety = order.flying, state, safety
    row.cmd_theta, row.cmd_phi, row.cmd_vz, row.cmd_yaw_rate = (
        order.theta,
        order.phi,
        order.vz,
        order.yaw_rate,
    )
