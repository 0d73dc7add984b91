"""Small experiments: a sentence of the paper flown literally, and flown otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from math import radians
from typing import Any

from housefly.config.site import Mode, Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.flight_plan import FlightPlan
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction.edges import TRACKING_ALWAYS
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.routes import (
    hold_plan,
    mapped_site,
    service_plan,
    step_plan,
)
from housefly.lab.reproduction.streams import TYPICAL_LATENCY, TYPICAL_RATE
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES
from housefly.pilot.estimation.estimator import EstimatorKind

_LONG_STEP = 3.0
"""A jump that asks for four times the available tilt [m]."""


class TrialKind(Enum):
    """What a trial flies."""

    SERVICE = "service"
    CELL = "one cell"
    LONG = "long step"
    HOLD = "hold"


@dataclass(frozen=True, slots=True)
class Trial:
    """One experiment.

    Attributes:
        key: short name.
        task: what is flown.
        columns: what differs from the site in the mode.
        mode: of the site.
    """

    key: str
    task: TrialKind
    columns: Mapping[str, Any] = field(default_factory=dict)
    mode: Mode = "paper"


_NO_DELAYS = {"delay": 0.0, "mocap_latency": 0.0, "mocap_rate_hz": 100.0, "mocap_jitter": 0.0}
_STILL_AIR = {"gust": 0.0, "wind_x": 0.0, "wind_y": 0.0}
_SLOW_LAG = {"lag": 7.0, "alpha": 0.4}
"""With this lag eq. (22) is stable only below beta = 2.8 1/s^2."""

TRIALS: tuple[Trial, ...] = (
    Trial("as printed", TrialKind.SERVICE),
    Trial("eps2 0.2 rad", TrialKind.SERVICE, {"epsilon_yaw": 0.2}),
    Trial("always tracking", TrialKind.SERVICE, {"epsilon_height": 2.0, "epsilon_yaw": 3.2}),
    Trial("no wrap", TrialKind.SERVICE, {"wrap_yaw": 0.0}),
    Trial("eps3 0.25 m", TrialKind.SERVICE, {"epsilon_yaw": 0.2, "epsilon_position": 0.25}),
    Trial(
        "eps3 0.4 m",
        TrialKind.SERVICE,
        {"epsilon_yaw": 0.2, "epsilon_position": PAPER_TOLERANCES.position},
    ),
    Trial("eps3 1 m", TrialKind.SERVICE, {"epsilon_yaw": 0.2, "epsilon_position": 1.0}),
    Trial("literal gain signs", TrialKind.CELL, {"alpha": -3.6, "beta": -3.24, **TRACKING_ALWAYS}),
    Trial("positive gains", TrialKind.CELL, TRACKING_ALWAYS),
    Trial(
        "beta below lambda alpha",
        TrialKind.CELL,
        {**_SLOW_LAG, "beta": 1.4, **_NO_DELAYS, **_STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta above lambda alpha",
        TrialKind.CELL,
        {**_SLOW_LAG, "beta": 5.6, **_NO_DELAYS, **_STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta below saturation",
        TrialKind.CELL,
        {"alpha": 3.6, "beta": 3.24, **_STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta above saturation",
        TrialKind.CELL,
        {"alpha": 4.6, "beta": 5.29, **_STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "long step, saturated", TrialKind.LONG, {"tilt_max": 0.21, **_STILL_AIR, **TRACKING_ALWAYS}
    ),
    Trial("long step, free", TrialKind.LONG, {"tilt_max": 0.5, **_STILL_AIR, **TRACKING_ALWAYS}),
    Trial("literal height sign", TrialKind.HOLD, {"height_gain": -1.2}, "default"),
    Trial("positive height gain", TrialKind.HOLD, {}, "default"),
    Trial("hover", TrialKind.HOLD),
    Trial(
        "unfiltered",
        TrialKind.SERVICE,
        {"estimator": EstimatorKind.FINITE_DIFFERENCE, "mocap_noise": 0.005},
    ),
    Trial("filtered", TrialKind.SERVICE, {"mocap_noise": 0.005}),
    Trial("lag known", TrialKind.SERVICE, {}, "default"),
    Trial("lag unknown", TrialKind.SERVICE, {"model_lag": 50.0}, "default"),
)
LITERAL_EPS2 = radians(0.2)


def trial_flights(seeds: int) -> int:
    """Return how many flights ``fly_trials`` makes."""
    return len(TRIALS) * seeds


def fly_trials(
    site: Site,
    seeds: int,
    on_landed: Progress | None = None,
    changes: Mapping[str, Mapping[str, Any]] | None = None,
    only: tuple[str, ...] = (),
) -> dict[str, Outcomes]:
    """Fly every trial with the same drones and return the outcomes by key.

    Args:
        site: whose drone, room and stream are meant.
        seeds: drones a trial.
        on_landed: called with the number of flights that have just ended.
        changes: columns replaced in single trials, by key: what the tests turn to see a verdict
            flip.
        only: keys of the trials to fly; all when empty.
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
        results[trial.key] = fly_many(
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
