"""What the estimator found out in flight besides the pose, in words that a console can show."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot, isfinite, nan, sqrt

from housefly.geometry import GRAVITY, Vec2
from housefly.pilot.estimation.delay_estimate import delay_deviation
from housefly.pilot.estimation.delay_filter import CommandHistory
from housefly.pilot.estimation.estimator import disturbance_of
from housefly.pilot.estimation.estimator_state import (
    EstimatorParameters,
    EstimatorState,
)


@dataclass(frozen=True, slots=True)
class EstimationReport:
    """Measured and estimated now; nan where nothing can be said.

    Attributes:
        tracking_rate_hz: of the accepted sightings.
        tracking_latency: from capture to the pilot, by the stamps [s].
        command_delay: from command to first reaction, by the stamps [s].
        command_delay_std: its one-sigma error [s]; 0 where the site's is believed.
        nis: normalized innovation squared in the plane; 1 where the filter is as good as it thinks.
        height_nis: of the height.
        push: steady push in the plane [m/s^2].
        load: steady push down, as a share of the weight.
        height_std: one-sigma uncertainty of the height at the last sighting [m].
    """

    tracking_rate_hz: float = nan
    tracking_latency: float = nan
    command_delay: float = nan
    command_delay_std: float = nan
    nis: float = nan
    height_nis: float = nan
    push: Vec2 = (nan, nan)
    load: float = nan
    height_std: float = nan

    @property
    def push_size(self) -> float:
        """Size of the push [m/s^2]."""
        return hypot(*self.push)


NOTHING_ESTIMATED = EstimationReport()


def estimation_report(
    state: EstimatorState, history: CommandHistory, params: EstimatorParameters
) -> EstimationReport:
    """Return what an estimator has found."""
    health, delay = state.health, state.delay
    is_steady = isfinite(health.interval) and health.interval > 0.0
    return EstimationReport(
        tracking_rate_hz=1.0 / health.interval if is_steady else nan,
        tracking_latency=health.latency,
        command_delay=delay.delay,
        command_delay_std=delay_deviation(delay),
        nis=health.nis,
        height_nis=health.height_nis,
        push=disturbance_of(state.delay_filter.newest, history),
        load=-state.climb.axis.d / GRAVITY if params.climb.wander > 0.0 else nan,
        height_std=sqrt(max(0.0, _height_variance(state, params))),
    )


def _height_variance(state: EstimatorState, params: EstimatorParameters) -> float:
    """Return the variance [m^2] by the filter that the height is taken from."""
    return state.climb.covariance.zz if params.climb.wander > 0.0 else state.height_yaw.z.xx
