"""Chooses and judges control gains for the drone and the tracking system of a site."""

from __future__ import annotations

from housefly.app.loaded_site import LoadedSite
from housefly.lab.tuning.advice import Advice, GainQuestion, Judgement, advise, judge
from housefly.lab.tuning.loop import Loop


def choose_gains(loaded: LoadedSite, *, step: float = 0.5) -> Advice | None:
    """Return the fastest gains and filter that keep their margins; None if no pair does.

    Drone, tracking rate, latency, noise and mode are those of the site: load it with
    ``twin__mocap_rate_hz``, ``twin__mocap_latency`` and ``twin__mocap_noise`` for another tracking
    system.

    Args:
        loaded: the site.
        step: largest jump of the reference [m].
    """
    return advise(_question(loaded, step))


def judge_gains(
    loaded: LoadedSite,
    alpha: float | None = None,
    beta: float | None = None,
    *,
    step: float = 0.5,
) -> Judgement:
    """Return the margins of a pair of gains, and what speaks against it.

    Args:
        loaded: the site.
        alpha: damping gain [1/s]; None for the site's.
        beta: stiffness gain [1/s^2]; None for the site's.
        step: largest jump of the reference [m].
    """
    control = loaded.site.control
    return judge(
        _question(loaded, step),
        control.alpha if alpha is None else alpha,
        control.beta if beta is None else beta,
    )


def _question(loaded: LoadedSite, step: float) -> GainQuestion:
    site = loaded.site
    drone, control, tracking = site.drone, site.control, site.twin
    loop = Loop(
        alpha=control.alpha,
        beta=control.beta,
        lag=drone.attitude_lag,
        delay=drone.command_delay,
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
