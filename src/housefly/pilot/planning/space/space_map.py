"""The map of this moment in three dimensions, and trajectories through it; only the pilot uses it.

Made only where the site asks for it (``map.planner = "space"``).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from math import inf, nan, tan

import numpy as np

from housefly.config.site import Site
from housefly.geometry import GRAVITY, Vec3
from housefly.messages.obstacles import Obstacle
from housefly.messages.words import UNSAID, Words
from housefly.numeric import FloatArray, norm
from housefly.pilot.planning.people import ObservedPeople, is_walking, may_be_person
from housefly.pilot.planning.planner import GOAL, START
from housefly.pilot.planning.space.answer import (
    SpaceAnswer,
    arriving,
    cut_off,
    in_words,
    nearest_free,
    objection,
    too_fast,
)
from housefly.pilot.planning.space.approach import with_approach
from housefly.pilot.planning.space.clearance import hull_clearances
from housefly.pilot.planning.space.costs import narrowness
from housefly.pilot.planning.space.escape import ESCAPE_WEIGHT, RECEDING_GIVE, escape_mask
from housefly.pilot.planning.space.moment import SpaceMoment, corners_of
from housefly.pilot.planning.space.passage import (
    KeptDistances,
    Passage,
    first_passage,
    passages,
)
from housefly.pilot.planning.space.room_space import room_space
from housefly.pilot.planning.space.search import CellSearch, SearchScratch
from housefly.pilot.planning.space.solid_rows import live_rows
from housefly.pilot.planning.space.volumes import VolumeKind, speeds_at
from housefly.pilot.planning.space.voxels import CLEARANCE_CAP, with_rows
from housefly.pilot.planning.trajectory.speed_limits import MotionLimits
from housefly.pilot.planning.trajectory.time_scale import TRAJECTORY_START, TimeScale
from housefly.pilot.planning.trajectory.timing import STANDING, TICK, KinematicState
from housefly.pilot.planning.trajectory.trajectory import (
    CLEARANCE_GIVE,
    Trajectory,
    trajectory_along,
)
from housefly.room.grid import Cell, OccupancyGrid
from housefly.room.model import Room

PLAN_HORIZON = 1.5
"""Ways keep out of where a moving obstacle may be within this time [s] ..."""
LONG_HORIZON = 4.0
"""... those around somebody who comes along the way, within this."""
WIDE = 0.35
"""Ways keep this clearance where it costs little [m]."""
NARROW_GAIN = 2.0
"""What narrow air costs."""
ARRIVED = 0.005
"""Who stands nearer to the goal is there [m]."""
CLIMB_SHARE = 0.7
"""A trajectory climbs with this share of the largest climb rate; control has the rest."""
BRAKING = 1.0
"""How hard the drone can be counted on to brake [m/s^2]."""
SLOWED_BELOW = 0.3
"""Where the hull is nearer to things a trajectory is slower [m]."""
SLOW_GIVE = 0.02
"""A drone may be this much faster than a slow volume wants while it enters it by hand [m/s]."""
_SAME = 1e-6
"""What differs by less is the same distance [m]."""


def motion_limits(site: Site) -> MotionLimits:
    """Return what trajectories of a site may ask of the drone."""
    limits = site.limits
    return MotionLimits(
        speed=limits.speed,
        vertical_speed=CLIMB_SHARE * limits.vertical_speed_max,
        acceleration=min(limits.acceleration, GRAVITY * tan(limits.tilt_max)),
        vertical_acceleration=limits.vertical_acceleration,
        jerk=limits.jerk,
        drag=site.drone.drag,
        narrow_speed=min(site.map.narrow_speed, limits.speed),
        wide=SLOWED_BELOW,
    )


class SpaceMap:
    """Where the hull may be in one room, and how it gets from place to place.

    Attributes:
        limits: of trajectories.
        hull: the cylinder around it.
        keep: it keeps this from everything [m].
    """

    def __init__(self, site: Site, room: Room, grid: OccupancyGrid) -> None:
        self.limits = motion_limits(site)
        space = room_space(site, room)
        self.hull, self.keep = space.hull, space.keep
        self._hanging = site.map.flight_height
        self._solids, self._open_air, self._static = space.solids, space.open_air, space.static
        self._dear, self._doors = space.dear, space.doors
        slow = tuple(volume for volume in space.volumes if volume.kind is VolumeKind.SLOW)
        self._zones = partial(speeds_at, slow) if slow else None
        self._obstacles: tuple[Obstacle, ...] = ()
        self._at = 0.0
        self._people = site.people
        self._moments: dict[tuple[float, float], SpaceMoment] = {}
        self._scratch = SearchScratch()

    def update(self, obstacles: Iterable[Obstacle], now: float) -> None:
        """Take in what is known of things and people at a time [s]."""
        self._obstacles, self._at = tuple(obstacles), now
        self._moments = {}

    def trajectory(
        self, start: KinematicState, goal: Vec3, now: float, comfort: float, yaw: float = nan
    ) -> Trajectory | None:
        """Return the trajectory of ``answer``."""
        return self.answer(start, goal, now, comfort, yaw).trajectory

    def answer(
        self,
        start: KinematicState,
        goal: Vec3,
        now: float,
        comfort: float,
        yaw: float = nan,
        horizon: float = PLAN_HORIZON,
    ) -> SpaceAnswer:
        """Return a trajectory to rest at a goal, or why there is none.

        Args:
            start: where the reference is and how it moves.
            goal: middle of the hull [m].
            now: time [s].
            comfort: what the hull keeps from people [m].
            yaw: heading at the start [rad]; without it, and for a drone that moves, no way leads
                through a door that is too narrow for the hull's disc.
            horizon: it keeps out of where people may walk within this time [s]; 0 thinks of
                nobody who walks.
        """
        moment = self._moment(comfort, horizon)
        answer = self._answer(moment, start, goal)
        is_asked = np.isfinite((*goal, yaw)).all() and _stands(start)
        if answer.trajectory is not None or not is_asked:
            return answer
        live = moment.rows[len(self._solids) :]
        # A chair beside the goal is no door: the way would be seen blocked for ever.
        if hull_clearances(live, np.array([goal]), self.hull, CLEARANCE_CAP)[0] < self.keep:
            return answer
        through = self._doors.trajectory(
            live, moment.rows, start, np.array(goal), yaw, self.limits, self._zones
        )
        return answer if through is None else SpaceAnswer(through)

    def in_time(
        self,
        start: KinematicState,
        goal: Vec3,
        now: float,
        comfort: float,
        yaw: float,
        people: ObservedPeople,
    ) -> SpaceAnswer:
        """Return the way that arrives first, past people who walk in time or around them.

        Where all of them may be kept from arriving, the one around where they are soon.

        Args:
            start: where the reference is and how it moves.
            goal: middle of the hull [m].
            now: time [s].
            comfort: what the hull keeps from people [m].
            yaw: heading at the start [rad].
            people: where they are when it starts.
        """
        if not len(people.walking()):
            return arriving(self.answer(start, goal, now, comfort, yaw), comfort)
        past = self._timed(start, goal, now, comfort, yaw, people, 0.0)
        if past.passage is not None and past.passage.wait <= 0.0 and past.passage.rate >= 1.0:
            return past
        around = self._timed(start, goal, now, comfort, yaw, people, PLAN_HORIZON)
        best = past if past.arrival < around.arrival else around
        if best.arrival < inf:
            return best
        far = self._timed(start, goal, now, comfort, yaw, people, LONG_HORIZON)
        return far if far.arrival < inf else around

    def _timed(
        self,
        start: KinematicState,
        goal: Vec3,
        now: float,
        comfort: float,
        yaw: float,
        people: ObservedPeople,
        horizon: float,
    ) -> SpaceAnswer:
        answer = self.answer(start, goal, now, comfort, yaw, horizon)
        if answer.trajectory is None:
            return answer
        choices = self.passages(people, TRAJECTORY_START, answer.trajectory.rows, comfort)
        passage = first_passage(choices, 0.0)
        arrival = inf if passage is None else passage.arrival
        return replace(answer, comfort=comfort, passage=passage, arrival=arrival)

    def passages(
        self, people: ObservedPeople, scale: TimeScale, rows: FloatArray, comfort: float
    ) -> list[Passage]:
        """Return all choices of getting past people who walk, the earliest arrival first.

        Args:
            people: where they are now.
            scale: how far the trajectory has been flown.
            rows: of the trajectory, shape (n, 9) or wider.
            comfort: what the hull keeps from people [m].
        """
        config = self._people
        kept = KeptDistances(
            hull=self.hull.radius,
            comfort=comfort,
            least=min(comfort, config.min_distance),
            slow=config.slow_distance,
            slowest=config.comfort_distance,
        )
        return passages(people.walking(), scale, rows, TICK, kept, BRAKING)

    def is_flown(self, goal: Vec3) -> bool:
        """Return whether a way leads from home to a place [m] while nothing new stands there."""
        voxels, voxel = self._static, self._static.voxel_of(goal)
        if not voxels.contains(voxel):
            return False
        return bool(voxels.allowed[voxel]) and float(voxels.clearance[voxel]) >= voxels.keep

    def closed_along(self, places: FloatArray, speeds: FloatArray) -> Words:
        """Return what of the room closes a short way, in words, or UNSAID.

        A drone that is too near to something already may go where it gets no nearer.

        Args:
            places: of its middle, the first is where it is [m], shape (n, 3).
            speeds: there [m/s], shape (n,).
        """
        voxels = [self._static.voxel_of((x, y, z)) for x, y, z in places.tolist()]
        if not all(self._static.contains(one) and self._static.allowed[one] for one in voxels):
            return Words("the end of where it may fly is ahead")
        if self._zones is not None and (speeds > self._zones(places) + SLOW_GIVE).any():
            return Words("it flies slowly here by order")
        near = hull_clearances(self._solids, places, self.hull, CLEARANCE_CAP)
        # Not a hair nearer than now: many short ways would add up.
        least = min(self.keep - CLEARANCE_GIVE, float(near[0]) - _SAME)
        is_free = near[0] > 0.0 and (near >= least).all()
        return UNSAID if is_free else Words("a wall or furniture is ahead")

    def layer(self, height: float) -> OccupancyGrid:
        """Return the map of now at a height of the drone's middle [m], without people."""
        things = [one for one in self._obstacles if not may_be_person(one)]
        voxels = with_rows(self._static, live_rows(things, self._at, 0.0, 0.0, self._hanging))
        k = int((height - voxels.origin[2]) / voxels.resolution)
        k = min(max(k, 0), voxels.shape[2] - 1)
        clearance = voxels.clearance[:, :, k].astype(np.float64)
        cells = np.full(clearance.shape, Cell.FREE, dtype=np.uint8)
        cells[clearance < voxels.keep] = Cell.INFLATED
        cells[clearance <= 0.0] = Cell.OCCUPIED
        air = self._open_air[:, :, k]
        cells[~(air if air.any() else self._open_air.any(axis=2))] = Cell.VIRTUAL
        return OccupancyGrid(
            voxels.origin[:2], voxels.resolution, cells, clearance + self.hull.radius
        )

    def _answer(self, moment: SpaceMoment, start: KinematicState, goal: Vec3) -> SpaceAnswer:
        voxels = moment.voxels
        if why := objection(voxels, self._open_air, GOAL, goal):
            return SpaceAnswer(None, why, nearest_free(voxels, moment.free, goal))
        x, y, z = start.place.tolist()
        if not voxels.contains(voxels.voxel_of((x, y, z))):
            why = objection(voxels, self._open_air, START, (x, y, z))
            return SpaceAnswer(None, why, nearest_free(voxels, moment.free, (x, y, z)))
        end, clearance = moment.kept(goal), moment.clearance(start.place)
        if norm(end - start.place) < ARRIVED and _stands(start):
            return SpaceAnswer(_staying(start, clearance))
        if not moment.is_free(start.place) or clearance < voxels.keep - CLEARANCE_GIVE:
            return self._escaping(moment, start, end)
        corners = moment.corners(start.place, end)
        if corners is None:
            return cut_off(moment.voxels, moment.free, (x, y, z), goal)
        flight = trajectory_along(
            voxels, moment.free, moment.rows, corners, start, self.limits, self._zones
        )
        return SpaceAnswer(flight) if flight is not None else too_fast(_stands(start))

    def _moment(self, comfort: float, horizon: float = PLAN_HORIZON) -> SpaceMoment:
        """Return the map of now; made when somebody plans, because most steps do not."""
        key = comfort, horizon
        if key not in self._moments:
            live = self._live(comfort, horizon)
            standing = live_rows(self._obstacles, self._at, 0.0, 0.0, self._hanging)
            voxels = with_rows(self._static, live)
            weights = narrowness(voxels, WIDE, NARROW_GAIN) + self._dear
            free, rows = voxels.free(), np.concatenate((self._solids, live))
            self._moments[key] = SpaceMoment(voxels, free, weights, rows, standing, self._scratch)
        return self._moments[key]

    def _live(self, comfort: float, horizon: float) -> FloatArray:
        """Return the rows of what is not of the room; who walks wants less room behind."""
        walkers = [one for one in self._obstacles if is_walking(one)]
        others = [one for one in self._obstacles if not is_walking(one)]
        rows = live_rows(others, self._at, PLAN_HORIZON, comfort, self._hanging)
        if not walkers or horizon <= 0.0:
            return rows
        ways = live_rows(walkers, self._at, horizon, comfort, self._hanging)
        return np.concatenate((rows, with_approach(ways, comfort, self._people.min_distance)))

    def _escaping(self, moment: SpaceMoment, start: KinematicState, end: FloatArray) -> SpaceAnswer:
        voxels = moment.voxels
        opened = escape_mask(
            self._static, moment.free, self._open_air, start.place, moment.standing
        )
        dear = moment.weights.copy()
        dear.ravel()[np.flatnonzero(opened > moment.free)] += ESCAPE_WEIGHT
        search = CellSearch(opened, dear, moment.scratch)
        corners = corners_of(voxels, search, start.place, end)
        x, y, z = start.place.tolist()
        if corners is None:
            why = objection(voxels, self._open_air, START, (x, y, z))
            why = why or Words(
                "{end} {place} is too close to an obstacle", end=START, place=in_words((x, y, z))
            )
            return SpaceAnswer(None, why, nearest_free(voxels, moment.free, (x, y, z)))
        least = min(voxels.keep, moment.clearance(start.place) - RECEDING_GIVE)
        lower = replace(voxels, keep=max(least, 0.0))
        flight = trajectory_along(
            lower, opened, moment.rows, corners, start, self.limits, self._zones
        )
        return SpaceAnswer(flight) if flight is not None else too_fast(_stands(start))


def _stands(start: KinematicState) -> bool:
    return norm(start.velocity) < STANDING


def _staying(start: KinematicState, clearance: float) -> Trajectory:
    rows = np.zeros((2, 9))
    rows[:, :3] = start.place
    return Trajectory(rows, 0.0, clearance)
