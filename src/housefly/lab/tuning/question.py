"""What gains are wanted for, as a site describes its drone, its tracking and its limits."""

from __future__ import annotations

from housefly.config.site import Site
from housefly.lab.tuning.advice import GainQuestion
from housefly.lab.tuning.loop import Loop
from housefly.twin.command_delay import reaction_delay

DEFAULT_STEP = 0.5
"""Largest jump of the reference that is asked for: a cell of the paper [m]."""


def question_of(site: Site, step: float = DEFAULT_STEP) -> GainQuestion:
    """Return the question of a site, with its own gains and filter in the loop.

    The pilot believes ``drone.command_delay``; the drone that flies takes ``reaction_delay``.

    Args:
        site: drone, tracking, limits, mode.
        step: largest jump of the reference [m].
    """
    drone, control, tracking = site.drone, site.control, site.twin
    loop = Loop(
        alpha=control.alpha,
        beta=control.beta,
        lag=drone.attitude_lag,
        delay=reaction_delay(site),
        model_delay=drone.command_delay,
        drag=drone.drag,
        tracking_hz=tracking.mocap_rate_hz,
        latency=tracking.mocap_latency,
        rate_hz=control.rate_hz,
        paper=site.mode == "paper",
        acceleration_noise=control.acceleration_noise,
        position_noise=control.position_noise,
    )
    return GainQuestion(
        loop,
        climb_lag=drone.climb_lag,
        yaw_lag=drone.yaw_lag,
        noise=tracking.mocap_noise,
        step=step,
        tilt_max=site.limits.tilt_max,
    )
