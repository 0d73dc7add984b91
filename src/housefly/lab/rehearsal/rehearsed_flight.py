"""Rehearses a task in lock step on the room as it is now: may it fly, and what to expect.

First what costs nothing: does everything that the task looks at exist, is there a way, does the
charge suffice for the way alone. Then the whole flight in the simulated room, with live obstacles
as solid bodies: once for each way that answers of people lead to, and as long as its questions and
waits may last. Hovering is shortened, its time and charge are added.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from math import inf, isfinite
from typing import Any

from housefly.config.site import changed
from housefly.errors import HouseflyError, TaskError
from housefly.evidence.clip_values import StartClip, TakeSnapshot
from housefly.geometry import Vec2, distance
from housefly.hub.api.questions import Question
from housefly.lab.lockstep.task_flight import TaskFlight, TaskScript
from housefly.lab.lockstep.task_lockstep import fly_task_lockstep
from housefly.lab.rehearsal.rehearsed_branches import (
    BRANCHES_MAX,
    RehearsedBranch,
    fly_branches,
    longest,
)
from housefly.lab.rehearsal.rehearsed_stage import RehearsedStage
from housefly.lab.rehearsal.room_now import RoomNow
from housefly.messages.words import Words, error_words, figure, literal
from housefly.pilot.behavior.way_home import RETURN_RESERVE
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.api.values import ReasonCode, RehearsalReport, TaskStage
from housefly.tasks.document.steps import StepKind, TaskStep
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.document.templates import names_in, plain_text
from housefly.tasks.vantage.named_subject import viewpoint_of
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.twin.world import SimulatedWorld

_RATE_HZ, _TRACKING_RATE_HZ = 25.0, 12.5
"""Steps of the rehearsed pilot and its tracking: a quarter and an eighth of the usual, for speed;
clearances stay the same within 2 cm and times within 4 % (``benchmarks/rehearsal.py``).
"""
_HOVER_MAX = 1.0
"""Hovering longer than this is not flown [s]."""
_RANGE_MIN = 2.0
"""A flight whose length depends on people by less than this [s] is told with one time."""
_LONGEST = 600.0
"""A task that is not done after so long is not rehearsed to its end [s]."""
_UP_AND_DOWN = 8.0
"""Taking off and landing take about so long [s]."""
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
            report = RehearsalReport(False, ReasonCode(error.code), error_words(error))
        except HouseflyError as error:
            report = RehearsalReport(False, ReasonCode.STEP_FAILED, error_words(error))
        except RehearsalTimeout:
            report = RehearsalReport(
                False,
                ReasonCode.NOT_READY,
                literal(
                    f"the rehearsal was not done after {limit:.0f} s: this machine is busy, or"
                    " the task has many ways"
                ),
            )
        return replace(report, took=time.monotonic() - began)

    def _checked(self, task: BoundTask, now: RoomNow, ask: AskRoom) -> RehearsalReport | None:
        """Return a refusal, or a yes without a flight; None when it has to be flown.

        Raises:
            TaskError: something that it looks at is unknown, or cannot be seen.
        """
        if not task.flies:
            return RehearsalReport(
                True, ReasonCode.OK, Words("nothing flies"), duration=0.0, charge=0.0
            )
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
        words = Words(
            "it takes {time} and {p} % of the charge; {q} % are left above what the way home needs",
            time=_minutes(duration),
            p=figure(100 * charge, ".0f"),
            q=figure(100 * max(0.0, spare), ".0f"),
        )
        return RehearsalReport(False, ReasonCode.BATTERY, words, way, duration, charge)

    def _flown(self, task: BoundTask, now: RoomNow, ask: AskRoom, until: float) -> RehearsalReport:
        """Return what to expect of the worst of the ways that answers lead to."""
        whole = longest(task)
        branches: list[RehearsedBranch] = []
        for branch in fly_branches(
            whole, lambda script: self._fly_once(whole, script, now, ask, until)
        ):
            report = self._judged(branch.flight, now, branch.fails_by_itself)
            if not report.may_fly:
                is_only = not branch.words or not branches
                words = report.words
                if not is_only:
                    words = Words("{what}: {why}", what=branch.words, why=words)
                return replace(report, words=words)
            branches.append(branch)
        if len(branches) > BRANCHES_MAX:
            words = literal(
                f"its answers lead to more than {BRANCHES_MAX} ways: too many to rehearse"
            )
            return RehearsalReport(False, ReasonCode.TOO_LONG, words)
        if all(branch.fails_by_itself for branch in branches):
            return self._judged(branches[0].flight, now)
        return self._worst(branches, now)

    def _worst(self, branches: list[RehearsedBranch], now: RoomNow) -> RehearsalReport:
        reports = [self._judged(one.flight, now, one.fails_by_itself) for one in branches]
        slowest = max(reports, key=lambda one: one.duration or 0.0)
        shortest = min(
            (one.duration or 0.0) - branch.waited
            for one, branch in zip(reports, branches, strict=True)
        )
        clearances = [one.clearance for one in reports if one.clearance is not None]
        report = replace(
            slowest,
            charge=max(one.charge or 0.0 for one in reports),
            clearance=min(clearances, default=None),
            first_look=reports[0].first_look,
            shortest=max(0.0, shortest),
        )
        return replace(report, words=literal(_expectation(report, branches)))

    def _fly_once(
        self, task: BoundTask, script: TaskScript, now: RoomNow, ask: AskRoom, until: float
    ) -> TaskFlight:
        stage = RehearsedStage(self._loaded, now)
        site = changed(self._site, twin__battery=_known(now.battery))
        height = self._site.map.flight_height if now.is_airborne else _STANDING_HEIGHT

        def watch(world: SimulatedWorld) -> None:
            stage.set(world)
            if time.monotonic() > until:
                raise RehearsalTimeout

        return fly_task_lockstep(
            LoadedSite(site, self._loaded.room, self._loaded.grid),
            task,
            script,
            people=stage.people,
            ids=stage.ids,
            movables=stage.movables,
            obstacles=stage.told,
            drone=None if now.drone is None else ((*now.drone[:2], height), now.yaw),
            airborne=now.drone is not None and now.is_airborne,
            ask=ask,
            viewing=self._viewing,
            give_up_after=_LONGEST,
            hover_max=_HOVER_MAX,
            pictures=False,
            unix=now.unix,
            on_world=watch,
        )

    def _judged(self, flight: TaskFlight, now: RoomNow, may_fail: bool = False) -> RehearsalReport:
        """Return what one flight says; ``may_fail``: its document wants it to end as failed."""
        looks = flight.actions_of(StartClip, TakeSnapshot)
        report = RehearsalReport(
            may_fly=False,
            code=flight.code,
            words=literal(flight.words),
            way=tuple(one.place for one in flight.samples),
            duration=flight.landed_at or flight.ended_at,
            charge=flight.charge,
            shortest=flight.landed_at or flight.ended_at,
            clearance=flight.clearance if isfinite(flight.clearance) else None,
            first_look=looks[0].at if looks else None,
        )
        if flight.contacts:
            words = Words("the drone would touch {thing}", thing=flight.contacts[0].name)
            return replace(report, code=ReasonCode.SAFETY, words=words)
        if flight.stage is not TaskStage.DONE and not may_fail:
            code = ReasonCode.TOO_LONG if flight.code is ReasonCode.OK else flight.code
            words = literal(flight.words) or Words("not done after {time}", time=_minutes(_LONGEST))
            return replace(report, code=code, words=words)
        if flight.airborne_at is not None and not flight.is_on_pad:
            words = Words("it would land {d} m from the pad", d=figure(flight.off_pad, ".1f"))
            return replace(report, code=ReasonCode.SAFETY, words=words)
        refused = self._too_long(now, report.duration or 0.0, flight.charge, report.way)
        if refused is not None:
            return replace(report, code=refused.code, words=refused.words)
        return replace(report, may_fly=True, code=ReasonCode.OK)


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


def _expectation(report: RehearsalReport, branches: list[RehearsedBranch]) -> str:
    """Return what to expect, in one sentence."""
    if all(branch.flight.airborne_at is None for branch in branches):
        return "nothing flies"
    least, most = report.shortest or 0.0, report.duration or 0.0
    is_range = most - least > _RANGE_MIN
    takes = _minutes_between(least, most) if is_range else _minutes(most)
    skipped = max(branch.flight.skipped for branch in branches)
    added = f", up to {_minutes(skipped)} of it hovering on the spot" if skipped else ""
    charge = (
        f" and {'up to ' if is_range else ''}{100 * (report.charge or 0.0):.0f} % of the charge"
    )
    ways = f", by {len(branches)} ways that answers lead to" if len(branches) > 1 else ""
    near = report.clearance
    clear = f", {near:.2f} m from the nearest thing" if near is not None else ""
    return f"takes {takes}{added}{charge}{clear}{ways}"


def _minutes_between(least: float, most: float) -> str:
    if most < 180.0:
        return f"{least:.0f} to {most:.0f} s"
    return f"{least / 60.0:.1f} to {most / 60.0:.1f} min"


def _minutes(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100.0 else f"{seconds / 60.0:.1f} min"
