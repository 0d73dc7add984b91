"""Obstacles: from seen to stopped, from stopped to a new way, and what looking costs."""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace
from math import hypot

import numpy as np

from _run import percentile, table
from housefly.config.site import Site, changed
from housefly.geometry import Vec2, stopping_distance
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import EventCode, Obstacle, Order, OrderKind, PilotStep
from housefly.perception.laser_tracker import LaserTracker
from housefly.pilot.navigator import RoomNavigator
from housefly.room.distance import half_diagonal
from housefly.sensors.laser import scan_of
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.twin.movable import Movable
from housefly.twin.world import SimulatedWorld
from housefly.wires.scip import UST_10LX

LASERS = [
    {"name": "laser-1", "x": 5.5, "y": 0.85, "z": 1.1, "yaw": 1.2},
    {"name": "laser-2", "address": "127.0.0.2", "x": 13.9, "y": 3.3, "z": 1.1, "yaw": -2.6},
]
DISTANCES = (0.95, 1.0, 1.05, 1.1, 1.15)
SEEDS = (1, 2, 3)
CHAIR = 0.25


@dataclass
class Stop:
    """One flight towards a chair that is put on the path."""

    ahead: float
    put_at: float = 0.0
    place: Vec2 = (0.0, 0.0)
    told_at: float = 0.0
    start: Vec2 = (0.0, 0.0)
    speed: float = 0.0
    rest_at: float = 0.0
    way: float = 0.0
    detour_at: float = 0.0
    closest: float = 9.0
    track: list[tuple[float, Vec2, float]] = field(default_factory=list)

    def world(self, world: SimulatedWorld) -> None:
        """Put the chair in the way when it is time, and note where the drone is."""
        truth = world.truth()
        (x, y, _), (vx, vy, _) = truth.pose.position, truth.velocity
        speed = hypot(vx, vy)
        self.track.append((world.now, (x, y), speed))
        if not self.put_at and x < 8.0 and speed > 0.45:
            self.place, self.put_at = (
                (x + vx / speed * self.ahead, y + vy / speed * self.ahead),
                world.now,
            )
            world.put("chair", self.place)
        if self.put_at:
            self.closest = min(self.closest, hypot(x - self.place[0], y - self.place[1]) - CHAIR)

    def step(self, step: PilotStep) -> None:
        """Note what the pilot tells."""
        for event in step.outputs.events:
            if event.code is EventCode.WAY_BLOCKED and not self.told_at:
                self.told_at = event.at
            if event.code is EventCode.DETOUR and self.told_at and not self.detour_at:
                self.detour_at = event.at

    def measure(self) -> None:
        """Work out the way to rest."""
        after = [
            (now, place, speed) for now, place, speed in self.track if now >= self.told_at - 1e-6
        ]
        _, self.start, self.speed = after[0]
        self.rest_at, place, _ = next(row for row in after if row[2] < 0.1)
        self.way = hypot(place[0] - self.start[0], place[1] - self.start[1])


def stops() -> list[Stop]:
    done = []
    for seed in SEEDS:
        loaded = open_site(
            changed(read_site("bsen"), lasers=LASERS, twin__visitor_present=False, twin__seed=seed)
        )
        for ahead in DISTANCES:
            stop = Stop(ahead)
            order = Order(OrderKind.GO, "entrance")
            fly_lockstep(loaded, order, stop.step, 17.0, (Movable("chair", CHAIR),), stop.world)
            if stop.told_at:
                stop.measure()
                done.append(stop)
    return done


def milliseconds(times: list[float]) -> str:
    return (
        f"{1e3 * percentile(times, 0.5):.2f} / {1e3 * percentile(times, 0.99):.2f} /"
        f" {1e3 * max(times):.2f} ms"
    )


def timed(action: object, count: int) -> list[float]:
    times = []
    for n in range(count):
        begin = time.thread_time()
        action(n)  # type: ignore[operator]
        times.append(time.thread_time() - begin)
    return times


