"""Fly a campaign's missing chunks, here or on a cluster, and store each as it lands."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import Protocol

import numpy as np

from housefly.lab.campaigns.folder import CampaignFolder
from housefly.lab.campaigns.plan import Chunk, Plan
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.outcomes import Outcomes

_DRONES_PER_WRITE = 2000
"""Drones flown between two writes on this machine, unless chunks are larger."""


class Fleet(Protocol):
    """Something that flies chunks and yields each as it lands, in any order."""

    def fly(
        self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Progress
    ) -> Iterator[tuple[Chunk, Outcomes]]:
        """Fly the chunks."""
        ...


class LocalFleet:
    """Threads of this process."""

    def __init__(self, threads: int | None = None) -> None:
        self._threads = threads

    def fly(
        self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Progress
    ) -> Iterator[tuple[Chunk, Outcomes]]:
        """Fly several chunks at once on all threads, so that stragglers are waited for once."""
        for together in _batches(chunks):
            cases = np.concatenate([plan.cases_of(chunk)[0] for chunk in together])
            outcomes = fly_many(
                cases,
                plan.groups[together[0].group].mission,
                threads=self._threads,
                on_progress=on_landed,
            )
            ends = np.cumsum([chunk.drones for chunk in together])
            yield from zip(together, np.split(outcomes, ends[:-1]), strict=True)


def _batches(chunks: tuple[Chunk, ...]) -> Iterator[tuple[Chunk, ...]]:
    """Yield batches of chunks of one group: up to ``_DRONES_PER_WRITE`` drones, or one chunk."""
    for _, own in groupby(chunks, key=lambda chunk: chunk.group):
        of_group = list(own)
        size = max(_DRONES_PER_WRITE // of_group[0].drones, 1)
        for first in range(0, len(of_group), size):
            yield tuple(of_group[first : first + size])


def fly_chunks(
    plan: Plan,
    missing: tuple[Chunk, ...],
    folder: CampaignFolder,
    fleet: Fleet,
    on_landed: Progress = lambda drones: None,
) -> None:
    """Fly the missing chunks; results that have landed are kept whatever happens to the rest."""
    for chunk, outcomes in fleet.fly(plan, missing, on_landed):
        folder.write(chunk, outcomes)
