"""The pilot's shell: wires on both sides of the pure step, and a clock.

    tracker ──sightings──►            ──command──► drone
                          pilot.step
    orders, STOP ────────►            ──step─────► bus (whoever listens)
    obstacles ───────────►

The only process that must be on time. Nothing here waits for a listener. When the step fails, the
drone is landed without it, and the process ends: the next one begins anew.
"""

from __future__ import annotations

import asyncio
import contextlib
from dataclasses import replace
from math import isfinite
from typing import TYPE_CHECKING

from housefly.app.disk_space import DISK_LOOK_PERIOD, disks_of
from housefly.app.loop_health import Gap, Lateness
from housefly.app.machine_load import machine_load
from housefly.app.obstacle_inbox import ObstacleInbox
from housefly.app.order_inbox import OrderInbox
from housefly.app.origin_memory import OriginMemory
from housefly.app.people_note import people_note
from housefly.app.people_sight import PeopleSight
from housefly.app.pilot_publisher import PilotPublisher
from housefly.app.pilot_queries import PilotQueryServer
from housefly.app.recording_watch import REFRESH_PERIOD, RecordingWatch
from housefly.app.refused_orders import answers_to
from housefly.app.take_off_pause import TakeOffPause
from housefly.bus.bus import Bus
from housefly.bus.rate import Frequency, Rate
from housefly.bus.topics import OBSTACLE_TOPIC, SIGHT_TOPIC, DroneTopics
from housefly.clock import RealClock
from housefly.config.frame_check import frames_known
from housefly.config.process_log import log_traceback
from housefly.drones.contract import Drone
from housefly.drones.pose_rate import PoseRate
from housefly.errors import LinkError
from housefly.messages import (
    Action,
    Command,
    Event,
    Inputs,
    LinkStatus,
    Order,
    OrderKind,
    Outputs,
    PilotStep,
    SafetyMode,
    Severity,
    Sighting,
    VideoFrame,
)
from housefly.messages.event_code import EventCode
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.words import UNSAID, Words, literal
from housefly.pilot.assembly import make_pilot
from housefly.pilot.contracts import Maneuver
from housefly.pilot.estimation.estimation_report import NOTHING_ESTIMATED, EstimationReport
from housefly.room.grid import extent_of
from housefly.sites.loaded_site import LoadedSite
from housefly.tracking.contracts import Tracker

if TYPE_CHECKING:
    from collections.abc import Callable

_LINK_PERIOD = 0.5
"""How often the health of the wires is published [s]."""
_LANDING_TIMEOUT = 25.0
"""How long an ordered shutdown waits for the drone to land [s]."""
_LOOP_PATIENCE = 1.0
"""How long a question waits for the loop [s]."""


class StepFailure(Exception):
    """The step of the pilot raised an exception in flight."""


