"""A log of others as a table, with the columns that a table of our flights has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from housefly.app.event_table import CellType, Row, dated
from housefly.record.flight_log import FlightLog

LOG_HEADINGS: Mapping[str, CellType] = {
    "time": str, "unix": float, "t_s": float, "x_m": float, "y_m": float, "z_m": float,
    "vx_m_s": float, "vy_m_s": float, "vz_m_s": float, "phi_rad": float, "theta_rad": float,
    "yaw_rad": float, "ref_x_m": float, "ref_y_m": float, "ref_z_m": float,
    "ref_yaw_rad": float, "cmd_vx_m_s": float, "cmd_vy_m_s": float, "cmd_vz_m_s": float,
    "cmd_yaw_rate_rad_s": float, "battery": float,
}  # fmt: skip
"""Columns and their types; ``time`` and ``unix`` are empty where the log does not say when."""


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
