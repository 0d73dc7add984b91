"""What the tracking cameras see, as the console's map is told."""

from __future__ import annotations

import asyncio
import json
import threading
from typing import Any

import numpy as np
import pytest

from housefly.errors import RoomError
from housefly.room.bsen import bsen
from housefly.room.coverage import seen_by
from housefly.web.api.coverage_layer import (
    COVERAGE_CELL,
    CoverageLayer,
    CoverageView,
    coverage_view,
)

SMALL = CoverageView(1.1, 3, 2, (0.0, 0.0), COVERAGE_CELL, ("012", "333"))


@pytest.fixture(scope="module")
def view() -> CoverageView:
    return coverage_view(bsen(), 1.1)


def test_every_cell_says_how_many_cameras_see_its_middle(view: CoverageView) -> None:
    x0, y0, x1, y1 = bsen().bounds
    assert (view.cameras, view.origin) == (18, (x0, y0))
    assert len(view.rows) == round((y1 - y0) / COVERAGE_CELL) and {
        len(row) for row in view.rows
    } == {round((x1 - x0) / COVERAGE_CELL)}
    for i, j in ((3, 16), (20, 10), (45, 8), (59, 31)):
        middle = np.array([[x0 + COVERAGE_CELL * (i + 0.5), y0 + COVERAGE_CELL * (j + 0.5), 1.1]])
        assert int(view.rows[j][i], 36) == seen_by(bsen(), middle).sum()


def test_the_middle_of_the_room_is_tracked_and_beyond_the_walls_is_not(view: CoverageView) -> None:
    assert int(view.rows[16][36], 36) >= view.enough
    assert view.rows[31][2] == "0"


async def test_it_is_computed_once_beside_the_loop_for_everybody() -> None:
    threads: list[str] = []

    def compute() -> CoverageView:
        threads.append(threading.current_thread().name)
        return SMALL

    layer = CoverageLayer(compute)
    texts = await asyncio.gather(*(layer.text() for _ in range(5)))
    layer.close()
    assert len(threads) == 1 and threads[0] != threading.main_thread().name
    assert {json.loads(text)["rows"][0] for text in texts} == {"012"}


async def test_a_failure_is_told_and_tried_again() -> None:
    outcomes: list[Any] = [RoomError("no such room"), SMALL]

    def compute() -> CoverageView:
        outcome = outcomes.pop(0)
        if isinstance(outcome, Exception):
            raise outcome
        return SMALL

    layer = CoverageLayer(compute)
    with pytest.raises(RoomError):
        await layer.text()
    assert json.loads(await layer.text())["cameras"] == 3
    layer.close()


async def test_one_who_leaves_takes_the_answer_from_nobody() -> None:
    waiting = threading.Event()

    def compute() -> CoverageView:
        waiting.wait(5.0)
        return SMALL

    layer = CoverageLayer(compute)
    leaving, staying = asyncio.create_task(layer.text()), asyncio.create_task(layer.text())
    await asyncio.sleep(0)
    leaving.cancel()
    await asyncio.sleep(0)
    waiting.set()
    assert json.loads(await staying)["cameras"] == 3
    layer.close()


@pytest.mark.wire
async def test_only_browsers_with_a_session_are_told(serving: Any, loopback: str) -> None:
    async with serving(loopback, coverage=lambda: SMALL) as console:
        assert (await console.request("GET", "/coverage"))[0] == 401
        status, _, text = await console.request("GET", "/coverage", Cookie=await console.session())
        assert status == 200 and json.loads(text)["rows"] == ["012", "333"]


@pytest.mark.wire
async def test_failures_and_ignorance_are_told_in_words(serving: Any, loopback: str) -> None:
    def fail() -> CoverageView:
        raise RoomError("walls are missing")

    async with serving(loopback, coverage=fail) as console:
        status, _, text = await console.request("GET", "/coverage", Cookie=await console.session())
        assert status == 503 and "walls are missing" in text
    async with serving(loopback) as console:
        status, _, text = await console.request("GET", "/coverage", Cookie=await console.session())
        assert status == 404 and "cameras" in text
