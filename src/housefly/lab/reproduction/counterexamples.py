"""What would change our mind: for each verdict a world in which it is another one.

Every entry flies, maps or evaluates anew; none puts a number into the place of a measurement.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

from housefly.lab.reproduction import changed_evidence as changes
from housefly.lab.reproduction.changed_evidence import Change
from housefly.lab.reproduction.claims import CLAIMS
from housefly.lab.reproduction.edges import STILL_AIR
from housefly.lab.reproduction.equations import PAPER_HEADINGS, WEIGHT
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import ClaimFinding, CounterFinding
from housefly.lab.reproduction.ruling import Claim
from housefly.lab.reproduction.trial_list import (
    FREE,
    HEIGHT_GAINS,
    SATURATED,
    STEP_GAINS,
    STEPS,
    height_key,
    step_key,
)
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES, AcceptorState, steady_conditions


class Counterexample(NamedTuple):
    """A world in which a verdict is another one: what differs there, and how it is measured."""

    changed: str
    change: Change


_TRACKING = {"epsilon_height": 2.0, "epsilon_yaw": 3.2}
_STEP_KEYS = tuple(
    step_key(kind, gains, tilt)
    for kind in STEPS
    for gains in STEP_GAINS
    for tilt in (SATURATED, FREE)
)
_HEIGHT_KEYS = tuple(height_key(gain) for gain in HEIGHT_GAINS)


def _mended(height: float, yaw: float, place: float) -> int:
    eps = PAPER_TOLERANCES[:3]
    return int(steady_conditions(AcceptorState.HOVER.value, height, yaw, place, *eps))


def _ungated(height: float, yaw: float, place: float) -> int:
    """Return the bits of q1 and q2 where q2 does not ask for the height."""
    eps1, eps2, _ = PAPER_TOLERANCES[:3]
    return (abs(height) > eps1) + 2 * (abs(yaw) > eps2)


COUNTEREXAMPLES: dict[str, Counterexample] = {
    "immediate answer": Counterexample(
        "a drone that itself answers a command only after 0.4 s", changes.edges(delay=0.4)
    ),
    "low frame rate": Counterexample(
        "a drone without delay whose angles follow three times as fast, and a filter that believes"
        " nothing but its frames",
        changes.edges(delay=0.0, lag=20.0, acceleration_noise=50.0),
    ),
    "speed commands": Counterexample(
        "a drone with slow angles (lambda 0.5 1/s) in thick air (drag 5 1/s)",
        changes.equations({"drone__attitude_lag": 0.5, "drone__drag": 5.0, "control__beta": 1.0}),
    ),
    "plane": Counterexample("the room without furniture", changes.other_room(changes.unfurnished)),
    "resolution": Counterexample(
        "a drone with a hull of 0.30 x 0.25 m",
        changes.other_site(drone__hull_length=0.3, drone__hull_width=0.25),
    ),
    "virtual obstacles": Counterexample(
        "a drone with a hull of 0.30 x 0.25 m in still air that never stops tracking",
        changes.both(
            changes.other_site(drone__hull_length=0.3, drone__hull_width=0.25),
            changes.trials("as printed", **STILL_AIR, **_TRACKING),
        ),
    ),
    "labels": Counterexample(
        "a grid over another part of the room, 8.5 x 7.5 m",
        changes.other_cells(map__paper_rectangle=(2.3, 0.25, 10.8, 7.75)),
    ),
    "shortest path": Counterexample(
        "a planner that takes one free cell for blocked", changes.misled_planner
    ),
    "four movements": Counterexample(
        "a room whose places lie on one line", changes.other_room(changes.on_one_line)
    ),
    "equations of motion": Counterexample(
        "f_g printed as (0, 0, m g)", changes.equations(weight=WEIGHT)
    ),
    "planar dynamics": Counterexample(
        "a drone that never turns elsewhere than to 0 and pi",
        changes.equations(headings=PAPER_HEADINGS),
    ),
    "two directions": Counterexample(
        "a room whose places lie on one line", changes.other_room(changes.on_one_line)
    ),
    "yaw law": Counterexample(
        "the law flown with the difference of angles wrapped",
        changes.trials("no wrap", wrap_yaw=1.0),
    ),
    "height law": Counterexample(
        "tracking without noise, so that nothing ever moves the drone off its height",
        changes.trials(*_HEIGHT_KEYS, mocap_noise=0.0),
    ),
    "fewer degrees of freedom": Counterexample(
        "tolerances so wide that path tracking is never left",
        changes.trials("as printed", **_TRACKING),
    ),
    "q2 after q1": Counterexample(
        "a q2 that does not ask for the height", changes.equations(conditions=_ungated)
    ),
    "execution order": Counterexample(
        "conditions that exclude each other, as mode default has them",
        changes.equations(conditions=_mended),
    ),
    "eps2": Counterexample(
        "eps2 of 0.2 rad in place of 0.2 deg", changes.trials("as printed", epsilon_yaw=0.2)
    ),
    "eps3 below a cell": Counterexample(
        "eps3 of 1 m in place of 0.4 m", changes.trials("eps3 0.4 m", epsilon_position=1.0)
    ),
    "eps3 of a metre": Counterexample(
        "eps3 of 0.15 m in place of 1 m", changes.trials("eps3 1 m", epsilon_position=0.15)
    ),
    "hover": Counterexample("still air", changes.trials("hover", **STILL_AIR)),
    "feedback linearization": Counterexample(
        "a drone whose angles follow seven times as fast (lambda 50 1/s)",
        changes.equations({"drone__attitude_lag": 50.0}),
    ),
    "eigenvalues": Counterexample(
        "alpha and beta flown with the other sign",
        changes.trials("literal gain signs", alpha=3.6, beta=3.24),
    ),
    "choice of gains": Counterexample(
        "beta of 3.24 1/s^2 in place of 5.29",
        changes.trials("beta above saturation", alpha=3.6, beta=3.24),
    ),
    "saturation": Counterexample(
        "air so thick (drag 5 1/s) that nothing overshoots",
        changes.trials(*_STEP_KEYS, drag=5.0),
    ),
    "first order": Counterexample("a drone that answers without delay", changes.pitch(0.0)),
    "identification": Counterexample("a drone that answers without delay", changes.pitch(0.0)),
    "independent loops": Counterexample(
        "beta of 1.4 1/s^2 in place of 5.6", changes.trials("beta above lambda alpha", beta=1.4)
    ),
    "use of (c, lambda)": Counterexample(
        "a drone whose angles are reached at once (lambda 50 1/s)",
        changes.known_lag(drone__attitude_lag=50.0),
    ),
    "estimation is required": Counterexample(
        "tracking with 1 cm of noise, ten times ours", changes.edges(mocap_noise=0.01)
    ),
    "Kalman filter": Counterexample(
        "a delay-compensated filter that is told a wrong command delay, 0.5 s",
        changes.edges(model_delay=0.5),
    ),
    "service": Counterexample(
        "a steady draught across the room that pushes with 0.6 m/s^2", changes.service(wind_y=0.6)
    ),
    "static map": Counterexample(
        "a drone that flies at 2 m, over everybody's head",
        changes.other_obstacles(map__flight_height=2.0),
    ),
    "dynamic map": Counterexample(
        "obstacles that the room's sensors do not see, as glass",
        changes.other_obstacles(seen=False),
    ),
}
"""By the key of the claim."""


def judged_elsewhere(
    found: tuple[ClaimFinding, ...],
    evidence: Evidence,
    on_judged: Callable[[], None] = lambda: None,
) -> tuple[ClaimFinding, ...]:
    """Return the findings with those of their counter-worlds, measured now.

    Args:
        found: in this world.
        evidence: of this world.
        on_judged: called after each counter-world.
    """
    claims = {claim.key: claim for claim in CLAIMS}
    judged = []
    for finding in found:
        world = COUNTEREXAMPLES.get(finding.key)
        if world is not None:
            elsewhere = counter_finding(claims[finding.key], world, evidence)
            finding = replace(finding, elsewhere=elsewhere)
            on_judged()
        judged.append(finding)
    return tuple(judged)


def counter_finding(claim: Claim, world: Counterexample, evidence: Evidence) -> CounterFinding:
    """Return the finding on a claim in a counter-world."""
    verdict, text, _ = claim.judge(world.change(evidence))
    return CounterFinding(world.changed, verdict, text)