def perception(loaded: LoadedSite) -> list[float]:
    site = loaded.site
    world = SimulatedWorld(site, loaded.room, movables=(Movable("a"), Movable("b")))
    tracker = LaserTracker(loaded.room, site.lasers)
    scans = []
    for n in range(400):
        world.put("a", (6.0 + 0.01 * n, 3.0))
        world.put("b", (9.0 - 0.01 * n, 2.5))
        now = 1.0 + 0.025 * n
        scans.append(scan_of(world.scan("laser-1"), UST_10LX, site.lasers[0], now, now))
    for scan in scans[:20]:
        tracker.update(scan, scan.received_at)
    return timed(lambda n: tracker.update(scans[20 + n], scans[20 + n].received_at), 380)


def planning(loaded: LoadedSite, count: int) -> tuple[list[float], list[float], list[float]]:
    """Return times of hearing, of the look along the path, and of map and plan, among so many
    moving obstacles.
    """
    random = np.random.default_rng(1)
    navigator = RoomNavigator(loaded.site, loaded.room, loaded.grid)
    start, goal = loaded.room.home, loaded.room.place("entrance").viewpoint
    path = navigator.route(start, goal).path
    assert path is not None
    crowd = [
        Obstacle(str(n), (float(x), float(y)), 0.2, velocity=(0.3, 0.0), confidence=1.0)
        for n, (x, y) in enumerate(random.uniform((1.0, 6.0), (14.0, 9.0), (count, 2)))
    ]
    moved = [[replace(one, seen_at=0.05 * n) for one in crowd] for n in range(300)]
    navigator.update(tuple(moved[0]), (), 0.0)
    hear, look, plan = [], [], []
    for n, heard in enumerate(moved):
        hear += timed(lambda _, n=n, heard=heard: navigator.update(tuple(heard), (), 0.05 * n), 1)
        look += timed(lambda _: navigator.block(start, path, 1), 1)
        plan += timed(lambda _: navigator.route(start, goal), 1)
    return hear[1:], look[1:], plan[1:]


def main() -> None:
    done = stops()
    braking = Site().drone.airframe.braking
    allowed = [
        stopping_distance(stop.speed, braking.deceleration, 0.1) + 0.3 * stop.speed for stop in done
    ]
    hull = half_diagonal(0.517, 0.451)
    print("### Obstacles\n")
    print(
        table(
            ["from the moment that a chair stands in the way", "median", "worst", "wanted"],
            [
                ["seen and told", *both([s.told_at - s.put_at for s in done], "s"), ""],
                [
                    "way from told to rest",
                    *both([s.way for s in done], "m"),
                    f"one stopping distance + 0.3 s: {min(allowed):.2f} m",
                ],
                ["time from told to rest", *both([s.rest_at - s.told_at for s in done], "s"), ""],
                [
                    "from rest to a new way",
                    *both([max(0.0, s.detour_at - s.rest_at) for s in done], "s"),
                    "it makes way first: this may be somebody",
                ],
                [
                    "closest to the chair",
                    f"{percentile([s.closest for s in done], 0.5):.2f} m",
                    f"{min(s.closest for s in done):.2f} m",
                    f"more than the hull: {hull:.2f} m",
                ],
            ],
        )
    )
    loaded = open_site(changed(read_site("bsen"), lasers=LASERS, twin__visitor_present=False))
    rows = [["perception, one scan of 1081 beams, two people", milliseconds(perception(loaded))]]
    for count in (1, 8, 64):
        hear, look, plan = planning(loaded, count)
        rows.append([f"heard and remembered, {count} moving obstacles", milliseconds(hear)])
        rows.append([f"look along the path, {count} obstacles", milliseconds(look)])
        rows.append([f"map made anew and new plan, {count} obstacles", milliseconds(plan)])
    print()
    print(table(["time of the thread", "median / 99 % / worst"], rows))
    print(
        f"\n{len(done)} flights in lock step at 0.5 m/s, a chair of radius {CHAIR} m put"
        f" {min(DISTANCES)} to {max(DISTANCES)} m ahead, two simulated UST-10LX, 30 ms latency."
    )


def both(values: list[float], unit: str) -> tuple[str, str]:
    return f"{percentile(values, 0.5):.2f} {unit}", f"{max(values):.2f} {unit}"


if __name__ == "__main__":
    main()
