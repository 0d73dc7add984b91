"""Whether something stands below the drone that no map shows: its own sensor against tracking."""

from __future__ import annotations

from math import dist, inf, isfinite, nan

from housefly.geometry import Vec3
from housefly.messages.sensing import REPORT_AGE_MAX, DroneStatus
from housefly.pilot.behavior.mission import VehicleStatus
from housefly.pilot.behavior.pad_floor import PadFloor
from housefly.pilot.behavior.shown_everywhere import ShownEverywhere

HEIGHT_GAP_MAX = 0.25
"""Something stands below when the floor seems nearer than tracking says by more than this [m]."""
RANGE_MIN = 0.2
"""The sonar measures nothing nearer than this: a lower height says that something is near [m]."""
BEAM_RADIUS = 0.3
"""So far around the drone's middle the sonar may find something [m]."""
GAP_TIME = 0.3
"""Something stands below for sure when the heights disagree for this long [s]."""
AGREEMENT_TIME = 0.2
"""... and nothing any more when they agree for so long: echoes from near come and go [s]."""
FLOOR_READING = 0.05
"""A sonar that never told more than this in the air tells what it did on the floor [m]."""
STUCK_WAY, STUCK_STEP = 2.0, 0.25
"""A sonar that tells the same to the last bit while the drone flies this far, in steps as long as
this, is stuck and shows nothing [m]: what stands below begins, ends, or is not that flat.
"""


class SonarMonitor:
    """Holds the height by the drone's own sonar against the tracked one, in the air."""

    def __init__(self) -> None:
        self._has_worked = False
        self._since = self._until = inf
        self._found = 0.0
        self._pad = PadFloor()
        self._everywhere = ShownEverywhere()
        self._told = nan
        self._way, self._passed = 0.0, (0.0, 0.0, 0.0)

    @property
    def found(self) -> float:
        """How high above the floor something seems to stand below [m]; 0 while nothing does."""
        return self._found

    @property
    def is_wrong(self) -> bool:
        """Whether it shows something everywhere, so that nothing is believed to stand below."""
        return self._everywhere.is_wrong

    @property
    def words(self) -> str:
        """What seems to stand below, in words."""
        if self._found > HEIGHT_GAP_MAX:
            return f"something {self._found:.1f} m high seems to stand below"
        return f"something {self._found:.2f} m high seems to lie on the pad: is it clear?"

    def is_sure(self, now: float) -> bool:
        """Return whether it has seemed so for long enough, now [s]."""
        return now - self._since >= GAP_TIME

    def step(self, vehicle: VehicleStatus) -> None:
        """Take in what the drone says and where tracking sees it."""
        self._pad.step(vehicle)
        gap = self._gap(vehicle)
        if gap > 0.0:
            self._found = gap
            self._since = min(self._since, vehicle.now)
            self._until = vehicle.now + AGREEMENT_TIME
        elif vehicle.now >= self._until:
            self._found, self._since, self._until = 0.0, inf, inf

    def _gap(self, vehicle: VehicleStatus) -> float:
        """Return how high what stands below is [m], at least; 0 for nothing, or unknown."""
        report, position = vehicle.telemetry, vehicle.position
        if report is None or position is None or vehicle.status is not DroneStatus.FLYING:
            self._has_worked = False
            self._everywhere.forget()
            return 0.0
        if vehicle.telemetry_age > REPORT_AGE_MAX or not isfinite(report.height):
            return 0.0
        self._has_worked |= report.height > FLOOR_READING
        if not self._has_worked or self._is_stuck(report.height, position):
            return 0.0
        floor = self._pad.offset_at(position[:2])
        gap = position[2] - floor - max(report.height, RANGE_MIN)
        is_shown = gap > HEIGHT_GAP_MAX
        self._everywhere.step(position[:2], gap if is_shown else 0.0)
        if self.is_wrong:
            return 0.0
        return gap if is_shown else self._pad.height

    def _is_stuck(self, told: float, position: Vec3) -> bool:
        """Return whether the sonar has told the same [m] for the whole of a long way."""
        if told != self._told:
            self._told, self._way, self._passed = told, 0.0, position
        elif (step := dist(position, self._passed)) >= STUCK_STEP:
            self._way, self._passed = self._way + step, position
        return self._way >= STUCK_WAY
