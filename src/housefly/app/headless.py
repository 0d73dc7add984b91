"""Flies one service over real wires without a person, and records it from outside."""

from __future__ import annotations

import threading
from collections.abc import Callable
from math import inf
from pathlib import Path

from housefly.app.end_signals import EndSignals
from housefly.app.launcher import Launcher, processes_of
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime
from housefly.app.truth_files import take_truth
from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.config.drone import DRONE_NAME
from housefly.config.site import Site
from housefly.errors import LinkError
from housefly.geometry import Vec2
from housefly.hub.store.lock import reserved_store
from housefly.lab.lockstep.service_monitor import ServiceMonitor
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.recorder import FlightRecorder

_START_TIMEOUT = 120.0
"""Longest time until pilot, twin and drone answer [s]."""
_STEADY_SOON, _STEADY_TIMEOUT = 3.0, 30.0
"""The wait for steady tracking is told after the first, and ends after the second [s]: then the
pilot says in words why it does not take off.
"""
STEADY_TIME, LONGEST_GAP = 1.0, 0.4
"""Tracking is steady after so long without a gap, and the longest gap [s]."""
_INTERRUPTED = "interrupted"


def fly_over_wires(
    runtime: Runtime,
    folder: Path,
    home: Vec2,
    order: Order,
    recorder: FlightRecorder,
    on_step: Callable[[PilotStep], None],
    say: Callable[[str], None],
    *,
    on_console: Callable[[], None] = lambda: None,
    give_up_after: float = 240.0,
    drone: str = DRONE_NAME,
) -> str:
    """Fly one service of a drone over real wires; return its outcome ("completed" or the reason).

    Where there is a console, ``on_console`` is called once it answers. Ctrl-C lands the
    drone first and gives the outcome "interrupted".

    Raises:
        LinkError: the drone or the tracking system did not answer in time.
    """
    site = runtime.site()
    flown = site.for_drone(drone)
    with (
        reserved_store(site),
        EndSignals(),
        Launcher(
            runtime, folder, processes_of(runtime, truth_file=recorder.truth_file)
        ) as launcher,
        ZenohBus(connect=runtime.bus) as bus,
    ):
        missing = Readiness(
            site,
            bus,
            web=runtime.has_console,
            video=site.has_picture,
            on_console=on_console,
        ).wait(_START_TIMEOUT, say, lambda: launcher.given_up != ())
        if missing:
            if launcher.given_up:
                raise LinkError(str(launcher.given_up[0]))
            raise LinkError(
                f"not ready after {_START_TIMEOUT:.0f} s: {missing}; the logs are in {folder}"
            )
        outcome = _serve(bus, flown, home, order, recorder, on_step, say, give_up_after)
    take_truth(recorder.truth_file, drone, recorder.truth_file)
    return outcome


class Steadiness:
    """Detects when tracking sees a body without gaps; a busy machine may delay frames at the start.

    Args:
        body: of the drone.
    """

    def __init__(self, body: str) -> None:
        self._body = body
        self._since = self._last = -inf

    def update(self, step: PilotStep) -> bool:
        """Return whether the body has been seen for ``STEADY_TIME`` up to this step."""
        if any(sighting.body == self._body for sighting in step.inputs.sightings):
            self._since = step.now if step.now - self._last > LONGEST_GAP else self._since
            self._last = step.now
        return step.now - self._last <= LONGEST_GAP and self._last - self._since >= STEADY_TIME


def _serve(
    bus: Bus,
    site: Site,
    home: Vec2,
    order: Order,
    recorder: FlightRecorder,
    on_step: Callable[[PilotStep], None],
    say: Callable[[str], None],
    give_up_after: float,
) -> str:
    topics, body = DroneTopics(site.drone.name), site.tracking.body
    clock, seen, done = RealClock(), threading.Event(), threading.Event()
    monitor, steadiness = ServiceMonitor(clock.now(), home, give_up_after), Steadiness(body)

    def on_pilot_step(step: PilotStep) -> None:
        nonlocal monitor
        recorder.add_step(step)
        on_step(step)
        if steadiness.update(step):
            seen.set()
        monitor = monitor.updated(step)
        if monitor.outcome:
            done.set()

    open_ = [
        bus.subscribe(topics.step, on_pilot_step),
        bus.subscribe(topics.video, recorder.add_video),
        bus.subscribe(topics.trajectory, recorder.add_trajectory),
        bus.subscribe(topics.link, recorder.add_link),
    ]
    try:
        # The recording must hold everything that the pilot knows, or a replay decides differently.
        if not seen.wait(_STEADY_SOON):
            say(f"waiting until tracking sees {body} without gaps")
            seen.wait(_STEADY_TIMEOUT - _STEADY_SOON)
        bus.publish(
            topics.order,
            Order(
                order.kind,
                order.place,
                order.goal,
                order.look_at,
                order.look_s,
                clock.now(),
                "headless",
            ),
        )
        try:
            while not done.wait(0.2):
                if clock.now() > monitor.started_at + give_up_after + 5.0:
                    return f"no word from the pilot for {give_up_after:.0f} s"
        except KeyboardInterrupt:
            bus.publish(topics.order, Order(OrderKind.LAND, issued_at=clock.now(), sender="Ctrl-C"))
            done.wait(30.0)
            return _INTERRUPTED
        return monitor.outcome
    finally:
        for subscription in open_:
            subscription.close()
