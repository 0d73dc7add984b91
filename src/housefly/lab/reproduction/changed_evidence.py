"""Evidence from a changed world: another drone, room, stream, gain or air, flown anew."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from housefly.config.site import Mode, changed
from housefly.geometry import Vec2
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.reproduction.angular_step import simulated_step
from housefly.lab.reproduction.edges import find_edges
from housefly.lab.reproduction.equations import evaluate_equations
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.known_lag import fly_known_lag
from housefly.lab.reproduction.maps import compared_with_scipy, map_facts, survey
from housefly.lab.reproduction.routes import MappedSite, mapped_site, service_plan
from housefly.lab.reproduction.streams import (
    OWN_FREQUENCY,
    TYPICAL_LATENCY,
    TYPICAL_LOSS,
    TYPICAL_RATE,
    Streams,
)
from housefly.lab.reproduction.trials import fly_trials
from housefly.lab.reproduction.unexpected import put_unexpected
from housefly.room.grid import Cell, build_grid
from housefly.room.model import BUILDING_PARTS, Place, Room

Change = Callable[[Evidence], Evidence]
"""Returns the evidence with what a claim rests on measured in a changed world."""
_DRONES = 4
"""Drones for a search of edges: there are thousands of flights to each."""
_AHEAD = 3.0
"""Length of the way in the room in which all places lie on one line [m]."""


def trials(*keys: str, **columns: Any) -> Change:
    """Fly trials with other columns."""

    def change(evidence: Evidence) -> Evidence:
        drones = len(evidence.trials[keys[0]])
        changes = dict.fromkeys(keys, columns)
        flown = fly_trials(evidence.site, drones, changes=changes, only=keys)
        return replace(evidence, trials={**evidence.trials, **flown})

    return change


def edges(**columns: Any) -> Change:
    """Search the edges with other columns."""
    return lambda evidence: replace(evidence, edges=find_edges(evidence.site, _DRONES, **columns))


def known_lag(**keys: Any) -> Change:
    """Fly with lambda known and unknown for another site."""

    def change(evidence: Evidence) -> Evidence:
        return replace(evidence, known_lag=fly_known_lag(changed(evidence.site, **keys), _DRONES))

    return change


def service(**columns: Any) -> Change:
    """Fly the paper's service on the typical stream with other columns."""

    def change(evidence: Evidence) -> Evidence:
        here = mapped_site(evidence.site, "paper")
        stream: Mapping[str, Any] = {
            "mocap_rate_hz": TYPICAL_RATE,
            "mocap_latency": TYPICAL_LATENCY,
            "mocap_dropout": TYPICAL_LOSS,
        }
        drones = fleet(here.site, _DRONES)
        table = cases(here.site, _DRONES, **{**drones, **stream, **columns})
        flown = fly_many(table, service_plan(here))
        streams = Streams(table, flown, np.full(len(table), OWN_FREQUENCY))
        return replace(evidence, streams=streams, services=())

    return change


def equations(keys: Mapping[str, Any] | None = None, **formulas: Any) -> Change:
    """Evaluate the equations for another site, or with another formula in the printed one's place.

    Args:
        keys: of the site.
        formulas: arguments of ``evaluate_equations``.
    """

    def change(evidence: Evidence) -> Evidence:
        site = changed(evidence.site, **(keys or {}))
        return replace(evidence, site=site, equations=evaluate_equations(site, **formulas))

    return change


def other_site(**keys: Any) -> Change:
    """Survey the map of another site."""
    return lambda evidence: replace(evidence, maps=survey(changed(evidence.site, **keys)))


def other_cells(**keys: Any) -> Change:
    """Map the room with other keys and count the cells of the paper's grid."""

    def change(evidence: Evidence) -> Evidence:
        here = mapped_site(changed(evidence.site, **keys), "paper")
        return replace(evidence, maps=replace(evidence.maps, cells=here.grid.shape))

    return change


def other_obstacles(seen: bool = True, **keys: Any) -> Change:
    """Put the unexpected obstacles into the room of another site.

    Args:
        seen: whether the map is updated with them.
        keys: of the site.
    """

    def change(evidence: Evidence) -> Evidence:
        here = mapped_site(changed(evidence.site, **keys), "default")
        found = put_unexpected(here, seen=seen)
        return replace(evidence, maps=replace(evidence.maps, unexpected=found))

    return change


def other_room(rebuilt: Callable[[Room], Room]) -> Change:
    """Survey a rebuilt room, without what was drawn by hand for the present one."""

    def change(evidence: Evidence) -> Evidence:
        bare = changed(evidence.site, map__paper_virtual_obstacles=())
        paper, default = (_rebuilt(mapped_site(bare, mode), rebuilt) for mode in _MODES)
        return replace(evidence, maps=map_facts(paper, default))

    return change


_MODES: tuple[Mode, Mode] = ("paper", "default")


def unfurnished(room: Room) -> Room:
    """Return the room with nothing but its walls, doors and windows."""
    return replace(room, solids=tuple(s for s in room.solids if s.thing in BUILDING_PARTS))


def on_one_line(room: Room) -> Room:
    """Return the unfurnished room with the entrance straight ahead of the pad."""
    x, y = room.home
    ahead: Vec2 = (x - _AHEAD, y)
    places = (room.place("home"), Place("entrance", ahead, (*ahead, 1.0)))
    return replace(unfurnished(room), places=places)


def misled_planner(evidence: Evidence) -> Evidence:
    """Let the planner believe that one free cell is blocked."""
    free = mapped_site(evidence.site, "paper").grid.cells == Cell.FREE
    believed = free.copy()
    believed[tuple(np.argwhere(free)[len(np.argwhere(free)) // 2])] = False
    pairs, wrong = compared_with_scipy(free, believed)
    return replace(evidence, maps=replace(evidence.maps, pairs=pairs, wrong=wrong))


def pitch(delay: float) -> Change:
    """Let a drone with the site's lambda and this pure delay [s] answer the step of Fig. 11."""
    return lambda evidence: replace(
        evidence, pitch=simulated_step(evidence.site.drone.attitude_lag, delay)
    )


def both(first: Change, second: Change) -> Change:
    """Return one change after the other."""
    return lambda evidence: second(first(evidence))


def _rebuilt(here: MappedSite, rebuilt: Callable[[Room], Room]) -> MappedSite:
    room = rebuilt(here.room)
    return MappedSite(here.site, room, build_grid(room, here.site))
