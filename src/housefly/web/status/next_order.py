"""The order that a person would most sensibly give next: what the large button says."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.messages import OrderKind, Phase
from housefly.web.messages.verdict_message import FlightObjection, OrderObjection, StopProgress
from housefly.web.status.console_knowledge import ConsoleKnowledge

_BY_ITSELF = (Phase.TAKING_OFF, Phase.RETURNING, Phase.LANDING)
"""What ends by itself; who wants it otherwise has Hover and Land beside the button."""


def next_order(
    known: ConsoleKnowledge,
    reasons: Sequence[FlightObjection],
    objections: Sequence[OrderObjection],
) -> OrderKind | None:
    """Return the next sensible order, or None when there is nothing to be ordered.

    reasons: what speaks against a take-off. objections: to each order; what comes to nothing is
    never proposed.
    """
    wanted = _wanted(known, reasons)
    return None if any(one.order is wanted for one in objections) else wanted


def _wanted(known: ConsoleKnowledge, reasons: Sequence[FlightObjection]) -> OrderKind | None:
    if known.stop.progress is not StopProgress.NONE:
        return OrderKind.RESUME
    if not known.pilot_is_heard or known.step is None:
        return None
    if known.is_cut:
        return OrderKind.RESET
    if known.airborne:
        return None if known.step.outputs.phase in _BY_ITSELF else OrderKind.HOME
    return None if reasons else OrderKind.SERVICE
