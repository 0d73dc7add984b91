"""A recorded flight as tables for other programs: one row a step, a sighting, or an event."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from math import hypot, nan
from pathlib import Path

import numpy as np

from housefly.app.event_table import CellType, Row, dated
from housefly.geometry import euler_from_quaternion
from housefly.messages import (
    PilotStep,
    PositionSetpoint,
    Setpoint,
    VelocitySetpoint,
)
from housefly.record.flight_log import FlightLog
from housefly.record.replay import read_dated_steps

DatedStep = tuple[float, PilotStep]

_WHEN: Mapping[str, CellType] = {"time": str, "unix": float, "t_s": float}
"""ISO 8601 in UTC, Unix time, and time since the first step."""
_STEP_HEADINGS: Mapping[str, CellType] = {
    **_WHEN, "step": int, "phase": str, "behavior": str, "safety": str, "goal": str,
    "reason": str, "action": str, "x_m": float, "y_m": float, "z_m": float, "yaw_rad": float,
    "vx_m_s": float, "vy_m_s": float, "vz_m_s": float, "speed_m_s": float,
    "position_std_m": float, "pose_age_s": float, "ref_x_m": float, "ref_y_m": float,
    "ref_z_m": float, "ref_yaw_rad": float, "cmd_theta_rad": float, "cmd_phi_rad": float,
    "cmd_forward_m_s": float, "cmd_left_m_s": float, "cmd_x_m": float, "cmd_y_m": float,
    "cmd_z_m": float, "cmd_vz_m_s": float, "cmd_yaw_rate_rad_s": float, "status": str,
    "battery": float, "phi_rad": float, "theta_rad": float, "psi_rad": float,
    "height_m": float, "telemetry_age_s": float, "late_s": float,
}  # fmt: skip
LOG_HEADINGS: Mapping[str, CellType] = {
    "time": str, "unix": float, "t_s": float, "x_m": float, "y_m": float, "z_m": float,
    "vx_m_s": float, "vy_m_s": float, "vz_m_s": float, "phi_rad": float, "theta_rad": float,
    "yaw_rad": float, "ref_x_m": float, "ref_y_m": float, "ref_z_m": float,
    "ref_yaw_rad": float, "cmd_vx_m_s": float, "cmd_vy_m_s": float, "cmd_vz_m_s": float,
    "cmd_yaw_rate_rad_s": float, "battery": float,
}  # fmt: skip
"""Of a log of others; ``time`` and ``unix`` are empty where the log does not say when."""
_SIGHTING_HEADINGS: Mapping[str, CellType] = {
    **_WHEN, "body": str, "x_m": float, "y_m": float, "z_m": float, "roll_rad": float,
    "pitch_rad": float, "yaw_rad": float, "latency_s": float,
}  # fmt: skip
_EVENT_HEADINGS: Mapping[str, CellType] = {**_WHEN, "severity": str, "code": str, "words": str}


class FlightTable(Enum):
    """What a row is."""

    STEPS = "steps"
    SIGHTINGS = "sightings"
    EVENTS = "events"


@dataclass(frozen=True, slots=True)
class TableForm:
    """Columns with their types, and how rows are made of steps."""

    headings: Mapping[str, CellType]
    rows: Callable[[Iterable[DatedStep]], Iterator[Row]]


def flight_rows(recording: Path, table: FlightTable) -> Iterator[Row]:
    """Yield the rows of a recording, as ``TABLE_FORMS`` names their columns.

    Args:
        recording: ``flight.mcap``, or the folder that holds it.
        table: which.

    Raises:
        RecordingError: it cannot be read, or is damaged in the middle.
    """
    return TABLE_FORMS[table].rows(read_dated_steps(recording))


def _step_rows(steps: Iterable[DatedStep]) -> Iterator[Row]:
    start = None
    for at, step in steps:
        start = step.now if start is None else start
        outputs, telemetry = step.outputs, step.inputs.telemetry
        estimate, reference = outputs.estimate, outputs.reference
        yield (
            *dated(at),
            step.now - start,
            step.sequence,
            outputs.phase.value,
            outputs.behavior.value,
            outputs.safety.value,
            outputs.goal_name,
            str(outputs.reason),
            outputs.command.action.value,
            *((*estimate.position, estimate.yaw) if estimate else (nan,) * 4),
            *((*estimate.velocity, hypot(*estimate.velocity)) if estimate else (nan,) * 4),
            *((estimate.position_std, estimate.pose_age) if estimate else (nan,) * 2),
            *((*reference.position, reference.yaw) if reference else (nan,) * 4),
            *_asked(outputs.command.asked),
            telemetry.status.value if telemetry else "",
            *(
                (
                    telemetry.battery,
                    telemetry.phi,
                    telemetry.theta,
                    telemetry.psi,
                    telemetry.height,
                    step.now - telemetry.received_at,
                )
                if telemetry
                else (nan,) * 6
            ),
            step.inputs.late,
        )


def _asked(asked: Setpoint | VelocitySetpoint | PositionSetpoint) -> Row:
    """Return what was asked of the drone, in the columns of its form."""
    if isinstance(asked, Setpoint):
        return (asked.theta, asked.phi, *(nan,) * 5, asked.vz, asked.yaw_rate)
    if isinstance(asked, VelocitySetpoint):
        return (nan, nan, asked.forward, asked.left, *(nan,) * 3, asked.vz, asked.yaw_rate)
    return (*(nan,) * 4, asked.x, asked.y, asked.z, nan, asked.yaw_rate)


def _sighting_rows(steps: Iterable[DatedStep]) -> Iterator[Row]:
    start = None
    for at, step in steps:
        start = step.now if start is None else start
        for seen in step.inputs.sightings:
            yield (
                *dated(at + seen.captured_at - step.now),
                seen.captured_at - start,
                seen.body,
                *seen.pose.position,
                *euler_from_quaternion(seen.pose.orientation),
                seen.received_at - seen.captured_at,
            )


def _event_rows(steps: Iterable[DatedStep]) -> Iterator[Row]:
    start = None
    for at, step in steps:
        start = step.now if start is None else start
        for event in step.outputs.events:
            yield (
                *dated(at + event.at - step.now),
                event.at - start,
                event.severity.value,
                event.code.value,
                str(event.text),
            )


TABLE_FORMS: Mapping[FlightTable, TableForm] = {
    FlightTable.STEPS: TableForm(_STEP_HEADINGS, _step_rows),
    FlightTable.SIGHTINGS: TableForm(_SIGHTING_HEADINGS, _sighting_rows),
    FlightTable.EVENTS: TableForm(_EVENT_HEADINGS, _event_rows),
}


def log_rows(log: FlightLog) -> Iterator[Row]:
    """Yield a row for each time of a log."""
    numbers = np.column_stack(
        [
            log.time,
            log.position,
            log.velocity,
            log.attitude,
            log.wanted,
            log.wanted_velocity,
            log.battery,
        ]
    )
    for row in numbers.tolist():
        when = ("", float("nan")) if log.started_at is None else dated(log.started_at + row[0])
        yield *when, *row