class PilotShell:
    """Runs one pilot on real wires; everything happens on one asyncio loop."""

    def __init__(
        self,
        loaded: LoadedSite,
        bus: Bus,
        tracker: Tracker,
        drone: Drone,
        maneuver: Maneuver | None = None,
        origin: OriginMemory | None = None,
    ) -> None:
        self._topics = DroneTopics(loaded.site.drone.name)
        self._queries = PilotQueryServer(loaded, bus)
        self.pilot = make_pilot(
            loaded.site, loaded.room, loaded.grid, maneuver, frames=frames_known(loaded.site)
        )
        self._origin = origin or OriginMemory(loaded.site)
        self._disks = disks_of(loaded.site)
        self._load = machine_load()
        self._stand_down = TakeOffPause()
        self._outputs: Outputs | None = None
        self._body = loaded.site.tracking.body
        self._people_note = people_note(loaded.site)
        self._rate_hz = loaded.site.control.rate_hz
        self._bus, self._tracker, self._drone = bus, tracker, drone
        self._clock = RealClock()
        self._recording = RecordingWatch(drone, self._clock.now)
        self._sightings: list[Sighting] = []
        self._orders = OrderInbox(self._clock)
        self._obstacles = ObstacleInbox(extent_of(loaded.grid), self._clock)
        self._sight = PeopleSight(loaded.site, self._clock)
        self._sequence = 0
        self._tracking, self._video = Frequency(), Frequency()
        self._lateness = Lateness(int(10 * self._rate_hz))
        self._rate = Rate(self._rate_hz, self._clock)
        self._leaving = False
        self._gap = Gap(self._rate.period)
        self._drone_problem = ""
        self._failure = UNSAID
        self._is_cut = False
        self._publisher = PilotPublisher(bus, self._topics)
        self._pose_rate: PoseRate | None = None

    async def run(self) -> None:
        """Fly until ``leave`` is called and the drone is down.

        Raises:
            StepFailure: the step failed; the drone is down, or did not land in time.
        """
        loop = asyncio.get_running_loop()
        orders = self._bus.subscribe(self._topics.order, self._orders.add)
        obstacles = self._bus.subscribe(OBSTACLE_TOPIC, self._obstacles.add)
        sight = self._bus.subscribe(
            SIGHT_TOPIC, lambda news: _soon(loop, lambda: self._sight.heard(news))
        )
        recording = self._bus.subscribe(
            self._topics.recording, lambda news: _soon(loop, lambda: self._recording.heard(news))
        )
        standing = self._bus.answer(
            self._topics.stand_down, lambda _: self._asked_to_stand_down(loop)
        )
        self._drone.on_video(self._on_video)
        tasks = [
            asyncio.create_task(self._tracker.run(self._on_sightings)),
            asyncio.create_task(self._connect_drone()),
        ]
        tasks.append(asyncio.create_task(self._report_links()))
        tasks.append(asyncio.create_task(self._watch_disks()))
        tasks.append(asyncio.create_task(self._show_recording()))
        try:
            await self._fly()
        finally:
            orders.close()
            obstacles.close()
            sight.close()
            recording.close()
            standing.close()
            self._queries.close()
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            await self._drone.close()

    def stop(self) -> None:
        """Stop at once, past every queue: the drone hovers before anything else happens."""
        if self._airborne():
            self._drone.send(Command(Action.HOVER))
        self._orders.add(Order(OrderKind.STOP, issued_at=self._clock.now(), sender="STOP"))
        self._step()

    def leave(self) -> None:
        """Land if necessary, then end; a further call is the same wish."""
        if self._leaving:
            return
        self._leaving = True
        self._orders.add(Order(OrderKind.LAND, issued_at=self._clock.now(), sender="shutdown"))

    def _asked_to_stand_down(self, loop: asyncio.AbstractEventLoop) -> str:
        """Give the pilot's word from the bus's thread, between two steps of the loop."""
        try:
            word = asyncio.run_coroutine_threadsafe(self._word(), loop)
            return word.result(_LOOP_PATIENCE)
        except (TimeoutError, RuntimeError):
            return "the pilot is busy"

    async def _word(self) -> str:
        if self._leaving or self._failure:
            return "the pilot is ending"
        now, waiting = self._clock.now(), self._orders.waiting
        return self._stand_down.begin(now, self._drone.telemetry, self._outputs, waiting)

    async def _fly(self) -> None:
        give_up_at = None
        while True:
            self._lateness.add(await self._rate.sleep())
            self._step()
            if self._leaving or self._failure:
                now = self._clock.now()
                give_up_at = give_up_at or now + _LANDING_TIMEOUT
                if not self._airborne() or now > give_up_at:
                    break
        if self._failure:
            raise StepFailure(self._failure)

    def _step(self) -> None:
        now = self._clock.now()
        orders, events, answers = self._orders.drain(), self._orders.told(), self._orders.answers()
        if not self._airborne():
            orders, full = self._disks.allowed(orders)
            orders, standing = self._stand_down.allowed(orders, now)
            events += tuple(one.event(now) for one in full + standing)
            answers += answers_to(full + standing)
        inputs = Inputs(
            tuple(self._sightings),
            self._drone.telemetry,
            orders,
            self._obstacles.drain(),
            late=self._gap.lateness(now),
            origin_known=self._origin.known,
            people_seen_at=self._sight.seen_at,
        )
        self._sightings.clear()
        outputs = self._landing(now, inputs) if self._failure else self._decide(now, inputs)
        self._drone.send(outputs.command, None if self._failure else self.pilot.known_motion)
        self._tell_pose()
        self._outputs = outputs
        if events or answers:
            told, answered = outputs.events + events, outputs.answers + answers
            outputs = replace(outputs, events=told, answers=answered)
        step = PilotStep(self._sequence, now, inputs, outputs)
        self._sequence += 1
        self._queries.update(step)
        self._publisher.publish_step(step)

    def _tell_pose(self) -> None:
        """Tell a drone that wants to know where it is, as often as it wants."""
        able = self._drone.capabilities
        if able is None or able.external_pose_rate is None or self._failure:
            return
        if self._pose_rate is None:
            self._pose_rate = PoseRate(able.external_pose_rate)
        seen = self._pose_rate.due(self.pilot.external_pose)
        if seen is not None:
            self._drone.send_pose(seen)

    def _decide(self, now: float, inputs: Inputs) -> Outputs:
        try:
            return self.pilot.step(now, inputs)
        except Exception as error:
            self._failure = Words(
                "the pilot failed ({name}): landing", name=f"{type(error).__name__}: {error}"
            )
            event = Event(now, Severity.FAULT, EventCode.STEP_FAILED, self._failure)
            outputs = replace(self._landing(now, inputs), events=(event,))
            self._drone.send(outputs.command)  # before a disk that takes its time
            log_traceback()
            return outputs

    def _landing(self, now: float, inputs: Inputs) -> Outputs:
        """Land without the step, which may fail again; cutting the motors still passes."""
        self._is_cut |= any(order.kind is OrderKind.CUT for order in inputs.orders)
        action, mode = (
            (Action.CUT, SafetyMode.CUT) if self._is_cut else (Action.LAND, SafetyMode.LAND)
        )
        return Outputs(Command(action), safety=mode, reason=self._failure)

    def _airborne(self) -> bool:
        telemetry = self._drone.telemetry
        return telemetry is not None and telemetry.status in AIRBORNE_STATUSES

    def _on_sightings(self, sightings: tuple[Sighting, ...]) -> None:
        self._sightings.extend(sightings)
        for sighting in sightings:
            if sighting.body == self._body:
                self._tracking.add(sighting.received_at)

    def _on_video(self, frame: VideoFrame) -> None:
        self._video.add(frame.received_at)
        self._publisher.publish(self._topics.video, frame)

    async def _connect_drone(self) -> None:
        while True:
            try:
                await self._drone.connect()
            except LinkError as error:
                self._drone_problem = str(error)
                await asyncio.sleep(1.0)
            else:
                self._drone_problem = ""
                return

    async def _report_links(self) -> None:
        while True:
            await asyncio.sleep(_LINK_PERIOD)
            self._report()

    def _report(self) -> None:
        self._load = machine_load(self._lateness.percentiles()[1])
        self._publisher.publish(self._topics.link, self._link_status())
        self._look_at_preflight()

    async def _show_recording(self) -> None:
        """Keep the drone's light as it should be, beside the steps and never within one."""
        while True:
            self._recording.refresh()
            await asyncio.sleep(REFRESH_PERIOD)

    async def _watch_disks(self) -> None:
        """Look on a thread: a disk may take its time to answer."""
        while True:
            try:
                await asyncio.to_thread(self._disks.look)
            except Exception:
                log_traceback()
            await asyncio.sleep(DISK_LOOK_PERIOD)

    def _look_at_preflight(self) -> None:
        """Bring the pre-flight list up to date; a failure there stops no other report."""
        try:
            own = (*self._disks.checks(), self._load.check())
            self._queries.update_preflight((*self.pilot.preflight(), *own))
            if self.pilot.origin_revoked:
                self._origin.revoke()
            elif self.pilot.origin_confirmed:
                self._origin.note()
        except Exception:
            self._queries.update_preflight(())
            log_traceback()

    def _estimation(self) -> EstimationReport:
        """Return what the estimator found out; a failure there stops no other report."""
        try:
            return self.pilot.estimation
        except Exception:
            log_traceback()
            return NOTHING_ESTIMATED

    def _link_status(self) -> LinkStatus:
        now = self._clock.now()
        median, p99, worst = self._lateness.percentiles()
        found = self._estimation()
        return LinkStatus(
            at=now,
            tracking_connected=self._tracker.connected,
            drone_connected=self._drone.connected,
            video_connected=self._drone.video_connected,
            tracking_rate_hz=self._tracking.rate_hz(now),
            telemetry_rate_hz=self._drone.telemetry_rate_hz,
            video_rate_hz=self._video.rate_hz(now),
            loop_p50_s=median,
            loop_p99_s=p99,
            loop_max_s=worst,
            missed_ticks=self._rate.missed,
            notes=tuple(
                literal(note)
                for note in (
                    self._failure,
                    self._tracker.problem,
                    self._drone_problem or self._drone.problem,
                    self._obstacles.problem,
                    self._publisher.problem,
                    self._recording.note,
                    self._people_note if self._airborne() else "",
                    self._load.note,
                )
                if note
            ),
            tracking_latency_s=_known(found.tracking_latency),
            command_delay_s=_known(found.command_delay),
            command_delay_std_s=_known(found.command_delay_std),
            nis=_known(found.nis),
            height_nis=_known(found.height_nis),
            push=_known(found.push_size),
            load=_known(found.load),
            height_std=_known(found.height_std),
        )


def _known(value: float) -> float:
    return value if isfinite(value) else 0.0


def _soon(loop: asyncio.AbstractEventLoop, action: Callable[[], None]) -> None:
    with contextlib.suppress(RuntimeError):
        loop.call_soon_threadsafe(action)
