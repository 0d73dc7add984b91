"""Runs one task: told what is known at each tick, it answers what is to be done; pure."""

from __future__ import annotations

from dataclasses import replace

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from housefly.messages import DroneStatus, Order, OrderKind, Phase
from housefly.messages.words import UNSAID, Words, joined, literal
from housefly.tasks.api.values import (
    ReasonCode,
    TaskLook,
    TaskStage,
    TaskStepState,
    TaskStepStatus,
)
from housefly.tasks.document.steps import StepKind, TaskStep
from housefly.tasks.document.task_document import RETURN_HOME, BoundTask
from housefly.tasks.execution.run_context import RunContext
from housefly.tasks.execution.station import way_to_station
from housefly.tasks.execution.step_behavior import StepBehavior
from housefly.tasks.execution.task_room import TaskRoom
from housefly.tasks.execution.tree import tree_of
from housefly.tasks.execution.values import PersonReply, Say, TaskAction, TaskInputs

TASK_TIME_MAX = 3600.0
"""No task takes longer than this [s], whatever its document says."""
HOLD_PERIOD = 30.0
"""A hovering drone is told to stay this often [s]: the pilot brings home one that hears nothing."""
PAUSE_TIME_MAX = 600.0
"""A drone whose task is paused for longer [s] is left to the pilot, which brings it home."""
CANCEL_TIME_MAX = 60.0
"""What ``on_cancel`` does before it comes down may take so long in all [s]; then it comes home."""
HOME_REFUSED_TIME = 5.0
"""A way home that was refused for good so short a time ago is not tried again [s]."""
HOLD_REPEAT = 1.0
"""A paused drone that still moves is told to hover again after this [s]."""
LAND = (TaskStep(StepKind.LAND),)
"""What brings the drone down when it cannot come home."""
WAYS_DOWN = (RETURN_HOME, LAND)
"""What ends a flight, the next when the one before cannot be done."""
_MOVING = frozenset({Phase.TAKING_OFF, Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING})
_UNFINISHED = frozenset({TaskStepState.WAITING, TaskStepState.RUNNING})

_End = tuple[TaskStage, ReasonCode, Words]


