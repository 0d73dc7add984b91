"""Flies one task on a stepped clock: the very task, pilot and world, without wires."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from math import inf
from types import MappingProxyType
from typing import Any

from housefly.geometry import Vec3, distance
from housefly.hub.api.questions import Question
from housefly.lab.lockstep.lockstep_task_room import LockstepTaskRoom
from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.lab.lockstep.task_flight import (
    NO_SCRIPT,
    FlightSample,
    TaskFlight,
    TaskScript,
    TimedAction,
)
from housefly.messages import (
    DroneStatus,
    Obstacle,
    Order,
    OrderKind,
    Phase,
    PilotStep,
)
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.words import literal
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.api.values import TaskStepState
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.execution.step_inbox import StepInbox, task_sender
from housefly.tasks.execution.task_run import TaskRun
from housefly.tasks.execution.values import AskPerson, GiveOrder, PersonReply, TaskAction
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.twin.movable import Movable
from housefly.twin.people import Scene
from housefly.twin.people.script import PersonScript
from housefly.twin.world import SimulatedWorld

UNIX_BEGIN = 1.7e9
"""Unix time at the world's time 0 [s]."""
_CANCELLED = literal("somebody cancelled it")
_TICK_PERIOD = 0.1
"""Time between two ticks of the task [s]."""
_SAMPLE_PERIOD = 0.5
"""The truth is looked at this often [s]."""
_TELL_PERIOD = 0.2
"""Obstacles told from outside are told again this often [s]."""
_HOVERING_TIME = 2.0
"""World time at which a flight that begins in the air begins, at least [s]."""
_AFTERWARDS = 200.0
"""A drone that a task leaves in the air is followed so long [s]: the pilot brings it home."""
_SKIPPED_SHARE, _SKIPPED_AT_ONCE = 0.25, 20.0
"""Of a hovering that is not flown this share of its time passes again in one tick, up to this [s].
"""


def fly_task_lockstep(
    loaded: LoadedSite,
    task: BoundTask,
    script: TaskScript = NO_SCRIPT,
    *,
    scene: Scene | None = None,
    people: tuple[PersonScript, ...] = (),
    ids: Mapping[str, str] = MappingProxyType({}),
    movables: tuple[Movable, ...] = (),
    obstacles: tuple[Obstacle, ...] = (),
    drone: tuple[Vec3, float] | None = None,
    airborne: bool = False,
    ask: Callable[[Question], Any] | None = None,
    viewing: ViewingRoom | None = None,
    begin_at: float = SETTLING_TIME,
    give_up_after: float = 900.0,
    hover_max: float = inf,
    pictures: bool = True,
    watch_after: float = 0.0,
    unix: float = UNIX_BEGIN,
    on_world: Callable[[SimulatedWorld], None] = lambda world: None,
    on_step: Callable[[PilotStep], None] = lambda step: None,
) -> TaskFlight:
    """Fly a task in lock step and return what happened, in truth.

    Args:
        loaded: site, room and map.
        task: what to fly.
        script: what people do meanwhile.
        scene: who moves how; None plays the site's own.
        people: people without a scene, whom ``on_world`` may put.
        ids: what the room calls those of them whom it calls otherwise.
        movables: things that no map shows, which ``on_world`` may put.
        obstacles: told to pilot and task, as sensors of the room would.
        drone: where it stands at first, world [m], and its heading [rad]; None on its pad.
        airborne: it hovers there instead.
        ask: of the room's memory; None remembers nothing.
        viewing: the same room, when it was prepared before.
        begin_at: world time at which the task begins [s].
        give_up_after: longest time of task and landing [s].
        hover_max: hovering beyond this time is not flown, its time is added [s].
        pictures: False leaves out what the camera shows, which takes a tenth of the time.
        watch_after: after the end it is watched for so long, whether anything moves [s].
        unix: Unix time at the world's time 0 [s].
        on_world: called before every step of the pilot; may place people and movables.
        on_step: called with every step of the pilot.

    Raises:
        ConfigError: a fault of the site that cannot be made in lock step.
    """
    loop = Simulation(loaded, movables, people, scene, origin_known=drone is not None)
    hovering = drone if airborne else None
    if drone is not None:
        loop.world.put_drone(*drone)
    if airborne:
        begin_at = max(begin_at, _HOVERING_TIME)
    names = tuple(ids.get(name, name) for name in loop.people)
    room = LockstepTaskRoom(loaded, loop.world, names, ask, viewing)
    room.obstacles = obstacles
    flown = _FlownTask(loop, task, script, room, hover_max)
    flown.begins_at, flown.shows_pictures, flown.unix = begin_at, pictures, unix
    told_at, orders = -inf, tuple[Order, ...]()
    while not flown.is_done(begin_at + give_up_after, watch_after):
        if hovering is not None:
            hovering = _held(loop, hovering)
        loop.advance()
        on_world(loop.world)
        now = loop.now
        told: tuple[Obstacle, ...] = ()
        if now - told_at >= _TELL_PERIOD and obstacles:
            told_at, told = now, tuple(replace(one, seen_at=now) for one in obstacles)
            room.obstacles = told
        step = loop.step(loop.inputs(*orders, obstacles=told))
        on_step(step)
        orders = flown.heard(step)
    return flown.result(distance(loop.world.truth().pose.position[:2], loaded.room.home))


