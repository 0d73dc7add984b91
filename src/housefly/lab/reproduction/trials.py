"""Small experiments: a sentence of the paper flown literally, and flown otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.flight_plan import FlightPlan
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.kept_flights import FlyBatch
from housefly.lab.reproduction.routes import (
    hold_plan,
    mapped_site,
    service_plan,
    step_plan,
)
from housefly.lab.reproduction.streams import TYPICAL_LATENCY, TYPICAL_RATE
from housefly.lab.reproduction.trial_list import TRIALS, Trial, TrialKind

_LONG_STEP = 3.0
"""A jump of six cells; it asks for four times the available tilt [m]."""


def trial_flights(seeds: int) -> int:
    """Return how many flights ``fly_trials`` makes."""
    return len(TRIALS) * seeds


def fly_trials(
    site: Site,
    seeds: int,
    on_landed: Progress | None = None,
    changes: Mapping[str, Mapping[str, Any]] | None = None,
    only: tuple[str, ...] = (),
    fly: FlyBatch = fly_many,
) -> dict[str, Outcomes]:
    """Fly every trial with the same drones and return the outcomes by key.

    Args:
        site: whose drone, room and stream are meant.
        seeds: drones a trial.
        on_landed: called with the number of flights that have just ended.
        changes: columns replaced in single trials, by key: what the tests turn to see a verdict
            flip.
        only: keys of the trials to fly; all when empty.
        fly: flies a batch.
    """
    drones = fleet(site, seeds)
    results = {}
    for trial in (trial for trial in TRIALS if not only or trial.key in only):
        here = mapped_site(site, trial.mode)
        columns = {
            "mocap_rate_hz": TYPICAL_RATE,
            "mocap_latency": TYPICAL_LATENCY,
            **drones,
            **trial.columns,
            **(changes or {}).get(trial.key, {}),
        }
        results[trial.key] = fly(
            cases(here.site, seeds, **columns), _mission(trial, here.site), on_progress=on_landed
        )
    return results


def _mission(trial: Trial, site: Site) -> FlightPlan:
    match trial.task:
        case TrialKind.SERVICE:
            return service_plan(mapped_site(site, trial.mode))
        case TrialKind.CELL:
            return step_plan(site)
        case TrialKind.LONG:
            return step_plan(site, _LONG_STEP)
        case TrialKind.HOLD:
            return hold_plan(site)
