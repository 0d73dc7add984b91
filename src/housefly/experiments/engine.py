"""Flies many drones at once: threads over a compiled loop that holds no lock."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

from housefly.experiments.cases import Cases
from housefly.experiments.mission import Mission
from housefly.experiments.outcomes import Outcomes

Progress = Callable[[int], None]
"""Called with the number of drones that have just landed."""


def fly_many(cases: Cases, mission: Mission, *, threads: int | None = None, on_progress: Progress | None = None) -> Outcomes:
    """Fly every case on its own and return one row each, in order.

    A drone's result depends on its own row alone: not on the others, the number of threads, or the order.
    """
    raise NotImplementedError


def fly_traced(cases: Cases, mission: Mission) -> NDArray[Any]:
    """Fly the first case and return every tick as a structured array (see ``trace.TRACE``)."""
    raise NotImplementedError
