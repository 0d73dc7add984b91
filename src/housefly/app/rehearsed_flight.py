"""Rehearses a task in lock step on the room as it is now: may it fly, and what to expect.

First what costs nothing: does everything that the task looks at exist, is there a way, does the
charge suffice for the way alone. Then the whole flight in the simulated room, with live obstacles
as solid bodies. Whoever is asked gives the likeliest answer; hovering is shortened, its time and
charge are added.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from math import inf, isfinite
from typing import Any

from housefly.app.loaded_site import LoadedSite
from housefly.app.room_now import RoomNow
from housefly.app.task_flight import TaskFlight, TaskScript
from housefly.app.task_lockstep import fly_task_lockstep
from housefly.config.site import changed
from housefly.errors import HouseflyError, TaskError
from housefly.geometry import Vec2, distance
from housefly.hub.api.questions import Question
from housefly.messages import Obstacle, ObstacleKind
from housefly.pilot.behavior.way_home import RETURN_RESERVE
from housefly.pilot.planning.furniture import FURNITURE_SOURCE
from housefly.room.tracked import body_pose_of
from housefly.tasks.api.values import ReasonCode, RehearsalReport, TaskStage
from housefly.tasks.document.steps import StepKind, TaskStep
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.document.templates import names_in, plain_text
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.execution.values import StartClip, TakeSnapshot
from housefly.tasks.vantage.named_subject import viewpoint_of
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript
from housefly.twin.world import SimulatedWorld

_RATE_HZ, _TRACKING_RATE_HZ = 50.0, 25.0
"""Steps of the rehearsed pilot and its tracking: half and a quarter of the usual, for speed; way,
time and clearance stay the same within a percent (``benchmarks/rehearsal.py``).
"""
_HOVER_MAX = 1.0
"""Hovering longer than this is not flown [s]."""
_REPLY_TIME = 0.5
"""Who is asked answers after this [s]."""
_LONGEST = 600.0
"""A task that is not done after so long is not rehearsed to its end [s]."""
_UP_AND_DOWN = 8.0
"""Taking off and landing take about so long [s]."""
_PERSON_HEIGHT = 1.7
_STANDING_HEIGHT = 0.05
"""Of the drone's middle on the floor [m]."""

AskRoom = Callable[[Question], Any]


class RehearsalTimeout(Exception):
    """The rehearsal itself takes too long."""


