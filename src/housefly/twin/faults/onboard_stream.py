"""What the drone's reports say when they lie; its firmware flies by what is true."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import nan

from housefly.geometry import wrap_angle
from housefly.twin.contracts import OnboardState
from housefly.twin.faults.fault import Fault, FaultSchedule
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind


class OnboardStream:
    """The content of the drone's reports."""

    def __init__(self) -> None:
        self._frozen: dict[Fault, OnboardState] = {}

    def reported(self, true: OnboardState, schedule: FaultSchedule) -> OnboardState:
        """Return what is reported of a true state, by the faults at its time."""
        for fault in schedule.active(true.at):
            if (fault.component, fault.kind) == (FaultComponent.TELEMETRY, FaultKind.STUCK):
                true = replace(self._frozen.setdefault(fault, true), at=true.at)
            lie = _LIES.get((fault.component, fault.kind, fault.aspect))
            true = true if lie is None else lie(fault, true)
        return true


def _faster(fault: Fault, state: OnboardState) -> OnboardState:
    forward, left, up = state.velocity
    return replace(state, velocity=(forward + fault.size, left, up))


_TELEMETRY, _WRONG = FaultComponent.TELEMETRY, FaultKind.WRONG
_LIES: dict[
    tuple[FaultComponent, FaultKind, str], Callable[[Fault, OnboardState], OnboardState]
] = {
    (_TELEMETRY, _WRONG, "yaw"): lambda fault, state: replace(
        state, psi=wrap_angle(state.psi + fault.size)
    ),
    (_TELEMETRY, _WRONG, "height"): lambda fault, state: replace(
        state, height=state.height + fault.size
    ),
    (_TELEMETRY, _WRONG, "velocity"): _faster,
    (FaultComponent.BATTERY, FaultKind.GARBAGE, ""): lambda fault, state: replace(
        state, battery=nan
    ),
}


def not_numbers(fault: Fault, state: OnboardState, number: int) -> OnboardState:
    """Return a report whose numbers are none."""
    return replace(
        state, phi=nan, theta=nan, psi=nan, height=nan, velocity=(nan, nan, nan), battery=nan
    )
