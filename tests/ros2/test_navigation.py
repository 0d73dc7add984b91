"""A goal of NavigateToPose ends as the flight does, whoever ends it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.config.house_mode import HouseMode
from housefly.messages import (
    Action,
    Command,
    Estimate,
    Inputs,
    Order,
    OrderKind,
    OrderSource,
    Outputs,
    Path,
    Phase,
    PilotStep,
)
from housefly.messages.words import Words
from housefly.ros2 import navigation
from housefly.ros2.navigation import START_TIME, STRAY_TIME, Navigation, NavigationEnd
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.values import (
    Priority,
    ReasonCode,
    RequestSurface,
    TaskStage,
    TaskStatus,
)
from housefly.tasks.execution import flight_steps

GOAL = (5.0, 2.0)
OURS = Order(OrderKind.GO, sender="ROS 2", source=OrderSource.PROGRAM, id="ours")
WAY = Path(((1.0, 2.0), (3.0, 2.0), (3.0, 4.0), GOAL), 6.0, 0.5)


def step(
    phase: Phase, x: float = 1.0, at: float = 11.0, path: Path | None = None, waypoint: int = 0
) -> PilotStep:
    estimate = Estimate(at, (x, 2.0, 1.1), (0.0, 0.0, 0.0), 0.0, 0.02, 0.01)
    outputs = Outputs(Command(Action.IDLE), estimate, phase=phase, path=path, waypoint=waypoint)
    return PilotStep(1, at, Inputs(), outputs)


def ordered() -> Navigation:
    return Navigation(GOAL, "ours", 0, 10.0)


def board(state: TaskStage) -> TaskBoard:
    task = TaskStatus(
        7,
        "fly_to",
        "Fly to a point",
        {},
        state,
        ReasonCode.OK,
        Words("because"),
        "ROS 2",
        RequestSurface.ROS,
        "",
        Priority.PERSON,
        1.0,
    )
    return TaskBoard(1.0, HouseMode.HOME, Words("idle"), False, (task,), ())


def test_it_has_arrived_when_the_drone_holds_at_the_goal() -> None:
    flown = ordered()
    for phase, x in ((Phase.IDLE, 1.0), (Phase.TAKING_OFF, 1.0), (Phase.OUTBOUND, 5.0)):
        flown.add_step(step(phase, x), OURS)
        assert flown.result is None
    flown.add_step(step(Phase.HOLDING, 5.1), OURS)
    assert flown.result is not None and flown.result.end is NavigationEnd.ARRIVED


def test_the_way_that_is_left_is_along_the_pilots_path() -> None:
    flown = ordered()
    flown.add_step(step(Phase.OUTBOUND, 2.0, 14.0, WAY, waypoint=1), OURS)
    assert flown.progress is not None
    assert flown.progress.remaining == pytest.approx(1.0 + 2.0 + 8.0**0.5)
    assert flown.progress.elapsed == pytest.approx(4.0)


def test_a_path_that_leads_elsewhere_says_nothing_about_the_way() -> None:
    home = Path((GOAL, (1.0, 1.0)), 4.0, 0.5)
    flown = ordered()
    flown.add_step(step(Phase.RETURNING, 2.0, path=home), OURS)
    assert flown.progress is not None and flown.progress.remaining == pytest.approx(3.0)


@pytest.mark.parametrize(
    ("holder", "words"),
    [
        (Order(OrderKind.STOP, sender="Anna", id="x"), "stopped by Anna"),
        (Order(OrderKind.HOME, sender="Ben", id="x"), "home of Ben"),
        (replace(OURS, id="newer"), "go of ROS 2"),
    ],
)
def test_who_takes_the_drone_ends_the_goal(holder: Order, words: str) -> None:
    flown = ordered()
    flown.add_step(step(Phase.OUTBOUND), holder)
    assert flown.result is not None and flown.result.end is NavigationEnd.FAILED
    assert words in flown.result.words


@pytest.mark.parametrize("phase", [Phase.HOLDING, Phase.RETURNING, Phase.LANDING, Phase.IDLE])
def test_a_drone_that_gives_up_on_the_way_fails_after_a_while(phase: Phase) -> None:
    flown = ordered()
    flown.add_step(step(Phase.OUTBOUND, 3.0, 12.0), OURS)
    flown.add_step(step(phase, 3.0, 13.0), OURS)
    assert flown.result is None
    flown.add_step(step(phase, 3.0, 13.0 + STRAY_TIME), OURS)
    assert flown.result is not None and "2.00 m from the goal" in flown.result.words


def test_a_pause_on_the_way_is_no_end() -> None:
    flown = ordered()
    for at, phase in ((12.0, Phase.OUTBOUND), (13.0, Phase.HOLDING), (14.0, Phase.OUTBOUND)):
        flown.add_step(step(phase, 3.0, at), OURS)
    flown.add_step(step(Phase.HOLDING, 3.0, 15.5), OURS)
    assert flown.result is None


def test_a_drone_that_never_takes_off_fails() -> None:
    flown = ordered()
    flown.add_step(step(Phase.IDLE, 1.0, 10.5), None)
    flown.add_step(step(Phase.IDLE, 1.0, 10.5 + START_TIME), None)
    assert flown.result is not None and flown.result.words == "it did not take off"


def test_of_a_task_only_its_own_flight_counts() -> None:
    flown = Navigation(GOAL, "", 7, 10.0)
    flown.add_board(board(TaskStage.WAITING))
    flown.add_step(step(Phase.HOLDING, 5.0), None)
    flown.add_step(step(Phase.IDLE, 1.0, 500.0), None)
    assert flown.result is None, "it waits for a yes"
    flown.add_board(board(TaskStage.RUNNING))
    flown.add_step(step(Phase.OUTBOUND, 3.0, 501.0), replace(OURS, id="of the task"))
    assert flown.result is None
    flown.add_step(step(Phase.HOLDING, 5.0, 505.0), replace(OURS, id="of the task"))
    assert flown.result is not None and flown.result.end is NavigationEnd.ARRIVED


@pytest.mark.parametrize(
    "state",
    [TaskStage.REFUSED, TaskStage.FAILED, TaskStage.CANCELLED, TaskStage.EXPIRED],
)
def test_a_task_that_ends_otherwise_ends_the_goal_with_its_words(state: TaskStage) -> None:
    flown = Navigation(GOAL, "", 7, 10.0)
    flown.add_board(board(state))
    assert flown.result is not None and flown.result.end is NavigationEnd.FAILED
    assert flown.result.words == f"task 7 was {state.value}: because"


def test_what_has_ended_stays_so() -> None:
    flown = ordered()
    flown.end(NavigationEnd.FAILED, "first")
    flown.add_step(step(Phase.HOLDING, 5.0), OURS)
    assert flown.result is not None and flown.result.words == "first"


def test_arrived_is_what_it_is_for_tasks() -> None:
    assert navigation.ARRIVED_WITHIN == flight_steps.ARRIVED_WITHIN
    assert navigation.STRAY_TIME == flight_steps.STRAY_TIME
