"""The tasks process: services, their queue, rules and clips; ``python -m housefly.app.tasks_main``.

Started by the launcher where ``tasks.enabled``. It reaches the drone only by orders, as people do.
When it dies, the drone hovers and the pilot brings it home by itself; after the restart nothing
flies without a fresh order.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import os
import queue
import signal
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

from housefly.app.live_task_room import LiveTaskRoom
from housefly.app.runtime import Runtime, runtime_from_environment
from housefly.app.task_outlet_bus import BusTaskOutlet
from housefly.app.task_parts import task_service
from housefly.bus.bus import Bus
from housefly.bus.topics import (
    FRAME_TOPIC,
    OBSTACLE_TOPIC,
    TASKS_QUERY,
    DroneTopics,
)
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.config.environment import ROOM_KEY_VARIABLE
from housefly.config.process_log import log_line
from housefly.config.repeated_work import repeat
from housefly.errors import HouseflyError, LinkError
from housefly.evidence.camera_pose import camera_pose_of
from housefly.hub.api.answers import News
from housefly.hub.api.pilot_queries import PreflightView
from housefly.hub.api.pilot_queries_json import from_json
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.hub.query_server import QueryServer
from housefly.hub.wall_clock import WallClock
from housefly.lab.rehearsal.rehearsal_ahead import tasks_ahead
from housefly.lab.rehearsal.rehearser import DroneRehearsers, Rehearser
from housefly.lab.rehearsal.room_now import RoomNow, room_now
from housefly.messages import RecordingNews, VideoFrame
from housefly.messages.words import UNSAID, Words
from housefly.pilot.behavior.preflight import preflight_refusal
from housefly.sites.loaded_site import LoadedSite, open_site
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.topics import TASK_NEWS_TOPIC
from housefly.tasks.client.tasks_client import tasks_socket
from housefly.tasks.engine.drone_state import TakeOffReadiness
from housefly.tasks.engine.task_drones import TaskDrone
from housefly.tasks.execution.live_obstacles import LiveObstacles
from housefly.tasks.rules.dry_run import event_of
from housefly.tasks.rules.mqtt_link import MqttLink
from housefly.tasks.rules.trigger import EventTrigger, Trigger

_log = logging.getLogger(__name__)

_TICK_PERIOD = 1.0 / 15.0
_RECORDING_PERIOD = 0.5
"""How often it is said that the camera is recorded [s]; the pilot believes it for 1.5 s."""
_BOARD_PERIOD = 0.2
"""The board is published at most so often [s]."""
_CLOCK_PERIOD = 1.0
"""How often rules look at the time, and the pilot is asked for its pre-flight list [s]."""
_ANSWERERS = 6
"""So many questions are answered at once: a rehearsal holds up no cancellation."""
_MAX_TRIGGERS = 1000


class TasksProcess:
    """The task service of one run on its wires.

    Args:
        loaded: the site.
        bus: of the run.
        recording: folder into which the whole run is recorded, or None.
    """

    def __init__(self, loaded: LoadedSite, bus: Bus, recording: Path | None = None) -> None:
        self._bus, self._wall = bus, WallClock()
        self._live = LiveObstacles(loaded.site, loaded.room)
        site, clock, wall = loaded.site, RealClock(), self._wall.now
        sites = {name: loaded.for_drone(name) for name in site.drone_names or (site.drone.name,)}
        rooms = {name: LiveTaskRoom(one, bus, self._live, clock.now) for name, one in sites.items()}
        self._rehearser = DroneRehearsers(
            {name: partial(self._rehearser_of, one, rooms[name]) for name, one in sites.items()}
        )
        self._topics = {name: DroneTopics(name) for name in sites}
        outlet = BusTaskOutlet(bus, site.mqtt.site)
        self.service, self._parts, problems = task_service(
            loaded,
            rooms,
            self._rehearser,
            outlet,
            clock.now,
            wall,
            str(recording or ""),
        )
        self._rehearser.start()
        for problem in problems:
            log_line(f"tasks: {problem}")
        self._triggers: queue.Queue[Trigger] = queue.Queue(_MAX_TRIGGERS)
        rules = self._parts.rules.engine.rules
        self._tasks_ahead = tasks_ahead(rules, self.service.desk.bound)
        if site.mqtt.broker:
            outlet.mqtt = MqttLink(site.mqtt, site.tasks, rules, self.service.answer, wall)
        self._mqtt = outlet.mqtt
        self._published: TaskBoard | None = None
        self._recording = dict.fromkeys(sites, RecordingNews(float("-inf"), records=False))

    def _rehearser_of(self, loaded: LoadedSite, room: LiveTaskRoom) -> Rehearser:
        """Start the rehearsals of one drone."""
        inbox, clock = self._parts.drones[loaded.site.drone.name].inbox, RealClock()

        def look() -> RoomNow:
            return room_now(self._live, inbox.newest, clock.now(), self._wall.now())

        return Rehearser(loaded, look, room.ask)

    async def run(self) -> None:
        """Run until cancelled; then what flies is sent home."""
        bus = self._bus
        subscriptions = (
            bus.subscribe(FRAME_TOPIC, self._live.heard_frame),
            *(
                bus.subscribe(self._topics[name].step, drone.inbox.add)
                for name, drone in self._parts.drones.items()
            ),
            *(
                bus.subscribe(self._topics[name].video, partial(_film, drone))
                for name, drone in self._parts.drones.items()
            ),
            bus.subscribe(OBSTACLE_TOPIC, self._live.heard_obstacle),
            bus.subscribe(ROOM_NEWS_TOPIC, self._on_news),
            bus.answer(TASKS_QUERY, self.service.answer, _ANSWERERS),
        )
        try:
            async with asyncio.TaskGroup() as tasks:
                tasks.create_task(repeat(_TICK_PERIOD, self._tick, "tasks"))
                tasks.create_task(repeat(_BOARD_PERIOD, self._publish_board, "tasks"))
                tasks.create_task(repeat(_CLOCK_PERIOD, self._look_around, "tasks"))
                tasks.create_task(repeat(0.0, self._take_trigger, "tasks"))
                if self._mqtt is not None:
                    tasks.create_task(self._mqtt.run(self._enqueue))
        finally:
            for subscription in subscriptions:
                subscription.close()
            self.service.close("the tasks process was told to end")
            self._rehearser.close()

    def _tick(self) -> None:
        self.service.tick()
        for drone in self._parts.drones.values():
            self._tell_recording(drone, RealClock().now())

    def _tell_recording(self, drone: TaskDrone, now: float) -> None:
        """Tell the pilot, whose drone shows it; again and again, for it stops when this dies."""
        before, news = self._recording[drone.name], RecordingNews(now, drone.clips.shows_light)
        is_due = news.records and now - before.at >= _RECORDING_PERIOD
        if is_due or news.records is not before.records:
            self._recording[drone.name] = news
            self._bus.publish(self._topics[drone.name].recording, news)

    def _on_news(self, news: News) -> None:
        for event in news.events:
            self._enqueue(EventTrigger(event_of(event)))

    def _enqueue(self, trigger: Trigger) -> None:
        with contextlib.suppress(queue.Full):  # in such a storm of events no rule helps anybody
            self._triggers.put_nowait(trigger)

    def _take_trigger(self) -> None:
        with contextlib.suppress(queue.Empty):
            self.service.desk.heard(self._triggers.get(timeout=0.2))

    def _look_around(self) -> None:
        self.service.desk.looked_at_clock()
        if not self._parts.has_drone:
            return
        self._rehearser.rehearse_ahead(self._tasks_ahead)
        for name, drone in self._parts.drones.items():
            drone.readiness = self._asked_readiness(self._topics[name])

    def _asked_readiness(self, topics: DroneTopics) -> TakeOffReadiness:
        try:
            view = from_json(PreflightView, self._bus.ask(topics.preflight, "", 0.5))
        except HouseflyError:
            return TakeOffReadiness()
        refused = None if view.ready else preflight_refusal(view.checks)
        words = UNSAID if view.ready else refused.reason if refused else Words("not looked at yet")
        return TakeOffReadiness(view.ready, words)

    def _publish_board(self) -> None:
        board = self.service.board()
        before, self._published = self._published, board
        if before is None or replace(board, at=before.at) != before:
            self._bus.publish(TASK_NEWS_TOPIC, board)


def _film(drone: TaskDrone, frame: VideoFrame) -> None:
    step = drone.inbox.newest
    drone.clips.add(frame, None if step is None else camera_pose_of(step))


async def _run(runtime: Runtime, loaded: LoadedSite) -> None:
    with ZenohBus(connect=runtime.bus) as bus:
        process = TasksProcess(loaded, bus, runtime.recording)
        server = _query_server(runtime, process.service.answer)
        running = asyncio.create_task(process.run())
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM):
            loop.add_signal_handler(number, running.cancel)
        log_line("tasks ready")
        try:
            with contextlib.suppress(asyncio.CancelledError):
                await running
        finally:
            if server is not None:
                server.close()


def _query_server(runtime: Runtime, answer: Callable[[str], str]) -> QueryServer | None:
    """Open the socket on which programs of this user ask; without it they ask over HTTP."""
    try:
        path = tasks_socket(runtime.room_socket)
        return QueryServer(answer, os.environ.get(ROOM_KEY_VARIABLE, ""), path)
    except LinkError as error:
        _log.warning("%s", error)
        return None


def main() -> int:
    """Run until SIGINT or SIGTERM; returns the exit status."""
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s %(message)s")
    try:
        runtime = runtime_from_environment()
        loaded = open_site(runtime.site())
        asyncio.run(_run(runtime, loaded))
    except HouseflyError as error:
        log_line(f"tasks: {error}", sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
