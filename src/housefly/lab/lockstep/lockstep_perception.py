"""Scanners, depth cameras and perception of a site on a stepped clock, without wires."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from functools import partial

from housefly.config.laser import LaserConfig
from housefly.config.site import Site
from housefly.messages import Estimate, Obstacle
from housefly.perception.beams import BeamScan
from housefly.perception.depth_tracker import DepthTracker
from housefly.perception.laser_tracker import OWN_MARGIN, LaserTracker, OwnFootprint
from housefly.perception.sensor_freshness import SensorFreshness
from housefly.room.distance import half_diagonal
from housefly.room.tracked import untracked
from housefly.sensors.laser import metres_of
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.world import SimulatedWorld
from housefly.wires.scip.parameters import MODELS


class LockstepPerception:
    """Takes scans and images when they are due; scans reach perception after their latency.

    Args:
        loaded: sensors and what they know of the room.
        world: what they look at.
        faults: what befalls scans and images on their way.
    """

    def __init__(self, loaded: LoadedSite, world: SimulatedWorld, faults: FaultInjector) -> None:
        self._site, self._world, self._faults = loaded.site, world, faults
        site, known = loaded.site, untracked(loaded.room, loaded.site)
        self._tracker = LaserTracker(known, site.lasers)
        height, half = site.map.flight_height, site.map.half_band
        self._depth = DepthTracker(known, site.depth_cameras, (height - half, height + half))
        self._due = {laser.name: 0.0 for laser in site.lasers}
        self._image_due = {camera.name: 0.0 for camera in site.depth_cameras}
        self._under_way: deque[tuple[float, BeamScan]] = deque()
        self._scans, self._images = SensorFreshness(self._due), SensorFreshness(self._image_due)

    @property
    def people_seen_at(self) -> float:
        """Until when every sensor was believed [s], as ``Inputs.people_seen_at``."""
        return min(self._scans.seen_at, self._images.seen_at)

    def update(self, now: float, estimates: Iterable[Estimate | None]) -> tuple[Obstacle, ...]:
        """Return the news of obstacles at a time [s], given the pilots' estimates."""
        own = own_footprints(self._site, estimates)
        for laser in self._site.lasers:
            if now >= self._due[laser.name]:
                self._due[laser.name] = now + MODELS[laser.model].period - 1e-6
                read = partial(self._world.scan, laser.name)
                for _, ranges in self._faults.scan(laser.name, read, now):
                    self._send(laser, ranges, now + laser.latency)
        obstacles: list[Obstacle] = []
        while self._under_way and self._under_way[0][0] <= now:
            _, scan = self._under_way.popleft()
            seen = self._tracker.update_beams(scan, now, own)
            if not seen.problem:
                self._scans.believed(scan.source, scan.captured_at)
            obstacles.extend(seen.obstacles)
        for camera in self._site.depth_cameras:
            if now >= self._image_due[camera.name]:
                self._image_due[camera.name] = now + 1.0 / camera.rate_hz - 1e-6
                take = partial(self._world.depth_image, camera.name, now)
                for image in self._faults.depth_images(camera.name, take, now):
                    found = self._depth.update(image, now, own)
                    if not found.problem:
                        self._images.believed(image.source, image.captured_at)
                    obstacles.extend(found.obstacles)
        return tuple(obstacles)

    def _send(self, laser: LaserConfig, ranges: tuple[int, ...], arrival: float) -> None:
        """Send a scan on its way: distances [mm], and when it arrives [s]."""
        parameters = MODELS[laser.model]
        scan = BeamScan(
            laser.name,
            arrival - laser.latency,
            parameters.first_angle,
            parameters.step,
            metres_of(ranges, parameters),
        )
        self._under_way.append((arrival, scan))


def own_footprints(site: Site, estimates: Iterable[Estimate | None]) -> tuple[OwnFootprint, ...]:
    """Return the ground that drones cover themselves, without those whose place is unknown."""
    reach = max(half_diagonal(drone.hull_length, drone.hull_width) for drone in site.all_drones)
    return tuple(
        OwnFootprint(estimate.position[:2], reach + OWN_MARGIN)
        for estimate in estimates
        if estimate is not None
    )