class RehearsedSite:
    """One site, prepared for rehearsals.

    Args:
        loaded: as it flies.
    """

    def __init__(self, loaded: LoadedSite) -> None:
        site = loaded.site
        self._site = changed(
            site,
            twin__enabled=True,
            twin__scene="",
            twin__visitor_present=False,
            twin__mocap_rate_hz=min(site.twin.mocap_rate_hz, _TRACKING_RATE_HZ),
            control__rate_hz=min(site.control.rate_hz, _RATE_HZ),
            drone__odometry_error=site.odometry_error,
            lasers=(),
            depth_cameras=(),
            faults=(),
        )
        self._loaded = loaded
        self._viewing = ViewingRoom(site, loaded.room, loaded.grid)

    def rehearse(
        self, task: BoundTask, now: RoomNow, ask: AskRoom, limit: float = inf
    ) -> RehearsalReport:
        """Return what a rehearsal of a task finds.

        Args:
            task: what would fly.
            now: the room.
            ask: of the room's memory; raises ThingError or LinkError.
            limit: longest time of the rehearsal itself [s].
        """
        began = time.monotonic()
        try:
            report = self._checked(task, now, ask) or self._flown(task, now, ask, began + limit)
        except TaskError as error:
            report = RehearsalReport(False, ReasonCode(error.code), str(error))
        except HouseflyError as error:
            report = RehearsalReport(False, ReasonCode.STEP_FAILED, str(error))
        except RehearsalTimeout:
            report = RehearsalReport(
                False,
                ReasonCode.NOT_READY,
                f"the rehearsal was not done after {limit:.0f} s: this machine is busy",
            )
        return replace(report, took=time.monotonic() - began)

    def _checked(self, task: BoundTask, now: RoomNow, ask: AskRoom) -> RehearsalReport | None:
        """Return a refusal, or a yes without a flight; None when it has to be flown.

        Raises:
            TaskError: something that it looks at is unknown, or cannot be seen.
        """
        if not task.flies:
            return RehearsalReport(True, ReasonCode.OK, "nothing flies", duration=0.0, charge=0.0)
        here = (*self._loaded.room.home, 0.0) if now.drone is None else now.drone
        way: list[Vec2] = [here[:2]]
        for subject in _subjects(task.steps):
            view = viewpoint_of(
                subject, self._viewing, ask, now.people, (*way[-1], 0.0), now.obstacles, now.at
            )
            way.append(view.position)
        way.append(self._loaded.room.home)
        length = sum(distance(a, b) for a, b in pairwise(way))
        least = length / self._site.limits.speed + _UP_AND_DOWN
        needed = least / self._site.limits.flight_time
        return self._too_long(now, least, needed, tuple(way))

    def _too_long(
        self, now: RoomNow, duration: float, charge: float, way: tuple[Vec2, ...]
    ) -> RehearsalReport | None:
        """Return the refusal of a flight that the battery does not allow."""
        limits = self._site.limits
        spare = _known(now.battery) - limits.battery_floor - RETURN_RESERVE
        if charge <= spare:
            return None
        words = (
            f"it takes {_minutes(duration)} and {100 * charge:.0f} % of the charge;"
            f" {100 * max(0.0, spare):.0f} % are left above what the way home needs"
        )
        return RehearsalReport(False, ReasonCode.BATTERY, words, way, duration, charge)

    def _flown(self, task: BoundTask, now: RoomNow, ask: AskRoom, until: float) -> RehearsalReport:
        stage = _Stage(self._loaded, now)
        site = changed(self._site, twin__battery=_known(now.battery))

        def watch(world: SimulatedWorld) -> None:
            stage.set(world)
            if time.monotonic() > until:
                raise RehearsalTimeout

        flight = fly_task_lockstep(
            LoadedSite(site, self._loaded.room, self._loaded.grid),
            task,
            TaskScript(reply_time=_REPLY_TIME),
            people=stage.people,
            ids=stage.ids,
            movables=stage.movables,
            obstacles=stage.told,
            drone=None if now.drone is None else ((*now.drone[:2], _STANDING_HEIGHT), now.yaw),
            ask=ask,
            viewing=self._viewing,
            give_up_after=_LONGEST,
            hover_max=_HOVER_MAX,
            pictures=False,
            unix=now.unix,
            on_world=watch,
        )
        return self._judged(flight, now)

    def _judged(self, flight: TaskFlight, now: RoomNow) -> RehearsalReport:
        looks = flight.actions_of(StartClip, TakeSnapshot)
        report = RehearsalReport(
            may_fly=False,
            code=flight.code,
            words=flight.words,
            way=tuple(one.place for one in flight.samples),
            duration=flight.landed_at or flight.ended_at,
            charge=flight.charge,
            clearance=flight.clearance if isfinite(flight.clearance) else None,
            first_look=looks[0].at if looks else None,
        )
        if flight.contacts:
            words = f"the drone would touch {flight.contacts[0].name}"
            return replace(report, code=ReasonCode.SAFETY, words=words)
        if flight.stage is not TaskStage.DONE:
            code = ReasonCode.TOO_LONG if flight.code is ReasonCode.OK else flight.code
            words = flight.words or f"not done after {_minutes(_LONGEST)}"
            return replace(report, code=code, words=words)
        if flight.airborne_at is not None and not flight.is_on_pad:
            words = f"it would land {flight.off_pad:.1f} m from the pad"
            return replace(report, code=ReasonCode.SAFETY, words=words)
        refused = self._too_long(now, report.duration or 0.0, flight.charge, report.way)
        if refused is not None:
            return replace(report, code=refused.code, words=refused.words)
        return replace(report, may_fly=True, code=ReasonCode.OK, words=_expectation(flight))


