"""What the tests of estimation share: an estimator that is given sightings and commands."""

from __future__ import annotations

from housefly.config.site import Site
from housefly.messages import Estimate, Event, Sighting
from housefly.numeric import boxed
from housefly.pilot.estimation.estimator import (
    control_state,
    estimator_advanced,
    estimator_commanded,
)
from housefly.pilot.estimation.estimator_state import (
    ControlState,
    EstimatorKind,
)
from housefly.pilot.estimation.pose_estimator import PoseEstimator
from housefly.pilot.estimation.validation import RejectionReason
from housefly.pilot.site_parameters import estimator_parameters


class EstimatorBench:
    """The estimator of one drone, as ``pilot.step`` and ``Pilot`` call it between them."""

    def __init__(self, kind: EstimatorKind) -> None:
        site = Site()
        params = estimator_parameters(False, site.drone, site.control)
        self.params = params._replace(kind=int(kind))
        self._estimator = PoseEstimator(
            self.params, "ardrone", 0.0, site.drone.airframe, drag=site.drone.drag
        )

    @property
    def rejected(self) -> dict[RejectionReason, int]:
        return self._estimator.rejected

    def update(self, *sightings: Sighting, now: float, grounded: bool = False) -> tuple[Event, ...]:
        return self._estimator.update(sightings, now, grounded)

    def estimate(self, now: float) -> Estimate | None:
        found = self._estimator.estimate(now)
        return found[1] if found else None

    def command(self, now: float, ux: float, uy: float = 0.0, flown: bool = True) -> None:
        """Give a world acceleration [m/s^2], in force from now on."""
        estimator = self._estimator
        state = estimator_advanced(estimator.state, estimator.history, self.params, now)
        state = estimator_commanded(state, estimator.history, self.params, ux, uy, flown)
        estimator.box = boxed(state)

    def ahead(self, now: float) -> ControlState | None:
        """Return the state for control."""
        found, estimator = self._estimator.estimate(now), self._estimator
        if found is None:
            return None
        return control_state(estimator.state, estimator.history, self.params, found[0], now)
