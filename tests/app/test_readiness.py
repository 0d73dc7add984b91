"""A run is ready when those whom people ask have answered once."""

from __future__ import annotations

import pytest

from housefly.app import readiness
from housefly.app.readiness import Readiness
from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY
from housefly.config.site import Site, changed

EMPTY_ROOM = changed(Site(), drone__enabled=False, tracking__enabled=False, twin__enabled=False)


def test_a_run_with_a_console_waits_until_memory_and_tasks_answer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(readiness, "console_answers", lambda site: True)
    bus = LocalBus()
    ready = Readiness(EMPTY_ROOM, bus, web=True, video=False)
    assert ready.wait(0.0).startswith("waiting for memory, tasks")
    bus.answer(HUB_QUERY, lambda text: "{}")
    assert ready.wait(0.0).startswith("waiting for tasks")
    bus.answer(TASKS_QUERY, lambda text: "{}")
    assert ready.wait(0.0) == ""


def test_nobody_who_flies_without_a_console_waits_for_memory_or_tasks() -> None:
    assert Readiness(EMPTY_ROOM, LocalBus(), web=False, video=False).wait(0.0) == ""
