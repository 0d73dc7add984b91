"""What one rule of the safety gate is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

from housefly.config.airframe import Ability, Airframe
from housefly.config.limits import LimitsConfig
from housefly.messages.event_code import EventCode
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import Clearing, SafetyMode
from housefly.messages.words import Words
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.observer import FlightObservations


class RuleScope(Enum):
    """In which part of a flight a rule counts."""

    ALWAYS = "always"
    AIRBORNE = "in the air"
    FLYING = "flying"
    CRUISE = "flying, not landing"
    LANDING = "told to land"
    GROUND = "on the ground"


@dataclass(frozen=True, slots=True)
class RuleContext:
    """What a rule may look at.

    Attributes:
        inputs: what is known in this step.
        seen: what the flight has shown so far.
        limits: of the site.
        fence: of the room.
        airframe: of the drone.
    """

    inputs: GateInputs
    seen: FlightObservations
    limits: LimitsConfig
    fence: Geofence
    airframe: Airframe


@dataclass(frozen=True, slots=True)
class SafetyRule:
    """One thing that may be wrong.

    Attributes:
        code: of its events.
        mode: what is done about it.
        scope: in which part of a flight it counts.
        condition: what is wrong, for the documentation.
        is_broken: whether it is wrong now, where it counts.
        words: for people, with value and limit.
        debounce: it counts once it was wrong for this long [s].
        lasts: it goes on counting for this long [s].
        clears: what ends the answer; it says so to people, and a test holds the gate to it.
        may_steer: the pilot may steer the hold or the landing: what is wrong is not what it knows,
            and not how the drone obeys.
        may_wait: the landing may wait for the floor below to be clear: the drone's own motion is
            not what is wrong.
        needs: what the drone has to have for it; with one that lacks it the rule does not count ...
        instead: ... and this stands in for it, for the documentation.
    """

    code: EventCode
    mode: SafetyMode
    scope: RuleScope
    condition: str
    is_broken: Callable[[RuleContext], bool]
    words: Callable[[RuleContext], Words]
    debounce: float = 0.0
    lasts: float = 0.0
    clears: Clearing = Clearing.ITSELF
    may_steer: bool = False
    may_wait: bool = False
    needs: frozenset[Ability] = frozenset()
    instead: str = ""


IN_SCOPE: dict[RuleScope, Callable[[RuleContext], bool]] = {
    RuleScope.ALWAYS: lambda _: True,
    RuleScope.AIRBORNE: lambda c: c.inputs.airborne,
    RuleScope.FLYING: lambda c: c.inputs.status is DroneStatus.FLYING,
    RuleScope.CRUISE: lambda c: c.inputs.cruising,
    RuleScope.LANDING: lambda c: c.inputs.airborne and c.seen.landing_for > 0.0,
    RuleScope.GROUND: lambda c: c.inputs.status is DroneStatus.LANDED,
}
