"""Steps that come down: home and onto the pad, or where the drone is."""

from __future__ import annotations

from housefly.messages import DroneStatus, Order, OrderKind, Phase
from housefly.messages.words import Words
from housefly.tasks.api.values import ReasonCode
from housefly.tasks.execution.flight_steps import FlightStep
from housefly.tasks.execution.step_behavior import StepFailed
from housefly.tasks.execution.values import Say

REFUSED_TIME, REFUSED_PERIOD = 10.0, 1.0
"""A way home that the pilot refuses is asked for again for so long [s], so often [s]."""


class Descent(FlightStep):
    """Comes down, by one kind of order; done when the drone stands."""

    KIND = OrderKind.HOME

    def order(self) -> Order:
        """Return the order."""
        return Order(self.KIND)

    def is_done_already(self) -> bool:
        """Return whether it stands, or is landing anyway."""
        return self.context.stands or self.context.inputs.phase is Phase.LANDING

    def proceed(self) -> bool:
        """Wait until it stands."""
        if self.context.stands and not self.context.orders.is_open(self.context.inputs.now):
            if fault := self.context.standing_fault:
                raise StepFailed(fault, ReasonCode.SAFETY)
            return True
        if self.context.inputs.status is DroneStatus.EMERGENCY:
            raise StepFailed(
                Words("the motors are off: the drone fell or was cut"), ReasonCode.SAFETY
            )
        if self.context.orders.order is not None and self.context.inputs.phase is not Phase.LANDING:
            self.is_accepted()
        return False


class ReturnHome(Descent):
    """Flies home and lands on the pad; what is refused now may be free in some seconds."""

    def begin(self) -> None:
        """Give the order."""
        self._refused_since: float | None = None
        self._told = set[str]()
        super().begin()

    def is_accepted(self) -> bool:
        """Return whether the pilot took the order; raises StepFailed when it will not for long."""
        now, tried = self.context.inputs.now, self.context.time  # a pause is no time of trying
        try:
            is_accepted = super().is_accepted()
        except StepFailed as error:
            self._tell(str(error))
            if self._refused_since is None:
                self._refused_since = tried
            if tried - self._refused_since > REFUSED_TIME:
                self.context.home_refused_at = now
                raise
            if now - self.context.orders.given_at >= REFUSED_PERIOD:
                self.send()
            return False
        if is_accepted:
            self._refused_since = None
        return is_accepted

    def _tell(self, refused: str) -> None:
        """Say why it does not come home; each reason once."""
        if refused not in self._told:
            self._told.add(refused)
            words = f"Cannot come home yet: {refused}; trying for {REFUSED_TIME:.0f} s"
            self.context.actions.append(Say(words))


class Land(Descent):
    """Lands where the drone is."""

    KIND = OrderKind.LAND
    LIMIT = 90.0
