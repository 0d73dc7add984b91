"""Flies the chunks of a campaign that are missing, here or on a cluster, and keeps each as it lands."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Protocol

from housefly.campaigns.folder import CampaignFolder
from housefly.campaigns.plan import Chunk, Plan
from housefly.experiments.engine import fly_many
from housefly.experiments.outcomes import Outcomes

Landed = Callable[[int], None]
"""Called with the number of drones that have just landed."""


class Fleet(Protocol):
    """Whoever flies chunks: yields each as it lands, in any order."""

    def fly(self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Landed) -> Iterator[tuple[Chunk, Outcomes]]:
        """Fly the chunks."""
        ...


class LocalFleet:
    """Threads of this process."""

    def __init__(self, threads: int | None = None) -> None:
        self._threads = threads

    def fly(self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Landed) -> Iterator[tuple[Chunk, Outcomes]]:
        """Fly one chunk after the other, each on all threads."""
        for chunk in chunks:
            cases, _ = plan.cases_of(chunk)
            yield chunk, fly_many(cases, plan.legs[chunk.leg].mission, threads=self._threads, on_progress=on_landed)


def run_campaign(
    plan: Plan, missing: tuple[Chunk, ...], folder: CampaignFolder, fleet: Fleet, on_landed: Landed = lambda drones: None
) -> None:
    """Fly the missing chunks; what has landed is kept, whatever happens to the rest."""
    for chunk, outcomes in fleet.fly(plan, missing, on_landed):
        folder.write(chunk, outcomes)
