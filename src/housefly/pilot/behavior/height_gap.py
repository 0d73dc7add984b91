"""Whether something stands below the drone that no map shows: its own sensor against tracking."""

from __future__ import annotations

from collections import deque
from math import dist, inf, isfinite, nan

from housefly.config.airframe import SonarConstants
from housefly.geometry import Vec2, Vec3, distance
from housefly.messages.sensing import REPORT_AGE_MAX, DroneStatus
from housefly.messages.words import Words, figure
from housefly.pilot.behavior.mission import VehicleStatus
from housefly.pilot.behavior.pad_floor import PadFloor

HEIGHT_GAP_MAX = 0.25
"""Something stands below when the floor seems nearer than tracking says by more than this [m]."""
GAP_TIME = 0.3
"""Something stands below for sure when the heights disagree for this long [s]."""
AGREEMENT_TIME = 0.2
"""... and nothing any more when they agree for so long: echoes from near come and go [s]."""
FLOOR_READING = 0.05
"""A sonar that never told more than this in the air tells what it did on the floor [m]."""
WAY_STEP = 0.25
"""The way of the drone is looked at in steps of this length [m]."""
STUCK_WAY = 2.0
"""A sonar that tells the same to the last bit while the drone flies this far is stuck and shows
nothing [m]: what stands below begins, ends, or is not that flat.
"""
EVERYWHERE_STEPS, SHOWN_STEPS = 12, 11
"""Of so many steps something showed in so many: no piece of furniture is as long."""
LOW_MAX = 0.55
"""Who may follow the drone is taller than this [m]: what is lower on average does not walk."""


class SonarMonitor:
    """Holds the height by the drone's own sonar against the tracked one, in the air.

    Without a sonar nothing ever seems to stand below.
    """

    def __init__(self, sonar: SonarConstants | None) -> None:
        self._sonar = sonar
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
    def words(self) -> Words:
        """What seems to stand below, in words."""
        if self._found > HEIGHT_GAP_MAX:
            height = figure(self._found, ".1f")
            return Words("something {d} m high seems to stand below", d=height)
        height = figure(self._found, ".2f")
        return Words("something {d} m high seems to lie on the pad: is it clear?", d=height)

    def is_sure(self, now: float) -> bool:
        """Return whether it has seemed so for long enough, now [s]."""
        return now - self._since >= GAP_TIME

    def step(self, vehicle: VehicleStatus) -> None:
        """Take in what the drone says and where tracking sees it."""
        if self._sonar is None:
            return
        self._pad.step(vehicle)
        gap = self._gap(vehicle, self._sonar.range_min)
        if gap > 0.0:
            self._found = gap
            self._since = min(self._since, vehicle.now)
            self._until = vehicle.now + AGREEMENT_TIME
        elif vehicle.now >= self._until:
            self._found, self._since, self._until = 0.0, inf, inf

    def _gap(self, vehicle: VehicleStatus, range_min: float) -> float:
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
        gap = position[2] - floor - max(report.height, range_min)
        is_shown = gap > HEIGHT_GAP_MAX
        self._everywhere.step(position[:2], gap if is_shown else 0.0)
        if self.is_wrong:
            return 0.0
        return gap if is_shown else self._pad.height

    def _is_stuck(self, told: float, position: Vec3) -> bool:
        """Return whether the sonar has told the same [m] for the whole of a long way."""
        if told != self._told:
            self._told, self._way, self._passed = told, 0.0, position
        elif (step := dist(position, self._passed)) >= WAY_STEP:
            self._way, self._passed = self._way + step, position
        return self._way >= STUCK_WAY


class ShownEverywhere:
    """Remembers on which steps of the last way something showed below.

    What stands below begins and ends. A sonar that is off by a constant, or noisy, shows something
    on the whole of a long way; tracking that is too high looks the same, and is as harmless to land
    by.
    """

    def __init__(self) -> None:
        self._steps: deque[bool] = deque(maxlen=EVERYWHERE_STEPS)
        self._begun: Vec2 | None = None
        self._shown = 0
        self._height = 0.0

    @property
    def is_wrong(self) -> bool:
        """Whether something low has shown nearly everywhere on the last three metres."""
        return len(self._steps) == EVERYWHERE_STEPS and sum(self._steps) >= SHOWN_STEPS

    def forget(self) -> None:
        """Begin anew: the drone does not fly."""
        self._steps.clear()
        self._begun, self._shown, self._height = None, 0, 0.0

    def step(self, place: Vec2, height: float) -> None:
        """Take in how high what shows below a place [m] is [m]; 0 where nothing does."""
        if self._begun is None:
            self._begun = place
        if height > 0.0:
            self._shown += 1
            self._height += height
        if distance(place, self._begun) < WAY_STEP:
            return
        self._steps.append(0.0 < self._height < LOW_MAX * self._shown)
        self._begun, self._shown, self._height = place, 0, 0.0
