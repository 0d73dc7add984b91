"""Small experiments, one for each reading of a sentence of the paper: fly it so, and fly it
otherwise.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from math import radians
from typing import Any

from housefly.config.site import Mode, Site
from housefly.lab.experiments.cases import FINITE_DIFFERENCE, cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.mission import Mission
from housefly.lab.experiments.outcomes import Outcomes
from housefly.lab.reproduction.edges import TRACKING_ALWAYS
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.routes import CELL, hold, premises, service, step
from housefly.lab.reproduction.streams import TYPICAL_LATENCY, TYPICAL_RATE, Landed
from housefly.pilot.behavior.acceptor import PAPER_EPSILONS

LONG_STEP = 3.0
"""A jump that asks for four times the tilt that there is [m]."""
FIVE_CELLS = 5.0 * CELL


class Task(Enum):
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
    task: Task
    columns: Mapping[str, Any] = field(default_factory=dict)
    mode: Mode = "paper"


NO_DELAYS = {"delay": 0.0, "mocap_latency": 0.0, "mocap_rate_hz": 100.0, "mocap_jitter": 0.0}
STILL_AIR = {"gust": 0.0, "wind_x": 0.0, "wind_y": 0.0}
SLOW_LAG = {"lag": 7.0, "alpha": 0.4}
"""Here eq. (22) is stable only below beta = 2.8 1/s^2."""

TRIALS: tuple[Trial, ...] = (
    Trial("as printed", Task.SERVICE),
    Trial("eps2 0.2 rad", Task.SERVICE, {"epsilon_yaw": 0.2}),
    Trial("always tracking", Task.SERVICE, {"epsilon_height": 2.0, "epsilon_yaw": 3.2}),
    Trial("no wrap", Task.SERVICE, {"wrap_yaw": 0.0}),
    Trial("eps3 0.25 m", Task.SERVICE, {"epsilon_yaw": 0.2, "epsilon_position": 0.25}),
    Trial("eps3 0.4 m", Task.SERVICE, {"epsilon_yaw": 0.2, "epsilon_position": PAPER_EPSILONS[2]}),
    Trial("eps3 1 m", Task.SERVICE, {"epsilon_yaw": 0.2, "epsilon_position": 1.0}),
    Trial("literal gain signs", Task.CELL, {"alpha": -3.6, "beta": -3.24, **TRACKING_ALWAYS}),
    Trial("positive gains", Task.CELL, TRACKING_ALWAYS),
    Trial(
        "beta below lambda alpha",
        Task.CELL,
        {**SLOW_LAG, "beta": 1.4, **NO_DELAYS, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta above lambda alpha",
        Task.CELL,
        {**SLOW_LAG, "beta": 5.6, **NO_DELAYS, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta below saturation",
        Task.CELL,
        {"alpha": 3.6, "beta": 3.24, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta above saturation",
        Task.CELL,
        {"alpha": 4.6, "beta": 5.29, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial("long step, saturated", Task.LONG, {"tilt_max": 0.21, **STILL_AIR, **TRACKING_ALWAYS}),
    Trial("long step, free", Task.LONG, {"tilt_max": 0.5, **STILL_AIR, **TRACKING_ALWAYS}),
    Trial("literal height sign", Task.HOLD, {"height_gain": -1.2}, "default"),
    Trial("positive height gain", Task.HOLD, {}, "default"),
    Trial("hover", Task.HOLD),
    Trial("unfiltered", Task.SERVICE, {"estimator": FINITE_DIFFERENCE, "mocap_noise": 0.005}),
    Trial("filtered", Task.SERVICE, {"mocap_noise": 0.005}),
    Trial("lag known", Task.SERVICE, {}, "default"),
    Trial("lag unknown", Task.SERVICE, {"model_lag": 50.0}, "default"),
)
LITERAL_EPS2 = radians(0.2)


def flights(seeds: int) -> int:
    """Return how many flights ``fly_trials`` makes."""
    return len(TRIALS) * seeds


def fly_trials(
    site: Site,
    seeds: int,
    on_landed: Landed | None = None,
    changes: Mapping[str, Mapping[str, Any]] | None = None,
    only: tuple[str, ...] = (),
) -> dict[str, Outcomes]:
    """Fly every trial with the same drones and return the outcomes by key.

    Args:
        site: whose drone, room and stream are meant.
        seeds: drones a trial.
        on_landed: told of flights that have ended.
        changes: columns replaced in single trials, by key: what the tests turn to see a verdict
            flip.
        only: keys of the trials to fly; all when empty.
    """
    drones = fleet(site, seeds)
    results = {}
    for trial in (trial for trial in TRIALS if not only or trial.key in only):
        here = premises(site, trial.mode)
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


def _mission(trial: Trial, site: Site) -> Mission:
    match trial.task:
        case Task.SERVICE:
            return service(premises(site, trial.mode))
        case Task.CELL:
            return step(site)
        case Task.LONG:
            return step(site, LONG_STEP)
        case Task.HOLD:
            return hold(site)
