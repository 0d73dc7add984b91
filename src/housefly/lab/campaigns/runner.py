"""Flies the chunks of a campaign that are missing, here or on a cluster, and keeps each as it
lands.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import groupby
from typing import Protocol

import numpy as np

from housefly.lab.campaigns.folder import CampaignFolder
from housefly.lab.campaigns.plan import Chunk, Plan
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.outcomes import Outcomes

TOGETHER = 2000
"""Drones that are flown between two writes on this machine, unless chunks are larger."""
Landed = Callable[[int], None]
"""Called with the number of drones that have just landed."""


class Fleet(Protocol):
    """Whoever flies chunks: yields each as it lands, in any order."""

    def fly(
        self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Landed
    ) -> Iterator[tuple[Chunk, Outcomes]]:
        """Fly the chunks."""
        ...


class LocalFleet:
    """Threads of this process."""

    def __init__(self, threads: int | None = None) -> None:
        self._threads = threads

    def fly(
        self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Landed
    ) -> Iterator[tuple[Chunk, Outcomes]]:
        """Fly some chunks at a time on all threads: every thread waits for the last drone only once
        for all of them.
        """
        for together in _batches(chunks):
            cases = np.concatenate([plan.cases_of(chunk)[0] for chunk in together])
            outcomes = fly_many(
                cases,
                plan.legs[together[0].leg].mission,
                threads=self._threads,
                on_progress=on_landed,
            )
            ends = np.cumsum([chunk.drones for chunk in together])
            yield from zip(together, np.split(outcomes, ends[:-1]), strict=True)


def _batches(chunks: tuple[Chunk, ...]) -> Iterator[tuple[Chunk, ...]]:
    """Yield chunks of one leg together, as many as ``TOGETHER`` allows, at least one."""
    for _, own in groupby(chunks, key=lambda chunk: chunk.leg):
        of_leg = list(own)
        size = max(TOGETHER // of_leg[0].drones, 1)
        for first in range(0, len(of_leg), size):
            yield tuple(of_leg[first : first + size])


def run_campaign(
    plan: Plan,
    missing: tuple[Chunk, ...],
    folder: CampaignFolder,
    fleet: Fleet,
    on_landed: Landed = lambda drones: None,
) -> None:
    """Fly the missing chunks; what has landed is kept, whatever happens to the rest."""
    for chunk, outcomes in fleet.fly(plan, missing, on_landed):
        folder.write(chunk, outcomes)
