"""A goal has the name that people give it, whoever sent the drone there."""

from __future__ import annotations

from dataclasses import replace

import pytest
from fake_room import example_room

from housefly.config.house_mode import HouseMode
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.values import (
    ParameterValue,
    Priority,
    ReasonCode,
    RequestSurface,
    TaskStage,
    TaskStatus,
)
from housefly.web.status.goal_words import goal_words, subject_of_task, task_of_drone

PLACES = example_room().places


@pytest.mark.parametrize(
    ("name", "task", "said"),
    [
        ("entrance", "", "Entrance"),
        ("(6.4, 1.0)", "the cup", "Entrance"),
        ("(6.6, 1.2)", "", "Entrance"),
        ("(3.0, 3.0)", "the cup", "the cup"),
        ("(3.0, 3.0)", "", "the chosen point"),
        ("(-3.0, 3.0)", "", "the chosen point"),
        ("home", "", "Home"),
        ("", "the cup", ""),
    ],
)
def test_a_goal_is_called_as_people_call_it(name: str, task: str, said: str) -> None:
    assert goal_words(name, PLACES, task) == said


def board(state: TaskStage, **parameters: ParameterValue) -> TaskBoard:
    task = TaskStatus(
        id=1,
        service="look",
        title="Look at something",
        parameters=parameters,
        state=state,
        code=ReasonCode.OK,
        words="",
        asked_by="Anna",
        surface=RequestSurface.CONSOLE,
        cause="",
        priority=Priority.PERSON,
        asked_at=0.0,
    )
    return TaskBoard(0.0, HouseMode.HOME, "", False, (task,), ())


@pytest.mark.parametrize(
    ("told", "said"),
    [
        (board(TaskStage.RUNNING, subject="the cup", time=8.0), "the cup"),
        (board(TaskStage.RUNNING, door="entrance", stay=45.0), "Entrance"),
        (board(TaskStage.RUNNING, time=8.0), "“Look at something”"),
        (board(TaskStage.QUEUED, subject="the cup"), ""),
        (None, ""),
    ],
)
def test_what_flies_is_about_what_its_task_was_asked_for(told: TaskBoard | None, said: str) -> None:
    assert subject_of_task(task_of_drone(told), PLACES) == said


def test_the_task_that_has_the_drone_is_the_one_that_flies_it_also_while_it_is_paused() -> None:
    (asked,) = board(TaskStage.RUNNING, subject="the cup").tasks
    flown = replace(asked, id=2, state=TaskStage.PAUSED, took_off_at=5.0, drone="kite")
    told = replace(board(TaskStage.RUNNING), tasks=(replace(asked, drone="kite"), flown))
    assert task_of_drone(told, "kite") == flown
    assert task_of_drone(told, "finch") is None
    assert task_of_drone(told) == flown
