"""Whoever waits for the compiler hears where it is."""

from __future__ import annotations

import pytest

from housefly.app import compiling
from housefly.app.compiling import _Progress


def test_a_long_compilation_says_every_few_seconds_which_function_it_is_at(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    now, said = [100.0], list[str]()
    monkeypatch.setattr(compiling.time, "monotonic", lambda: now[0])
    progress = _Progress(said.append)
    for number in range(8):
        now[0] = 100.0 + number
        progress.begin(f"housefly.pilot.f{number}")
    assert said == ["compiling pilot.f3 (function 4)", "compiling pilot.f6 (function 7)"]
