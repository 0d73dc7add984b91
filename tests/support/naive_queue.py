"""The queue again, as a plain book of facts: what the scheduler is compared with.

No table and no states: each task is a row of yes and no. It does not say which of several equal
tasks is next; it says whether the one that was taken was allowed to be.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from housefly.tasks.api.values import (
    Confirm,
    OnPreempt,
    Priority,
    RequestSurface,
    TaskRequest,
    TaskStage,
)
from housefly.tasks.scheduler.transitions import QueueState
from housefly.tasks.scheduler.values import RunReport, SchedulerLimits, TaskTraits

URGENCY = [Priority.BACKGROUND, Priority.RULE, Priority.PERSON, Priority.ALARM]


@dataclass
class Row:
    """One task."""

    number: int
    request: TaskRequest
    traits: TaskTraits
    urgency: int
    deadline: float | None
    wanted_at: float
    asks_until: float | None = None
    runs: bool = False
    run_kept: bool = False
    on_hold: bool = False
    comes_home: bool = False
    began: bool = False
    end: TaskStage | None = None
    ahead_of_own: int = 0
    passed_by: set[int] = field(default_factory=set)

    @property
    def waits(self) -> bool:
        return self.end is None and not self.runs

    @property
    def by_person(self) -> bool:
        return self.request.surface not in (RequestSurface.MQTT, RequestSurface.RULE)

    @property
    def counted_with(self) -> tuple[object, ...]:
        return (self.request.asked_by,) if self.by_person else (self.request.surface, "machine")

    @property
    def could_start(self) -> bool:
        return self.waits and self.asks_until is None and not self.on_hold

    @property
    def state(self) -> QueueState:
        if self.end is not None:
            return QueueState[self.end.name]
        if self.runs:
            if self.comes_home:
                return QueueState.ENDING
            return QueueState.PAUSED if self.on_hold else QueueState.RUNNING
        if self.asks_until is not None:
            return QueueState.ASKED_AGAIN if self.run_kept else QueueState.WAITING
        if self.on_hold:
            return QueueState.HELD_SUSPENDED if self.run_kept else QueueState.HELD
        return QueueState.SUSPENDED if self.run_kept else QueueState.QUEUED


class NaiveQueue:
    """Rows by number."""

    def __init__(self, limits: SchedulerLimits) -> None:
        self.limits = limits
        self.rows: dict[int, Row] = {}
        self.following = 1

    def open(self) -> list[Row]:
        return [row for row in self.rows.values() if row.end is None]

    def request(self, request: TaskRequest, traits: TaskTraits, now: float) -> Row:
        """Return the row that the request became or joined."""
        asks = Confirm.ASK in (request.confirm, traits.confirm)
        row = Row(
            self.following,
            request,
            traits,
            URGENCY.index(request.priority),
            request.deadline,
            now,
            now + self.limits.confirm_time if asks else None,
        )
        if Confirm.NEVER in (request.confirm, traits.confirm):
            row.end = TaskStage.REFUSED
        elif request.deadline is not None and now >= request.deadline:
            row.end = TaskStage.EXPIRED
        else:
            for other in self.open():
                is_same = (other.request.service, other.request.parameters) == (
                    request.service,
                    request.parameters,
                )
                if is_same and other.waits and not other.run_kept:
                    self._join(other, row, asks, now)
                    return other
            self._find_room(row)
        row.ahead_of_own = sum(
            other.waits
            and other.request.asked_by == request.asked_by
            and other.urgency == row.urgency
            for other in self.open()
        )
        self.rows[self.following] = row
        self.following += 1
        return row

    def _join(self, row: Row, newer: Row, asks: bool, now: float) -> None:
        if not asks:
            row.asks_until, row.wanted_at = None, now
        if row.asks_until is not None or not asks:
            row.urgency = max(row.urgency, newer.urgency)
            if row.deadline is None or newer.deadline is None:
                row.deadline = None
            else:
                row.deadline = max(row.deadline, newer.deadline)
            if newer.by_person and not row.by_person:
                who = {"asked_by": newer.request.asked_by, "surface": newer.request.surface}
                row.request = replace(row.request, **who)

    def _find_room(self, row: Row) -> None:
        waiting = [other for other in self.open() if other.waits]
        same = [other for other in waiting if other.counted_with == row.counted_with]
        if row.by_person:
            same = [other for other in same if other.asks_until is not None]
        asks = row.asks_until is not None
        if len(same) >= self.limits.per_source and (asks or not row.by_person):
            waiting = same
        elif len(waiting) < self.limits.queue:
            return
        lesser = [other for other in waiting if not other.began and self._is_lesser(other, row)]
        machines = [other for other in lesser if not other.by_person]
        lesser = machines or lesser
        alarms = [other for other in waiting if other.urgency == row.urgency == 3]
        is_spare = waiting is not same and row.urgency == 3 and len(alarms) < self.limits.alarms
        if not lesser and not is_spare:
            row.end = TaskStage.REFUSED
        self.may_go = {
            other.number
            for other in lesser
            if other.urgency == min(each.urgency for each in lesser)
        }

    def _is_lesser(self, other: Row, row: Row) -> bool:
        """Whether one makes way for another: no person's for a machine's."""
        if row.by_person and not other.by_person:
            return other.urgency <= row.urgency
        return other.urgency < row.urgency and (row.by_person or not other.by_person)

    def reply(self, number: int, choice: str, now: float) -> bool:
        """Return whether there was something to reply to."""
        row = self.rows.get(number)
        if row is None or row.end is not None or row.asks_until is None:
            return False
        if now >= row.asks_until:
            row.end = TaskStage.EXPIRED
        elif choice == "no":
            row.end = TaskStage.CANCELLED if row.run_kept else TaskStage.REFUSED
        else:
            row.asks_until, row.wanted_at = None, now
        return True

    def cancel(self, number: int) -> bool:
        row = self.rows.get(number)
        if row is None or row.end is not None:
            return False
        if row.runs:
            row.comes_home = True
        else:
            row.end = TaskStage.CANCELLED
        return True

    def hold(self, number: int, on: bool) -> bool:
        row = self.rows.get(number)
        if row is None or row.end is not None or row.comes_home or row.asks_until is not None:
            return False
        row.on_hold = on
        return True

    def time_passed(self, runs: Iterable[RunReport], now: float) -> None:
        """Let runs end and patience run out."""
        for run in runs:
            row = self.rows.get(run.id)
            over = run.stage not in (TaskStage.RUNNING, TaskStage.PAUSED)
            if row is not None and row.end is None and row.runs and over:
                row.end = run.stage
        for row in self.open():
            is_late = row.deadline is not None and now >= row.deadline and not row.began
            is_unanswered = row.asks_until is not None and now >= row.asks_until
            if is_unanswered or (row.waits and is_late):
                row.end = TaskStage.EXPIRED

    def check_beside(self, started: list[int]) -> None:
        """Check which tasks without a flight were started, and start them."""
        running = sum(row.runs and not row.traits.flies for row in self.open())
        could = [row for row in self.open() if row.could_start and not row.traits.flies]
        assert len(started) == max(min(len(could), self.limits.beside - running), 0)
        for number in started:
            assert self.rows[number] in could
            self._start(self.rows[number], could)

    def check_flight(
        self, started: int | None, asked: list[int], runs: Iterable[RunReport], now: float
    ) -> None:
        """Check which flight was begun or taken up again and who was asked again, and do it."""
        holder = next((row for row in self.open() if row.runs and row.traits.flies), None)
        is_safe = (
            any(run.id == holder.number and run.is_safe_point for run in runs) if holder else 1
        )
        could = [
            row
            for row in self.open()
            if row.could_start
            and row.traits.flies
            and (holder is None or row.urgency > holder.urgency)
        ]
        if not is_safe or not could:
            assert started is None and not asked
            return
        fresh = [row for row in could if now - row.wanted_at <= self.limits.fresh_time]
        if started is None:
            assert not fresh and sorted(asked) == sorted(row.number for row in could)
        for number in asked:
            assert self.rows[number] in could and self.rows[number] not in fresh
            self.rows[number].asks_until = now + self.limits.confirm_time
        if started is None:
            return
        taken = self.rows[started]
        assert taken in fresh
        best = max((row.urgency, row.run_kept) for row in fresh)
        assert (taken.urgency, taken.run_kept) == best
        assert all(_rank(self.rows[number]) >= best for number in asked)
        if holder is not None:
            self._make_way(holder, now)
        self._start(taken, fresh)

    def _start(self, row: Row, could: list[Row]) -> None:
        for other in could:
            if other is not row and other.waits and _rank(other) == _rank(row):
                if other.request.asked_by == row.request.asked_by:
                    assert row.number < other.number
                elif row.number > other.number:
                    other.passed_by.add(row.number)
        assert len(row.passed_by) <= row.ahead_of_own * self.limits.queue
        row.runs, row.began, row.run_kept = True, True, False

    def _make_way(self, row: Row, now: float) -> None:
        then = row.traits.on_preempt
        if row.comes_home or then is OnPreempt.END:
            row.end = TaskStage.CANCELLED
        row.runs, row.run_kept, row.wanted_at = False, then is OnPreempt.RESUME, now

    def restart(self, now: float) -> None:
        """The program ended and begins again."""
        for row in self.open():
            if row.runs or row.run_kept:
                row.end = TaskStage.FAILED
            elif row.traits.flies or row.asks_until is not None:
                row.on_hold, row.asks_until = False, now + self.limits.confirm_time

    def states(self) -> Mapping[int, QueueState]:
        return {row.number: row.state for row in self.open()}


def _rank(row: Row) -> tuple[int, bool]:
    return row.urgency, row.run_kept