class _Stage:
    """People and things of the room as it is now, as bodies of the simulated one."""

    def __init__(self, loaded: LoadedSite, now: RoomNow) -> None:
        site = loaded.site
        self._visitor = any(person.id == site.tracking.visitor for person in now.people)
        self._people = {
            f"person-{number}": person
            for number, person in enumerate(now.people)
            if person.id != site.tracking.visitor
        }
        self.people = tuple(
            PersonScript(name=name, height=_PERSON_HEIGHT, steps=()) for name in self._people
        )
        self.ids = {name: person.id for name, person in self._people.items()}
        pieces = {piece.name: piece for piece in site.furniture if piece.model}
        self._furniture = {
            pieces[one.id].body: body_pose_of(pieces[one.id], one.position, one.yaw)
            for one in now.obstacles
            if one.source == FURNITURE_SOURCE and one.id in pieces
        }
        self._things = {
            f"{number} {one.source} {one.id}"[:100]: one
            for number, one in enumerate(now.obstacles)
            if not (one.source == FURNITURE_SOURCE and one.id in pieces)
            and not _is_one_of(one, now.people)
        }
        self.movables = tuple(
            Movable(name, max(0.05, one.radius + max(one.size) / 2), max(0.1, one.top))
            for name, one in self._things.items()
        )
        self.told = (
            *(replace(one, velocity=(0.0, 0.0), confidence=1.0) for one in self._things.values()),
            *(
                _obstacle_of(name, one, site.people.body_radius)
                for name, one in self._people.items()
            ),
        )
        self._is_set = False

    def set(self, world: SimulatedWorld) -> None:
        """Put everybody and everything where they are, once."""
        if self._is_set:
            return
        self._is_set = True
        world.set_visitor(self._visitor)
        for name, person in self._people.items():
            world.put_person(name, person.position[:2])
        for body, pose in self._furniture.items():
            world.put(body, pose.position[:2], pose.yaw)
        for name, one in self._things.items():
            world.put(name, one.position, one.yaw)


def _is_one_of(obstacle: Obstacle, people: tuple[SeenPerson, ...]) -> bool:
    return any(distance(obstacle.position, person.position[:2]) < 0.5 for person in people)


def _obstacle_of(name: str, person: SeenPerson, radius: float) -> Obstacle:
    return Obstacle(name, person.position[:2], radius, source="people", kind=ObstacleKind.PERSON)


def _subjects(steps: tuple[TaskStep, ...]) -> Iterator[str]:
    """Yield what a task surely looks at, in order, as far as it is known before it flies."""
    for step in steps:
        if step.may_fail:
            continue
        subject = step.arguments.get("subject")
        if step.kind in (StepKind.GO_TO, StepKind.LOOK_AT) and isinstance(subject, str):
            if not names_in(subject):
                yield plain_text(subject, str)
        elif step.kind is StepKind.SEQUENCE:
            yield from _subjects(step.blocks.get("", ()))


def _known(battery: float | None) -> float:
    return 1.0 if battery is None or not isfinite(battery) else min(1.0, max(0.0, battery))


def _expectation(flight: TaskFlight) -> str:
    """Return what to expect, in one sentence."""
    if flight.airborne_at is None:
        return "nothing flies"
    duration = flight.landed_at or flight.ended_at
    added = f", {_minutes(flight.skipped)} of it hovering that was added" if flight.skipped else ""
    clear = f", {flight.clearance:.2f} m from the nearest thing" if flight.clearance < inf else ""
    return f"takes {_minutes(duration)}{added} and {100 * flight.charge:.0f} % of the charge{clear}"


def _minutes(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100.0 else f"{seconds / 60.0:.1f} min"
