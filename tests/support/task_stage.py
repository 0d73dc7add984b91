"""The whole task service beside a memory and, where wanted, a pilot in lock step; no wires."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import replace
from pathlib import Path
from typing import Any

from quick_flights import QUICK
from remembered_room import RememberedRoom

from housefly.app.live_task_room import LiveTaskRoom
from housefly.app.task_outlet_bus import BusTaskOutlet
from housefly.app.task_parts import task_service
from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY, ROOM_EVENT_TOPIC, DroneTopics
from housefly.clock import SteppedClock
from housefly.hub.api.told_events import checked_event
from housefly.hub.hub import Hub
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Inputs,
    Order,
    Outputs,
    Phase,
    PilotStep,
    RoomEvent,
    Telemetry,
    TrackedFrame,
)
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.tasks.api.json import task_answer_from_json, task_question_to_json
from housefly.tasks.api.questions import TaskQuestion
from housefly.tasks.api.values import ReasonCode, RehearsalReport, TaskStatus
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.engine.drone_state import TakeOffReadiness
from housefly.tasks.execution.live_obstacles import LiveObstacles

GOOD = RehearsalReport(True, ReasonCode.OK, "it can be flown", duration=40.0, took=0.1)
_TICK = 1.0 / 15.0


class Rehearsals:
    """Says of every task what it is told to say; counts who asked."""

    def __init__(self) -> None:
        self.report: RehearsalReport | Exception = GOOD
        self.asked: list[BoundTask] = []
        self.drones: list[str] = []
        self.is_slow = False
        self.waiting: list[Future[RehearsalReport]] = []

    def rehearse(self, task: BoundTask, drone: str) -> Future[RehearsalReport]:
        self.asked.append(task)
        self.drones.append(drone)
        found: Future[RehearsalReport] = Future()
        if isinstance(self.report, Exception):
            found.set_exception(self.report)
        elif not self.is_slow:
            found.set_result(self.report)
        else:
            self.waiting.append(found)
        return found

    def finish(self) -> None:
        """End what goes on slowly."""
        for found in self.waiting:
            if not found.done() and isinstance(self.report, RehearsalReport):
                found.set_result(self.report)


class TaskStage:
    """A site's tasks on a stepped clock. ``tick`` goes on without a pilot's step, ``fly`` with."""

    def __init__(
        self,
        folder: Path,
        begin: float = 10.0,
        memory: RememberedRoom | None = None,
        **changes: Any,
    ) -> None:
        changes = QUICK | {"drone__has_video": False} | changes
        self.loaded: LoadedSite = load_site("bsen", hub__store=str(folder / "room.db"), **changes)
        self.clock = SteppedClock(begin)
        self._unix = (memory.now if memory else time.time()) - begin
        self.bus = LocalBus()
        has_hub = self.loaded.site.hub.enabled and memory is None
        self.hub = Hub(self.loaded.site, folder, self.bus.join()) if has_hub else None
        if memory is not None:
            self.bus.answer(HUB_QUERY, memory.answer)
        self.orders: list[Order] = []
        self.events: list[RoomEvent] = []
        names = self.loaded.site.drone_names or ("drone",)
        self.orders_of: dict[str, list[Order]] = {name: [] for name in names}
        for name in names:
            self.bus.subscribe(DroneTopics(name).order, self.orders.append)
            self.bus.subscribe(DroneTopics(name).order, self.orders_of[name].append)
        self.bus.subscribe(ROOM_EVENT_TOPIC, self._told)
        self.rehearsals = Rehearsals()
        self.live = LiveObstacles(self.loaded.site, self.loaded.room)
        outlet = BusTaskOutlet(self.bus.join(), "bsen")
        rooms = {
            name: LiveTaskRoom(self.loaded.for_drone(name), self.bus, self.live, self.clock.now)
            for name in names
        }
        self.service, self.parts, self.problems = task_service(
            self.loaded, rooms, self.rehearsals, outlet, self.clock.now, self.wall
        )
        for drone in self.parts.drones.values():
            drone.readiness = TakeOffReadiness(True, "")
        self.loop: Simulation | None = None
        self._sequence, self._taken = 0, 0

    def wall(self) -> float:
        return self._unix + self.clock.now()

    def ask(self, question: TaskQuestion) -> Any:
        text = self.service.answer(task_question_to_json(question))
        return task_answer_from_json(question, text)

    def task(self, number: int = 1) -> TaskStatus:
        with self.service.desk.lock:
            return self.parts.engine.status(number)

    def new_orders(self) -> list[Order]:
        """Return the orders that were given since the last call."""
        new, self._taken = self.orders[self._taken :], len(self.orders)
        return new

    def told(self, *kinds: str) -> list[RoomEvent]:
        return [event for event in self.events if not kinds or event.kind in kinds]

    def stand(
        self,
        seconds: float = 1.0,
        status: DroneStatus = DroneStatus.LANDED,
        phase: Phase = Phase.IDLE,
        orders: tuple[Order, ...] = (),
    ) -> None:
        """Let time pass beside a pilot that only says how the drone is; it hears orders once."""
        for _ in range(max(1, round(seconds / _TICK))):
            self.heard(self._step(status, phase, orders))
            orders = ()
            self.tick()

    def tick(self) -> None:
        self.clock.advance(_TICK)
        self.service.tick()

    def heard(self, step: PilotStep) -> None:
        for drone in self.parts.drones.values():
            drone.inbox.add(step)
        self.live.heard_frame(TrackedFrame(step.inputs.sightings))

    def fly(self, until: Callable[[], bool], limit: float = 150.0) -> bool:
        """Fly the true pilot in the twin until something holds; return whether it does."""
        if self.loop is None:
            self.loop = Simulation(self.loaded)
            self._shift = self.clock.now()
        loop, end = self.loop, self.loop.now + limit
        next_tick, given = loop.now, list[Order]()
        while loop.now < end:
            loop.advance()
            step = loop.step(loop.inputs(*given))
            given = []
            self.clock.advance(self._shift + loop.now - self.clock.now())
            self.heard(replace(step, now=self._shift + step.now))
            if loop.now >= next_tick:
                next_tick += _TICK
                self.service.tick()
                # The pilot's own clock began at another time.
                given = [
                    replace(order, issued_at=order.issued_at - self._shift)
                    for order in self.new_orders()
                ]
                if until():
                    return True
        return False

    def stands_on_pad(self) -> bool:
        """Return whether the drone truly stands where it took off."""
        assert self.loop is not None
        x, y, z = self.loop.world.truth().pose.position
        home = self.loaded.room.home
        return abs(x - home[0]) < 0.3 and abs(y - home[1]) < 0.3 and z < 0.2

    def close(self) -> None:
        for drone in self.parts.drones.values():
            drone.clips.close()
        self.parts.store.close()
        if self.hub is not None:
            self.hub.close()

    def _step(
        self, status: DroneStatus, phase: Phase = Phase.IDLE, orders: tuple[Order, ...] = ()
    ) -> PilotStep:
        self._sequence += 1
        now = self.clock.now()
        inputs = Inputs(telemetry=Telemetry(now, status, 0.9), orders=orders)
        return PilotStep(self._sequence, now, inputs, Outputs(Command(Action.LAND), phase=phase))

    def _told(self, event: RoomEvent) -> None:
        self.events.append(checked_event(event, self.wall()))
