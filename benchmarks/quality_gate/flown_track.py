"""What one flight did, tick by tick, on the truth of the simulated room."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from housefly.messages import PilotStep
from housefly.numeric import FloatArray
from housefly.twin.world import SimulatedWorld

COLUMNS = ("at", "x", "y", "z", "vx", "vy", "vz", "rx", "ry", "rz", "yaw")
"""Time [s], true place [m] and velocity [m/s], the reference [m] (not a number where there is
none), true heading [rad].
"""


@dataclass(slots=True)
class FlownTrack:
    """Rows of ``COLUMNS``, one for each step of the pilot.

    Attributes:
        rows: so far.
    """

    rows: list[tuple[float, ...]] = field(default_factory=list)

    def add(self, world: SimulatedWorld, step: PilotStep, yaw: float) -> None:
        """Note where the drone truly is and where it was wanted."""
        truth, reference = world.truth(), step.outputs.reference
        wanted = (np.nan,) * 3 if reference is None else reference.position
        self.rows.append((step.now, *truth.pose.position, *truth.velocity, *wanted, yaw))

    def part(self, first: int, last: int | None = None) -> FloatArray:
        """Return some rows, shape (n, 11)."""
        return np.array(self.rows[first:last], dtype=np.float64).reshape(-1, len(COLUMNS))
