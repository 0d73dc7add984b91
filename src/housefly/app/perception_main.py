"""The perception process: finds obstacles in scans and depth images and sends them to the pilot.

``python -m housefly.app.perception_main``, started by the launcher where the site has scanners or
depth cameras. When it dies, the pilot forgets its obstacles within two seconds and flies by the map
alone, slowly; the launcher restarts it.
"""

from __future__ import annotations

import asyncio
import contextlib
import signal

from housefly.app.depth_service import DepthService
from housefly.app.runtime import Runtime, runtime_from_environment
from housefly.bus.bus import Bus, Subscription
from housefly.bus.topics import OBSTACLE_TOPIC, SENSOR_TOPIC, SIGHT_TOPIC, DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import Clock, RealClock
from housefly.config.process_log import log_line
from housefly.config.site import Site
from housefly.config.text import without_numbers
from housefly.lab.lockstep.lockstep_perception import own_footprints
from housefly.messages import DroneStatus, PilotStep, Scan, SensorReport, SightNews
from housefly.messages.words import literal
from housefly.perception.laser_tracker import LaserTracker, OwnFootprint
from housefly.perception.sensor_freshness import SensorFreshness
from housefly.room.tracked import untracked
from housefly.sensors.lasers import AnyLaserClient, laser_client
from housefly.sensors.message_rate import MessageRate
from housefly.sites.loaded_site import LoadedSite, open_site

_REPORT_PERIOD = 1.0
"""How often the state of the sensors is published, and changed problems are printed [s]."""
_SIGHT_PERIOD = 0.1
"""How often the pilot is told until when people were looked for [s]."""


class PerceptionProcess:
    """Runs the scanners and depth cameras of a site on one asyncio loop."""

    def __init__(self, loaded: LoadedSite, bus: Bus, clock: Clock) -> None:
        self._site, self._bus, self._clock = loaded.site, bus, clock
        self._tracker = LaserTracker(untracked(loaded.room, loaded.site), loaded.site.lasers)
        self._clients = {laser.name: laser_client(laser, clock) for laser in loaded.site.lasers}
        self._rates = {name: MessageRate() for name in self._clients}
        self._sight = SensorFreshness(self._clients)
        self._depth = DepthService(loaded, bus, clock)
        self._own: dict[str, tuple[OwnFootprint, ...]] = dict.fromkeys(self._site.drone_names, ())
        self._doubts: dict[str, str] = {}

    async def run(self) -> None:
        """Run until cancelled."""
        steps = [self._heard(self._site.for_drone(name)) for name in self._site.drone_names]
        try:
            await asyncio.gather(
                *(client.run(self._on_scan) for client in self._clients.values()),
                self._report_sensors(),
                self._report_sight(),
            )
        finally:
            for subscription in steps:
                subscription.close()
            self._depth.close()

    def _heard(self, site: Site) -> Subscription:
        """Follow where the drone of a site is."""

        def on_step(step: PilotStep) -> None:
            telemetry = step.inputs.telemetry
            on_the_ground = telemetry is not None and telemetry.status is DroneStatus.LANDED
            estimate = None if on_the_ground else step.outputs.estimate
            where = own_footprints(site, (estimate,))
            self._own[site.drone.name] = where  # each on a thread of its own
            self._depth.own = self._all_own()

        return self._bus.subscribe(DroneTopics(site.drone.name).step, on_step)

    def _all_own(self) -> tuple[OwnFootprint, ...]:
        return tuple(one for each in self._own.values() for one in each)

    def _on_scan(self, scan: Scan) -> None:
        seen = self._tracker.update(scan, self._clock.now(), self._all_own())
        self._rates[scan.source].add(scan.received_at)
        self._doubts[scan.source] = seen.problem
        if not seen.problem:
            self._sight.believed(scan.source, scan.captured_at)
        for obstacle in seen.obstacles:
            self._bus.publish(OBSTACLE_TOPIC, obstacle)

    def _reports(self) -> tuple[SensorReport, ...]:
        return (
            *(self._laser(name, client) for name, client in self._clients.items()),
            *self._depth.reports(),
        )

    def _laser(self, name: str, client: AnyLaserClient) -> SensorReport:
        now, rate = self._clock.now(), self._rates[name]
        problem = client.problem or literal(self._doubts.get(name, ""))
        return SensorReport(
            name, "laser scanner", client.connected, rate.rate_hz(now), rate.age(now), problem
        )

    async def _report_sight(self) -> None:
        while True:
            seen_at = min(self._sight.seen_at, self._depth.sight.seen_at)
            self._bus.publish(SIGHT_TOPIC, SightNews(seen_at))
            await asyncio.sleep(_SIGHT_PERIOD)

    async def _report_sensors(self) -> None:
        printed = ""
        while True:
            await asyncio.sleep(_REPORT_PERIOD)
            reports = self._reports()
            for report in reports:
                self._bus.publish(SENSOR_TOPIC, report)
            problems = "; ".join(report.problem for report in reports if report.problem)
            if without_numbers(problems) != printed:
                log_line(f"perception: {problems or 'everything that looks is heard'}")
                printed = without_numbers(problems)


async def _run(runtime: Runtime, loaded: LoadedSite) -> None:
    with ZenohBus(connect=runtime.bus) as bus:
        running = asyncio.create_task(PerceptionProcess(loaded, bus, RealClock()).run())
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, running.cancel)
        log_line("perception ready")
        with contextlib.suppress(asyncio.CancelledError):
            await running


def main() -> None:
    """Run until SIGINT or SIGTERM."""
    runtime = runtime_from_environment()
    asyncio.run(_run(runtime, open_site(runtime.site())))


if __name__ == "__main__":
    main()
