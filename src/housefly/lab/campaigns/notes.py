"""Warnings about a campaign that is valid but probably not what its author meant."""

from __future__ import annotations

from itertools import pairwise
from math import dist

from housefly.lab.campaigns.plan import Plan, PlanGroup
from housefly.lab.experiments.flight_plan import SETTLE, Task


def notes(plan: Plan) -> list[str]:
    """Return warnings: paths that no drone can finish in the time given."""
    given = {*plan.spec.fixed, *plan.spec.grid, *plan.spec.draw}
    return [
        note
        for group in plan.groups
        if group.mission.trajectory is not None or "speed" not in given
        for note in _too_short(group)
    ]


def _too_short(group: PlanGroup) -> list[str]:
    mission = group.mission
    length = sum(dist(start, stop) for start, stop in pairwise(mission.waypoints))
    needed = SETTLE + length / group.site.limits.speed
    if mission.trajectory is not None:
        needed = SETTLE + float(mission.trajectory.marks[-1])
    if mission.task is not Task.PATH or needed <= mission.duration:
        return []
    way = f"the {length:.1f} m in mode {group.name} take at least {needed:.0f} s"
    return [f"mission.duration_s is {mission.duration:g} s, but {way}: no drone will arrive"]
