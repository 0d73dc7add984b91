"""When in a flight a fault begins."""

from __future__ import annotations

from enum import Enum
from math import hypot

from housefly.messages import Phase, PilotStep

_NEAR_CORNER = 1.0
"""This far before a waypoint the corner begins [m]."""
_CRUISE_SPEED = 0.25
"""Faster than this the drone cruises [m/s]."""


class FaultPhase(Enum):
    """A moment of a service at which a fault begins."""

    FROM_START = "from the start"
    BEFORE_TAKE_OFF = "before take-off"
    CLIMB = "climb"
    TURN = "turn"
    CRUISE = "cruise"
    CORNER = "before a corner"
    LOOK = "hover"
    RETURN = "way home"
    LANDING = "landing"


GROUND_FAULT_PHASES = (FaultPhase.FROM_START, FaultPhase.BEFORE_TAKE_OFF)
"""A fault that is there from the start is there before the pilot's first step."""
IN_FLIGHT_FAULT_PHASES = tuple(phase for phase in FaultPhase if phase not in GROUND_FAULT_PHASES)


def has_begun(phase: FaultPhase, step: PilotStep) -> bool:
    """Return whether a flight has come to a phase with this step."""
    outputs = step.outputs
    flying = outputs.phase is Phase.OUTBOUND
    match phase:
        case FaultPhase.FROM_START | FaultPhase.BEFORE_TAKE_OFF:
            return True
        case FaultPhase.CLIMB:
            return outputs.phase is Phase.TAKING_OFF and _height(step) > 0.3
        case FaultPhase.TURN:
            return flying
        case FaultPhase.CRUISE:
            return flying and _speed(step) > _CRUISE_SPEED
        case FaultPhase.CORNER:
            return flying and _speed(step) > _CRUISE_SPEED and _to_waypoint(step) < _NEAR_CORNER
        case FaultPhase.LOOK:
            return outputs.phase is Phase.LOOKING
        case FaultPhase.RETURN:
            return outputs.phase is Phase.RETURNING and _speed(step) > _CRUISE_SPEED
        case FaultPhase.LANDING:
            return outputs.phase is Phase.LANDING


def _height(step: PilotStep) -> float:
    return step.outputs.estimate.position[2] if step.outputs.estimate else 0.0


def _speed(step: PilotStep) -> float:
    return hypot(*step.outputs.estimate.velocity[:2]) if step.outputs.estimate else 0.0


def _to_waypoint(step: PilotStep) -> float:
    outputs = step.outputs
    if outputs.estimate is None or outputs.path is None:
        return float("inf")
    (x, y, _), (wx, wy) = outputs.estimate.position, outputs.path.waypoints[outputs.waypoint]
    return hypot(wx - x, wy - y)
