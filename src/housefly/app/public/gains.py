"""Chooses and judges control gains for the drone and the tracking system of a site."""

from __future__ import annotations

from housefly.lab.tuning.advice import Advice, Judgement, advise, judge
from housefly.lab.tuning.question import DEFAULT_STEP, question_of
from housefly.sites.loaded_site import LoadedSite


def choose_gains(loaded: LoadedSite, *, step: float = DEFAULT_STEP) -> Advice | None:
    """Return the fastest gains and filter that keep their margins; None if no pair does.

    Drone, tracking rate, latency, noise and mode are those of the site: load it with
    ``twin__mocap_rate_hz``, ``twin__mocap_latency`` and ``twin__mocap_noise`` for another tracking
    system.

    Args:
        loaded: the site.
        step: largest jump of the reference [m].
    """
    return advise(question_of(loaded.site, step))


def judge_gains(
    loaded: LoadedSite,
    alpha: float | None = None,
    beta: float | None = None,
    *,
    step: float = DEFAULT_STEP,
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
        question_of(loaded.site, step),
        control.alpha if alpha is None else alpha,
        control.beta if beta is None else beta,
    )
