"""Generated requests, orders, ticks and restarts: the scheduler against a naive queue."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from naive_queue import NaiveQueue

from housefly.errors import TaskError
from housefly.tasks.api.values import (
    ENDED,
    Confirm,
    OnPreempt,
    Priority,
    RequestSurface,
    TaskRequest,
    TaskStage,
)
from housefly.tasks.scheduler.scheduler import Scheduler
from housefly.tasks.scheduler.transitions import ACTIVE
from housefly.tasks.scheduler.values import (
    Decision,
    DroneAvailability,
    PreemptTask,
    ResumeTask,
    RunReport,
    SchedulerLimits,
    StartTask,
    TaskEnded,
    TaskMerged,
    TaskTraits,
)

LIMITS = SchedulerLimits(5, 2, confirm_time=60.0, fresh_time=300.0, per_source=2, alarms=2)
SERVICES = (
    TaskTraits("patrol", on_preempt=OnPreempt.RESUME),
    TaskTraits("look", on_preempt=OnPreempt.RESTART),
    TaskTraits("visitor", on_preempt=OnPreempt.END),
    TaskTraits("inventory", confirm=Confirm.ASK),
    TaskTraits("light", flies=False),
    TaskTraits("announce", flies=False),
)
RUNS = (
    RunReport(0),
    RunReport(0, is_safe_point=True),
    RunReport(0, TaskStage.DONE),
    RunReport(0, TaskStage.FAILED),
    RunReport(0, TaskStage.CANCELLED, is_safe_point=True),
)


@dataclass(frozen=True)
class Ask:
    service: int
    variant: bool
    by: str
    priority: Priority
    confirm: Confirm
    patience: float | None
    surface: RequestSurface = RequestSurface.CONSOLE


@dataclass(frozen=True)
class Tell:
    what: str
    which: int


@dataclass(frozen=True)
class Tick:
    after: float
    is_ready: bool
    runs: tuple[int, ...]


@dataclass(frozen=True)
class Restart:
    after: float


def weighted(weights: dict[object, int]) -> st.SearchStrategy:
    return st.sampled_from([value for value, weight in weights.items() for _ in range(weight)])


KINDS = {
    "ask": st.builds(
        Ask,
        st.integers(0, len(SERVICES) - 1),
        st.booleans(),
        st.sampled_from("abc"),
        st.sampled_from(Priority),
        weighted({Confirm.AUTO: 16, Confirm.ASK: 3, Confirm.NEVER: 1}),
        weighted({None: 8, 400.0: 2, 30.0: 1, 0.0: 1}),
        weighted({RequestSurface.CONSOLE: 4, RequestSurface.MQTT: 3, RequestSurface.RULE: 1}),
    ),
    "tell": st.builds(
        Tell,
        weighted({"yes": 8, "no": 2, "pause": 6, "continue": 4, "cancel": 4, "cancel all": 1}),
        st.integers(0, 60),
    ),
    "tick": st.builds(
        Tick,
        weighted({1.0: 12, 0.0: 1, 20.0: 3, 100.0: 2, 301.0: 1}),
        weighted({True: 5, False: 1}),
        st.tuples(*[weighted({0: 3, 1: 6, 2: 2, 3: 1, 4: 1})] * 3),
    ),
    "restart": st.builds(Restart, st.just(5.0)),
}
inputs = weighted({"ask": 16, "tick": 16, "tell": 8, "restart": 1}).flatmap(KINDS.__getitem__)
sequences = st.one_of(st.lists(inputs, max_size=10), st.lists(inputs, min_size=30, max_size=60))


class Pair:
    """The scheduler and the naive queue, told the same."""

    def __init__(self) -> None:
        self.now = 0.0
        self.real, self.naive = Scheduler(LIMITS), NaiveQueue(LIMITS)
        self.begun: Counter[int] = Counter()
        self.kept: set[int] = set()
        self.ended: set[int] = set()

    def tell(self, given_: Ask | Tell | Tick | Restart) -> None:
        if isinstance(given_, Ask):
            self._ask(given_)
        elif isinstance(given_, Tell):
            self._tell(given_)
        elif isinstance(given_, Tick):
            self.now += given_.after
            self._tick(given_)
        else:
            self.now += given_.after
            self._taken(self.real.restarted(self.now))
            self.naive.restart(self.now)
        self._compare()

    def _ask(self, ask: Ask) -> None:
        traits = SERVICES[ask.service]
        request = TaskRequest(
            traits.title,
            {"variant": ask.variant},
            asked_by=ask.by,
            surface=ask.surface,
            confirm=ask.confirm,
            priority=ask.priority,
            deadline=None if ask.patience is None else self.now + ask.patience,
        )
        before = self.naive.following
        row = self.naive.request(request, traits, self.now)
        decisions = self._taken(self.real.requested(request, traits, self.now))
        merged = [each.task.id for each in decisions if isinstance(each, TaskMerged)]
        assert merged == ([row.number] if row.number < before else [])
        for each in decisions:
            if isinstance(each, TaskEnded) and each.task.id != row.number:
                assert each.task.id in self.naive.may_go
                self.naive.rows[each.task.id].end = TaskStage.REFUSED

    def _tell(self, tell: Tell) -> None:
        numbers = [row.number for row in self.naive.open()] * 3 or [1]
        numbers += [*self.naive.rows, self.naive.following]
        number = numbers[tell.which % len(numbers)]
        if tell.what != "cancel all":
            self._order(tell.what, number)
            return
        self._taken(self.real.cancelled(0, "", self.now))
        for row in self.naive.open():
            self.naive.cancel(row.number)

    def _order(self, what: str, number: int) -> None:
        try:
            if what == "cancel":
                was_taken = self.naive.cancel(number)
                self._taken(self.real.cancelled(number, "", self.now))
            elif what in ("pause", "continue"):
                was_taken = self.naive.hold(number, what == "pause")
                order = self.real.paused if what == "pause" else self.real.continued
                self._taken(order(number, "", self.now))
            else:
                was_taken = self.naive.reply(number, what, self.now)
                self._taken(self.real.replied(number, what, "", self.now))
        except TaskError:
            assert not was_taken
        else:
            assert was_taken
        self._compare()

    def _tick(self, tick: Tick) -> None:
        active = [task.id for task in self.real.tasks if task.state in ACTIVE]
        runs = [
            RunReport(number, RUNS[kind].stage, is_safe_point=RUNS[kind].is_safe_point)
            for number, kind in zip(active, tick.runs, strict=False)
        ]
        before = {task.id: task.question for task in self.real.tasks}
        # News of runs that are long over change nothing.
        stale = [RunReport(number, TaskStage.DONE) for number in sorted(self.ended)[:2]]
        decisions = self._taken(
            self.real.ticked(self.now, [*stale, *runs], DroneAvailability(tick.is_ready))
        )
        self.naive.time_passed(runs, self.now)
        begun = [each.id for each in decisions if isinstance(each, StartTask | ResumeTask)]
        self.naive.check_beside([each for each in begun if not self._flies(each)])
        flights = [each for each in begun if self._flies(each)]
        asked = [
            task.id
            for task in self.real.tasks
            if task.question is not None and before.get(task.id) is None
        ]
        assert len(flights) <= 1
        if tick.is_ready:
            self.naive.check_flight(flights[0] if flights else None, asked, runs, self.now)
        else:
            assert not flights and not asked

    def _flies(self, number: int) -> bool:
        return self.naive.rows[number].traits.flies

    def _taken(self, outcome: tuple[Scheduler, tuple[Decision, ...]]) -> tuple[Decision, ...]:
        """Take the next scheduler; nothing is started twice, nothing happens after an end."""
        self.real, decisions = outcome
        for each in decisions:
            number = each.task.id if hasattr(each, "task") else each.id
            assert number not in self.ended
            if isinstance(each, StartTask):
                assert self.begun[number] == 0
                self.begun[number] += 1
            elif isinstance(each, PreemptTask):
                self.begun[number] -= 1
                self.kept |= {number} if each.is_kept else set()
            elif isinstance(each, ResumeTask):
                self.kept.remove(number)
                self.begun[number] += 1
                assert self.begun[number] == 1
            elif isinstance(each, TaskEnded):
                self.ended.add(number)
        return decisions

    def _compare(self) -> None:
        assert {task.id: task.state for task in self.real.tasks} == self.naive.states()
        active = [task for task in self.real.tasks if task.state in ACTIVE]
        assert sum(task.traits.flies for task in active) <= 1
        assert sum(not task.traits.flies for task in active) <= LIMITS.beside
        assert len(self.real.tasks) - len(active) <= LIMITS.queue + LIMITS.alarms
        assert self.real.next_id == self.naive.following
        assert not self.ended & {task.id for task in self.real.tasks}
        for row in self.naive.rows.values():
            assert (row.end is not None) == (row.number in self.ended)
            assert row.end is None or row.end in ENDED

    def finish(self) -> None:
        """Let everything run to its end: nothing stays open for ever."""
        for row in self.naive.open():
            if row.on_hold and not row.comes_home:
                self._order("continue", row.number)
        for _ in range(3 * len(self.naive.open()) + 2):
            self.tell(Tick(0.0, True, (2, 2, 2)))
            for row in self.naive.open():
                if row.asks_until is not None:
                    self._order("yes", row.number)
        assert not self.real.tasks


def play(sequence: list[Ask | Tell | Tick | Restart]) -> None:
    pair = Pair()
    for each in sequence:
        pair.tell(each)
    pair.finish()


@given(sequences)
@settings(max_examples=100)
def test_the_scheduler_does_what_the_naive_queue_does(
    sequence: list[Ask | Tell | Tick | Restart],
) -> None:
    play(sequence)


@pytest.mark.safety
@pytest.mark.timeout(3600)
@given(sequences)
@settings(max_examples=10_000, suppress_health_check=[HealthCheck.too_slow])
def test_ten_thousand_sequences_do_what_the_naive_queue_does(
    sequence: list[Ask | Tell | Tick | Restart],
) -> None:
    play(sequence)
