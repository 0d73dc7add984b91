"""Everything measured for the tables and findings."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from housefly.config.site import Site
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction import edges, known_lag, streams, trials
from housefly.lab.reproduction.angular_step import AngularStep
from housefly.lab.reproduction.edges import Edges, find_edges
from housefly.lab.reproduction.equations import Equations, evaluate_equations
from housefly.lab.reproduction.kept_flights import FlyBatch
from housefly.lab.reproduction.known_lag import KnownLag, fly_known_lag
from housefly.lab.reproduction.maps import MapFacts, survey
from housefly.lab.reproduction.streams import Streams, fly_streams
from housefly.lab.reproduction.trials import fly_trials
from housefly.record.summary import Summary

_EDGE_SEEDS = 40
"""Drones for each search of an edge; each gives one edge, so few are enough."""

_Progress = Callable[[float], None]
"""Called with the share of all flights that have ended, 0 to 1."""


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """The measurements behind the findings.

    Attributes:
        site: whose room, drone and gains.
        maps: about map and planner.
        equations: about equations and conditions.
        streams: the service on every stream.
        edges: largest stable frequencies.
        known_lag: the same with lambda known to the filter and unknown.
        trials: small experiments, by key.
        flights: simulated drones in all of these.
        services: whole services flown on the twin, from take-off to landing.
        pitch: a step in pitch on the twin; None when none was flown.
    """

    site: Site
    maps: MapFacts
    equations: Equations
    streams: Streams
    edges: Edges
    known_lag: KnownLag
    trials: Mapping[str, Outcomes]
    flights: int
    services: tuple[Summary, ...] = ()
    pitch: AngularStep | None = None


def gather(
    site: Site,
    seeds: int,
    on_progress: _Progress = lambda share: None,
    changes: Mapping[str, Mapping[str, Any]] | None = None,
    fly: FlyBatch = fly_many,
) -> Evidence:
    """Survey the map and fly everything that needs no twin.

    Args:
        site: whose room, drone and gains; its seed draws the drones.
        seeds: drones for each cell of a table.
        on_progress: called with the share of flights that have ended.
        changes: columns replaced in single trials, by key.
        fly: flies a batch.
    """
    edge_seeds = min(seeds, _EDGE_SEEDS)
    total = (
        streams.stream_flights(seeds)
        + edges.edge_flights(edge_seeds)
        + known_lag.known_lag_flights(edge_seeds)
        + trials.trial_flights(seeds)
    )
    ended = 0

    def landed(more: int) -> None:
        nonlocal ended
        ended += more
        on_progress(ended / total)

    return Evidence(
        site=site,
        maps=survey(site),
        equations=evaluate_equations(site),
        streams=fly_streams(site, seeds, landed, fly=fly),
        edges=find_edges(site, edge_seeds, landed, fly=fly),
        known_lag=fly_known_lag(site, edge_seeds, landed, fly=fly),
        trials=fly_trials(site, seeds, landed, changes, fly=fly),
        flights=total,
    )
