"""What one rule of the last gate is."""

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


class Counting(Enum):
    """When a rule counts."""

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
        now: what is known in this step.
        seen: what the flight has shown so far.
        limits: of the site.
        fence: of the room.
        airframe: of the drone.
    """

    now: GateInputs
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
        counts: when it counts.
        condition: what is wrong, for the documentation.
        broken: whether it is wrong now, where it counts.
        words: for people, with value and limit.
        after: it counts once it was wrong for this long [s].
        lasts: it goes on counting for this long [s].
        clears: what ends the answer; it says so to people, and a test holds the gate to it.
        steered: the pilot may steer the hold or the landing: what is wrong is not what it knows,
            and not how the drone obeys.
        waits: the landing may wait for the floor below to be clear: the drone's own motion is not
            what is wrong.
        needs: what the drone has to have for it; with one that lacks it the rule does not count ...
        instead: ... and this stands in for it, for the documentation.
    """

    code: EventCode
    mode: SafetyMode
    counts: Counting
    condition: str
    broken: Callable[[RuleContext], bool]
    words: Callable[[RuleContext], Words]
    after: float = 0.0
    lasts: float = 0.0
    clears: Clearing = Clearing.ITSELF
    steered: bool = False
    waits: bool = False
    needs: frozenset[Ability] = frozenset()
    instead: str = ""


COUNTED: dict[Counting, Callable[[RuleContext], bool]] = {
    Counting.ALWAYS: lambda _: True,
    Counting.AIRBORNE: lambda c: c.now.airborne,
    Counting.FLYING: lambda c: c.now.status is DroneStatus.FLYING,
    Counting.CRUISE: lambda c: c.now.cruising,
    Counting.LANDING: lambda c: c.now.airborne and c.seen.landing_for > 0.0,
    Counting.GROUND: lambda c: c.now.status is DroneStatus.LANDED,
}
