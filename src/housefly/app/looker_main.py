"""The process that looks: reads scanners and depth images, follows what no map shows, and tells the
pilot over the bus.

``python -m housefly.app.looker_main``, started by the launcher where the site has scanners or depth
cameras. When it dies, the pilot forgets what it was told within two seconds and flies by the map
alone, as without it; the launcher starts it again.
"""

from __future__ import annotations

import asyncio
import contextlib
import signal

from housefly.app.depth_desk import DepthDesk
from housefly.app.lookers import own_of
from housefly.app.premises import Premises, open_premises
from housefly.app.runtime import Runtime, runtime_from_environment
from housefly.bus.bus import Bus
from housefly.bus.topics import OBSTACLE, SENSOR, STEP
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import Clock, RealClock
from housefly.messages import DroneStatus, Estimate, PilotStep, Scan, SensorReport
from housefly.perception.watcher import Watcher
from housefly.room.tracked import untracked
from housefly.sensors.laser import LaserClient
from housefly.sensors.pulse import Pulse

TELL_PERIOD = 1.0
"""How often the bus is told how the sensors do, and changed problems are printed [s]."""


class Looker:
    """All scanners of a site on one asyncio loop, and its depth cameras."""

    def __init__(self, premises: Premises, bus: Bus, clock: Clock) -> None:
        self._site, self._bus, self._clock = premises.site, bus, clock
        self._watcher = Watcher(untracked(premises.room, premises.site), premises.site.lasers)
        self._clients = {laser.name: LaserClient(laser, clock) for laser in premises.site.lasers}
        self._pulses = {name: Pulse() for name in self._clients}
        self._depth = DepthDesk(premises, bus, clock)
        self._estimate: Estimate | None = None
        self._doubts: dict[str, str] = {}

    async def run(self) -> None:
        """Look until cancelled."""
        steps = self._bus.subscribe(STEP, self._on_step)
        try:
            await asyncio.gather(
                *(client.run(self._on_scan) for client in self._clients.values()), self._tell()
            )
        finally:
            steps.close()
            self._depth.close()

    def _on_step(self, step: PilotStep) -> None:
        telemetry = step.inputs.telemetry
        on_the_ground = telemetry is not None and telemetry.status is DroneStatus.LANDED
        self._estimate = None if on_the_ground else step.outputs.estimate
        self._depth.own = own_of(self._site, self._estimate)

    def _on_scan(self, scan: Scan) -> None:
        seen = self._watcher.step(scan, self._clock.now(), own_of(self._site, self._estimate))
        self._pulses[scan.source].beat(scan.received_at)
        self._doubts[scan.source] = seen.problem
        for obstacle in seen.obstacles:
            self._bus.publish(OBSTACLE, obstacle)

    def _reports(self) -> tuple[SensorReport, ...]:
        return (
            *(self._laser(name, client) for name, client in self._clients.items()),
            *self._depth.reports(),
        )

    def _laser(self, name: str, client: LaserClient) -> SensorReport:
        now, pulse = self._clock.now(), self._pulses[name]
        problem = client.problem or self._doubts.get(name, "")
        return SensorReport(
            name, "laser scanner", client.connected, pulse.rate_hz(now), pulse.age(now), problem
        )

    async def _tell(self) -> None:
        told: tuple[str, ...] = ()
        while True:
            await asyncio.sleep(TELL_PERIOD)
            reports = self._reports()
            for report in reports:
                self._bus.publish(SENSOR, report)
            problems = tuple(report.problem for report in reports if report.problem)
            if problems != told:
                print(
                    f"looker: {'; '.join(problems) or 'everything that looks is heard'}", flush=True
                )
                told = problems


async def _run(runtime: Runtime, premises: Premises) -> None:
    with ZenohBus(connect=runtime.bus) as bus:
        looking = asyncio.create_task(Looker(premises, bus, RealClock()).run())
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, looking.cancel)
        print("looker ready", flush=True)
        with contextlib.suppress(asyncio.CancelledError):
            await looking


def main() -> None:
    """Look until told to leave."""
    runtime = runtime_from_environment()
    asyncio.run(_run(runtime, open_premises(runtime.site())))


if __name__ == "__main__":
    main()