class TaskRun:
    """One running task.

    Attributes:
        task: what runs.
        stage: RUNNING, PAUSED, or how it ended.
        code, words: why, for programs and for people.
    """

    def __init__(self, task: BoundTask, room: TaskRoom) -> None:
        self.task = task
        self.stage, self.code, self.words = TaskStage.RUNNING, ReasonCode.OK, UNSAID
        self._context = RunContext(task.service, room)
        self._tree = tree_of(task.steps, self._context)
        self._closing: Behaviour | None = None
        self._closings: list[tuple[TaskStep, ...]] = []
        self._closing_since, self._is_hurried = 0.0, False
        self._end: _End | None = None
        self._station: Behaviour | None = None
        self._station_time, self._was_paused = 0.0, False
        self._last: float | None = None
        self._held_since: float | None = None
        self._unheard: tuple[PersonReply, ...] = ()
        self._held_at = 0.0
        self._moved_at = float("-inf")

    @property
    def steps(self) -> tuple[TaskStepStatus, ...]:
        """How far each step is, in order."""
        return tuple(TaskStepStatus(n.name, n.words, n.state) for n in self._context.notes)

    @property
    def look(self) -> TaskLook | None:
        """What it shows people now, and until when; None while it shows nothing."""
        words, tip = self._context.looks, self._tree.tip()
        if not words or self.is_over or not self._context.is_airborne:
            return None
        left = tip.left if isinstance(tip, StepBehavior) else None
        if left is None or self.stage is TaskStage.PAUSED:
            return TaskLook(words)
        # The clocks differ by a little from tick to tick, and that is no news.
        return TaskLook(words, float(round(self._context.inputs.unix + left)))

    @property
    def is_over(self) -> bool:
        """Whether it has ended."""
        return self.stage not in (TaskStage.RUNNING, TaskStage.PAUSED)

    @property
    def is_safe_point(self) -> bool:
        """Whether a more important task may take the drone now.

        Not while it takes off, comes home or lands, while an order is under way, or while a clip
        is recorded that nobody could take again.
        """
        context = self._context
        is_still = context.inputs.phase in (Phase.IDLE, Phase.HOLDING, Phase.OUTBOUND)
        is_open = context.orders.is_open(context.inputs.now)
        return is_still and not is_open and not context.clips and self._end is None

    def cancel(self, words: Words) -> None:
        """End it: in the air it does what its document says, on the ground nothing moves.

        The second time it leaves out the rest of that, and comes home.
        """
        if self.is_over:
            return
        if self._end is not None and self._end[0] is not TaskStage.DONE:
            self._is_hurried = True
            self.resume()
            return
        is_closing = self._end is not None
        self._end = (TaskStage.CANCELLED, ReasonCode.CANCELLED, words)
        if is_closing:
            self.resume()
        elif self.stage is TaskStage.PAUSED:
            self.stage, self._last = TaskStage.RUNNING, None
        if not is_closing:
            self._tree.stop(Status.INVALID)

    def pause(self) -> None:
        """Hover where the drone is, until ``resume``; the times of its steps stand still."""
        if self.stage is TaskStage.RUNNING:
            self.stage, self._held_at = TaskStage.PAUSED, float("-inf")
            self._held_since = None

    def resume(self) -> None:
        """Go on with the same step, which gives its order again."""
        if self.stage is TaskStage.PAUSED:
            self.stage = TaskStage.RUNNING
            self._context.round += 1
            self._context.orders.forget()
            # What passed since the last tick, paused or flown by another task, is not its time.
            self._last = None
            self._was_paused = True

    def step(self, inputs: TaskInputs) -> tuple[TaskAction, ...]:
        """Go on by one tick; return what is to be done now, in order."""
        if self.is_over:
            return ()
        context = self._context
        # A reply that comes while the tree stands still is heard when it goes on.
        self._unheard += inputs.replies
        context.hear(replace(inputs, replies=()))
        if not context.hovers:
            self._moved_at = inputs.now
        interference = context.orders.update(inputs) if self.task.flies else None
        if interference is not None:
            taken = interference.code is ReasonCode.PERSON_TOOK_OVER
            stage = TaskStage.CANCELLED if taken else TaskStage.FAILED
            self._finish((stage, interference.code, interference.words))
        elif self.stage is TaskStage.PAUSED:
            self._hold()
        else:
            self._pass_time(inputs.now)
            self._advance()
        actions = tuple(context.actions)
        context.actions.clear()
        return actions

    def _pass_time(self, now: float) -> None:
        if self._last is not None:
            self._context.time += max(0.0, now - self._last)
        self._last = now

    def _advance(self) -> None:
        if self._end is not None:
            self._close()
        elif self._is_late():
            self._conclude((TaskStage.FAILED, ReasonCode.TIMEOUT, Words("the task took too long")))
        elif self._wants_station() and self._station is not None:
            self._return_to_station(self._station)
        else:
            self._tick(self._tree)
            if self._tree.status is Status.SUCCESS:
                self._conclude((TaskStage.DONE, ReasonCode.OK, Words("done")))
            elif self._tree.status is Status.FAILURE:
                self._conclude((TaskStage.FAILED, *self._context.failure))
            else:
                self._stay_alive()

    def _tick(self, tree: Behaviour) -> None:
        self._context.inputs = replace(self._context.inputs, replies=self._unheard)
        self._unheard = ()
        tree.tick_once()

    def _is_late(self) -> bool:
        limit = min(self.task.time_limit or TASK_TIME_MAX, TASK_TIME_MAX)
        return self._context.time > limit

    def _wants_station(self) -> bool:
        """Whether the drone has yet to fly back to where it hovered before a pause."""
        if self._was_paused and not self._context.flights:
            self._station = way_to_station(self._context)
            self._station_time = self._context.time
        self._was_paused = False
        return self._station is not None

    def _return_to_station(self, station: Behaviour) -> None:
        """Fly back to where the drone hovered before the pause; then the step goes on."""
        station.tick_once()
        if station.status is Status.SUCCESS:
            # The way back is not the step's time.
            self._station, self._context.time = None, self._station_time
        elif station.status is Status.FAILURE:
            self._conclude((TaskStage.FAILED, *self._context.failure))

    def _conclude(self, end: _End) -> None:
        """The steps are over; the drone may have to come home yet."""
        if self._tree.status is Status.RUNNING:
            self._tree.stop(Status.INVALID)
        self._end = end
        self._close()

    def _close(self) -> None:
        """Bring the drone down as the end wants it, then end."""
        if self._closing is None and self._waits_for_pilot():
            return
        if self._closing is None and self._must_come_down():
            self._closings = self._ways_down()
        elif self._closing is not None and not self._is_cut_short(self._closing):
            self._tick(self._closing)
        while self._must_come_down() and self._closings and not self._is_closing():
            self._begin_closing(self._closings.pop(0))
        if self._is_closing():
            self._stay_alive()
        else:
            self._finish(self._end)

    def _begin_closing(self, steps: tuple[TaskStep, ...]) -> None:
        """Go on with the next way down; one that was just refused for long is left out."""
        context = self._context
        if context.inputs.now - context.home_refused_at < HOME_REFUSED_TIME:
            if steps == RETURN_HOME:
                return
            if steps == LAND:
                context.actions.append(Say("It cannot come home: landing where it is safe"))
        context.is_ending = True
        self._closing, self._closing_since = tree_of(steps, context), context.time
        self._tick(self._closing)

    def _is_cut_short(self, closing: Behaviour) -> bool:
        """Give up what is done on a cancel when it takes too long, unless it comes down."""
        context = self._context
        is_late = context.time - self._closing_since > CANCEL_TIME_MAX
        is_last = len(self._closings) < len(WAYS_DOWN)
        comes_down = context.orders.is_homing and context.is_airborne
        if is_last or comes_down or not (self._is_hurried or is_late):
            return False
        closing.stop(Status.INVALID)
        return True

    def _must_come_down(self) -> bool:
        """Whether this task has the drone in the air; a person's own flight is none of its."""
        return self._context.has_flown and self._context.is_airborne

    def _is_closing(self) -> bool:
        return self._closing is not None and self._closing.status is Status.RUNNING

    def _waits_for_pilot(self) -> bool:
        """Whether an order to take off was given that the pilot has not answered yet."""
        context = self._context
        return context.inputs.phase is Phase.IDLE and context.orders.is_open(context.inputs.now)

    def _ways_down(self) -> list[tuple[TaskStep, ...]]:
        """Return what brings the drone down, the next when the one before did not."""
        inputs = self._context.inputs
        if inputs.phase is Phase.TAKING_OFF and inputs.status is DroneStatus.LANDED:
            return [LAND]  # it stands yet: nothing moves
        is_cancelled = self._end is not None and self._end[0] is TaskStage.CANCELLED
        first = [self.task.on_cancel] if is_cancelled else []
        return [*first, *WAYS_DOWN]

    def _hold(self) -> None:
        """Hover while paused; a landing is not held up."""
        inputs, context = self._context.inputs, self._context
        period = HOLD_REPEAT if inputs.phase in _MOVING else HOLD_PERIOD
        is_up = inputs.phase in _MOVING or context.hovers
        if self._held_since is None:
            self._held_since = inputs.now
        is_short = inputs.now - self._held_since < PAUSE_TIME_MAX
        if is_short and context.has_flown and is_up and inputs.now - self._held_at >= period:
            self._held_at = inputs.now
            context.give(Order(OrderKind.HOVER))

    def _stay_alive(self) -> None:
        """Tell a drone that hovers for long to stay; one that just arrived may still turn."""
        context = self._context
        is_ours = context.has_flown and context.hovers
        since = max(context.orders.given_at, self._moved_at)
        if is_ours and context.inputs.now - since > HOLD_PERIOD:
            context.give(Order(OrderKind.HOVER))

    def _finish(self, end: _End | None) -> None:
        assert end is not None
        self.stage, self.code, self.words = self._on_its_feet(end)
        for tree in (self._tree, self._station, self._closing):
            if tree is not None and tree.status is Status.RUNNING:
                tree.stop(Status.INVALID)
        for note in self._context.notes:
            if note.state in _UNFINISHED:
                note.state = TaskStepState.SKIPPED

    def _on_its_feet(self, end: _End) -> _End:
        """Return how it ended: not done where the drone came down on something."""
        (stage, code, words), fault = end, self._context.standing_fault
        if not fault or words == fault:
            return end
        if stage is TaskStage.DONE:
            return TaskStage.FAILED, ReasonCode.SAFETY, literal(fault)
        return stage, code, joined("; ", (words, fault))
