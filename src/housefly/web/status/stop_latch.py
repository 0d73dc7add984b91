"""The STOP that somebody pressed: sent, confirmed by the pilot, and kept over its restart."""

from __future__ import annotations

from dataclasses import dataclass, replace

from housefly.messages import OrderKind, PilotStep, SafetyMode
from housefly.messages.words import Words
from housefly.web.messages.verdict_message import StopProgress, StopView

CONFIRM_TIMEOUT = 1.5
"""A STOP that the pilot has not confirmed by then has failed for now [s]."""
RESEND_PERIOD = 0.5
"""How often one that must be confirmed is sent again [s]."""
_RANKS = {mode: rank for rank, mode in enumerate(SafetyMode)}


@dataclass(frozen=True, slots=True)
class StopLatch:
    """What is known of STOP; every method returns the latch after what happened.

    Attributes:
        holds: somebody pressed STOP, and nobody has resumed since.
        by: who.
        sent_at: when it was last pressed [s].
        tried_at: when it was last sent [s].
        is_confirmed: the pilot that is heard now has taken it.
        is_shown: that pilot has been seen stopped, so that it says so when it is no longer.
    """

    holds: bool = False
    by: str = ""
    sent_at: float = 0.0
    tried_at: float = 0.0
    is_confirmed: bool = False
    is_shown: bool = False

    def pressed(self, by: str, now: float) -> StopLatch:
        """STOP was pressed and sent; one that the pilot has taken already stays confirmed."""
        return replace(self, holds=True, by=by, sent_at=now, tried_at=now)

    def sent_again(self, now: float) -> StopLatch:
        """STOP was sent once more."""
        return replace(self, tried_at=now)

    def acknowledged(self) -> StopLatch:
        """The pilot took STOP on its own path."""
        return replace(self, is_confirmed=True) if self.holds else self

    def pilot_restarted(self, now: float) -> StopLatch:
        """Another pilot has begun, which knows nothing of STOP."""
        return (
            replace(self, is_confirmed=False, is_shown=False, sent_at=now) if self.holds else self
        )

    def heard(self, step: PilotStep) -> StopLatch:
        """The pilot made a step."""
        taken = [one for one in step.inputs.orders if one.kind is OrderKind.STOP]
        if taken or step.outputs.safety is SafetyMode.STOPPED:
            by = self.by or (taken[0].sender if taken else "")
            return replace(self, holds=True, by=by, is_confirmed=True, is_shown=True)
        if not self.holds or _RANKS[step.outputs.safety] > _RANKS[SafetyMode.STOPPED]:
            return self  # a landing hides whether it is stopped
        if self.is_shown:
            return StopLatch()  # the pilot was stopped and is not any more: somebody resumed
        if step.now - self.sent_at > CONFIRM_TIMEOUT:
            return replace(self, is_confirmed=False)  # it took it, and another pilot flies now
        return self

    def must_send(self, now: float) -> bool:
        """Return whether a STOP that holds has to be sent again."""
        return self.holds and not self.is_confirmed and now - self.tried_at >= RESEND_PERIOD

    def view(self, now: float, *, airborne: bool | None, pilot_is_heard: bool) -> StopView:
        """Return what people are told."""
        if not self.holds:
            return StopView()
        if self.is_confirmed and pilot_is_heard:
            words = Words("The drone takes no orders until Resume is held")
            if airborne:
                words = Words("The drone hovers and takes no orders until Resume is held")
            return StopView(StopProgress.CONFIRMED, self.by, words)
        if self.is_confirmed:
            words = Words("its pilot is not heard; the next one is stopped, too")
            return StopView(StopProgress.CONFIRMED, self.by, words)
        if now - self.sent_at < CONFIRM_TIMEOUT:
            words = Words("sent, the pilot has not confirmed it yet")
            return StopView(StopProgress.SENT, self.by, words)
        words = Words("the pilot has not confirmed it: it is sent again and again")
        return StopView(StopProgress.FAILED, self.by, words)
