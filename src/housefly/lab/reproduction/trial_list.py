"""What is flown to judge single sentences of the paper: the trials, by key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from itertools import product
from math import radians
from typing import Any, NamedTuple

from housefly.config.site import Mode
from housefly.lab.reproduction.edges import STILL_AIR, TRACKING_ALWAYS
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES
from housefly.pilot.estimation.estimator_state import EstimatorKind


class TrialKind(Enum):
    """What a trial flies."""

    SERVICE = "service"
    CELL = "step of one cell"
    LONG = "step of six cells"
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


class StepGains(NamedTuple):
    """Gains of eqs. (20)-(21): alpha [1/s], beta [1/s^2], and what they are like."""

    alpha: float
    beta: float
    like: str


LITERAL_EPS2 = radians(0.2)
STEPS = (TrialKind.CELL, TrialKind.LONG)
WELL_DAMPED = StepGains(3.6, 3.24, "well damped")
POORLY_DAMPED = StepGains(2.0, 3.24, "poorly damped")
SWINGING = StepGains(1.5, 4.0, "swinging")
STEP_GAINS = (WELL_DAMPED, POORLY_DAMPED, SWINGING)
SATURATED, FREE = 0.21, 0.5
"""Tilt of the paper's saturation, and one that is hardly ever reached [rad]."""
HEIGHT_GAINS = (-10.0, -5.0, -2.4, -1.2, -0.6, 0.6, 1.2, 2.4, 5.0, 10.0)
"""K2 of u_z = K2 (z - z_ref) with u_z upwards [1/s]; the paper prints neither size nor sign."""


def step_key(kind: TrialKind, gains: StepGains, tilt: float) -> str:
    """Return the key of the step with these gains and this tilt limit [rad]."""
    return f"{kind.value}, {gains.like}, {'saturated' if tilt == SATURATED else 'free'}"


def height_key(gain: float) -> str:
    """Return the key of the hold with this K2 [1/s]."""
    return f"K2 = {gain:g} 1/s"


_NO_DELAYS = {"delay": 0.0, "mocap_latency": 0.0, "mocap_rate_hz": 100.0, "mocap_jitter": 0.0}
_SLOW_LAG = {"lag": 7.0, "alpha": 0.4}
"""With this lag eq. (22) is stable only below beta = 2.8 1/s^2."""

_ALONE = STILL_AIR | TRACKING_ALWAYS

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
        {**_SLOW_LAG, "beta": 1.4, **_NO_DELAYS, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta above lambda alpha",
        TrialKind.CELL,
        {**_SLOW_LAG, "beta": 5.6, **_NO_DELAYS, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta below saturation",
        TrialKind.CELL,
        {"alpha": 3.6, "beta": 3.24, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    Trial(
        "beta above saturation",
        TrialKind.CELL,
        {"alpha": 4.6, "beta": 5.29, **STILL_AIR, **TRACKING_ALWAYS},
    ),
    *(
        Trial(
            step_key(kind, gains, tilt),
            kind,
            {"alpha": gains.alpha, "beta": gains.beta, "tilt_max": tilt} | _ALONE,
        )
        for kind, gains, tilt in product(STEPS, STEP_GAINS, (SATURATED, FREE))
    ),
    *(
        Trial(height_key(gain), TrialKind.HOLD, {"height_gain": -gain}, "default")
        for gain in HEIGHT_GAINS
    ),
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