def _held(loop: Simulation, hovering: tuple[Vec3, float]) -> tuple[Vec3, float] | None:
    """Keep the drone in the air until its pilot knows where it is; None once it hovers."""
    if loop.now < SETTLING_TIME:
        loop.world.put_drone(*hovering)
        return hovering
    loop.world.hover_drone(*hovering)
    return None


class _FlownTask:
    """One task that is flown, with its script and what became of it."""

    def __init__(
        self,
        loop: Simulation,
        task: BoundTask,
        script: TaskScript,
        room: LockstepTaskRoom,
        hover_max: float,
    ) -> None:
        self.begins_at, self.shows_pictures, self.unix = SETTLING_TIME, True, UNIX_BEGIN
        self._loop, self._task, self._script, self._room = loop, task, script, room
        self._hover_max = hover_max
        self._run: TaskRun | None = None
        self._inbox = StepInbox()
        self._replies: list[tuple[float, PersonReply]] = []
        self._interrupted: set[str] = set()
        self._actions: list[TimedAction] = []
        self._began: dict[int, tuple[float, str]] = {}
        self._samples: list[FlightSample] = []
        self._begin = self._next_tick = self._next_sample = 0.0
        self._hovers_since = self._ended = inf
        self._skipped = 0.0
        self._charge: float | None = None
        self._airborne_at: float | None = None
        self._landed_at: float | None = None
        self._rest: tuple[float, Vec3] | None = None
        self._moved = 0.0

    @property
    def _at(self) -> float:
        """Time since the task began, skipped hovering included [s]."""
        return self._loop.now - self._begin + self._skipped

    def is_done(self, give_up_at: float, watch_after: float) -> bool:
        """Return whether the task is over and the drone stands for a time, or it is given up."""
        if self._run is None:
            return False
        followed = self._loop.now - self._ended > _AFTERWARDS
        if self._loop.now > give_up_at or followed:
            return True
        return self._run.is_over and self._has_rested(watch_after)

    def _has_rested(self, time: float) -> bool:
        """Return whether the drone stood for a time since the end [s]; note how far it moved."""
        place = self._loop.world.truth().pose.position
        if self._rest is None:
            self._rest = (self._loop.now, place) if self._stands() else None
        if self._rest is None:
            return False
        since, first = self._rest
        self._moved = max(self._moved, distance(first, place))
        return self._loop.now - since >= time

    def heard(self, step: PilotStep) -> tuple[Order, ...]:
        """Take a step of the pilot; return the orders that are given now."""
        if self._loop.now < self.begins_at:
            return ()
        if self._run is None:
            self._begin = self._next_tick = self._next_sample = self._loop.now
            self._run = TaskRun(self._task, self._room)
            self._charge = self._loop.world.onboard().battery
        self._inbox.add(step)
        self._note_flight(step)
        orders = self._people_order()
        if self._loop.now < self._next_tick:
            return orders
        self._next_tick += _TICK_PERIOD
        self._room.look()
        self._interrupt(self._run)
        return (*orders, *self._tick(self._run))

    def result(self, off_pad: float) -> TaskFlight:
        """Return what happened; the drone is so far from its pad [m]."""
        run, world = self._run, self._loop.world
        assert run is not None
        left = world.onboard().battery
        return TaskFlight(
            stage=run.stage,
            code=run.code,
            words=run.words,
            ended_at=min(self._ended, self._loop.now) - self._begin + self._skipped,
            actions=tuple(self._actions),
            began=tuple(sorted(self._began.values())),
            steps=run.steps,
            samples=tuple(self._samples),
            contacts=self._loop.contacts(),
            off_pad=off_pad,
            stands=self._stands(),
            airborne_at=self._airborne_at,
            landed_at=self._landed_at,
            skipped=self._skipped,
            charge=self._charge_taken(left),
            moved_after=self._moved,
        )

    def _charge_taken(self, left: float) -> float:
        """Return the charge taken; skipped hovering takes it as the rest of the flight did."""
        taken = max(0.0, (self._charge or left) - left)
        if self._airborne_at is None or self._landed_at is None:
            return taken
        flown = self._landed_at - self._airborne_at - self._skipped
        return taken * (1.0 + self._skipped / flown) if flown > 0.0 else taken

    def _tick(self, run: TaskRun) -> tuple[Order, ...]:
        now = self._loop.now + self._skipped
        due = [reply for at, reply in self._replies if at <= self._at]
        self._replies = [one for one in self._replies if one[0] > self._at]
        if run.is_over:
            return ()
        actions = run.step(self._inbox.drain(now, self.unix + now, tuple(due)))
        for number, note in enumerate(run.steps):
            if note.state is not TaskStepState.WAITING:
                self._began.setdefault(number, (self._at, note.name))
        if run.is_over:
            self._ended = self._loop.now
        orders = [order for action in actions for order in self._done(action)]
        self._skip(bool(due) or any(_does_something(action) for action in actions))
        return tuple(orders)

    def _done(self, action: TaskAction) -> tuple[Order, ...]:
        """Do what the task wants done; return the order that it gives."""
        world = self._loop.world
        place = world.truth().pose.position[:2]
        self._actions.append(TimedAction(self._at, action, place, self._picture()))
        if isinstance(action, AskPerson):
            self._answer(action)
        if isinstance(action, GiveOrder):
            sender = task_sender(1, self._task.service)
            return (replace(action.order, issued_at=self._loop.now, sender=sender),)
        return ()

    def _answer(self, asked: AskPerson) -> None:
        script = self._script
        choice = script.replies.get(asked.id, "" if script.silent else asked.choices[0])
        if choice:
            reply = PersonReply(asked.id, choice, "somebody")
            last = (asked.timeout or 0.0) - _TICK_PERIOD
            time = last if script.late else script.reply_time
            self._replies.append((self._at + time, reply))

    def _people_order(self) -> tuple[Order, ...]:
        """Return what people order the pilot now."""
        period = self._loop.period
        return tuple(
            replace(order, issued_at=self._loop.now, sender="somebody")
            for at, order in self._script.orders
            if at <= self._at < at + period
        )

    def _interrupt(self, run: TaskRun) -> None:
        """Cancel, pause and continue as the script says."""
        script = self._script
        for word, at, act in (
            ("pause", script.pause_at, run.pause),
            ("resume", script.resume_at, run.resume),
            ("cancel", script.cancel_at, lambda: run.cancel(_CANCELLED)),
            ("cancel again", script.cancel_again_at, lambda: run.cancel(_CANCELLED)),
        ):
            if self._at >= at and word not in self._interrupted:
                self._interrupted.add(word)
                act()

    def _skip(self, busy: bool) -> None:
        """Let hovering that lasts pass without flying it."""
        step = self._inbox.newest
        hovers = step is not None and step.outputs.phase is Phase.HOLDING and not busy
        if not hovers:
            self._hovers_since = inf
            return
        self._hovers_since = min(self._hovers_since, self._at)
        hovered = self._at - self._hovers_since
        if hovered > self._hover_max:
            # What is given up before an answer would come is given up first here, too.
            left = min((at for at, _ in self._replies), default=inf) - self._at - 2 * _TICK_PERIOD
            skipped = min(_SKIPPED_SHARE * hovered, _SKIPPED_AT_ONCE, left)
            self._skipped += max(0.0, skipped)

    def _note_flight(self, step: PilotStep) -> None:
        """Note the truth of the flight."""
        if self._inbox.status in AIRBORNE_STATUSES:
            self._airborne_at = self._at if self._airborne_at is None else self._airborne_at
            self._landed_at = self._at
        if self._loop.now < self._next_sample or self._airborne_at is None:
            return
        self._next_sample = self._loop.now + _SAMPLE_PERIOD
        world = self._loop.world
        x, y, z = world.truth().pose.position
        clear = world.clearance()
        self._samples.append(
            FlightSample(self._at, (x, y), z, clear.solid, clear.person, self._picture())
        )

    def _picture(self) -> dict[str, float]:
        return self._loop.world.in_picture() if self.shows_pictures else {}

    def _stands(self) -> bool:
        step = self._inbox.newest
        idle = step is not None and step.outputs.phase is Phase.IDLE
        return idle and self._inbox.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY, None)


def _does_something(action: TaskAction) -> bool:
    """Return whether an action is more than hovering on."""
    return not (isinstance(action, GiveOrder) and action.order.kind is OrderKind.HOVER)
