"""Margins that the gain advisor promises, beside the edges that flights find: of the batch engine,
and of the simulated room (MuJoCo) in lock step.
"""

from __future__ import annotations

import time
from dataclasses import replace
from math import sqrt

import numpy as np

from _run import table
from housefly.app.public.gains import choose_gains, judge_gains
from housefly.config.estimation import ONLY_LEVEL_PUSHES
from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan, Task
from housefly.lab.tuning.advice import Advice, GainQuestion, advise
from housefly.lab.tuning.loop import Loop
from housefly.lab.tuning.margins import delay_margin, gain_margin
from housefly.lab.tuning.question import question_of
from housefly.lab.tuning.site_lines import site_lines
from housefly.pilot.estimation.estimator_state import EstimatorKind
from housefly.sites.loaded_site import LoadedSite, load_site, open_site
from housefly.twin.simulated_body import CONTROL_PERIOD
from scores.stability_flight import hover_swing, nearest_periods

STEP = 0.02
TRACKING = ((100.0, 0.02), (30.0, 0.05), (10.0, 0.1))
LAGS = (5.0, 7.0, 10.0)
DRONES = 6
ROOM_TRACKING = (
    (100.0, 0.02), (100.0, 0.05), (100.0, 0.1), (50.0, 0.02), (50.0, 0.05),
    (10.0, 0.02), (10.0, 0.1), (5.0, 0.1),
)  # fmt: skip


def settles(loop: Loop, **truth: float) -> bool:
    kind = EstimatorKind.ON_ARRIVAL if loop.paper else EstimatorKind.DELAY_COMPENSATED
    columns = {
        "estimator": kind, "alpha": loop.alpha, "beta": loop.beta, "tilt_max": 0.5,
        "model_lag": loop.lag, "model_delay": loop.delay, "model_drag": loop.drag,
        "lag": loop.lag, "delay": loop.delay, "drag": loop.drag,
        "position_noise": loop.position_noise, "acceleration_noise": loop.acceleration_noise,
        "mocap_rate_hz": loop.tracking_hz, "mocap_latency": loop.latency,
        "mocap_jitter": 0.0, "mocap_noise": 1e-9, "pose_age_level": 10.0, "pose_age_land": 20.0,
    }  # fmt: skip
    case = cases(
        Site(estimation=ONLY_LEVEL_PUSHES), DRONES, seed=np.arange(DRONES), **(columns | truth)
    )
    flown = fly_many(case, FlightPlan(Task.STEP, ((0.0, 0.0), (STEP, 0.0)), SETTLE + 60.0))
    return bool((flown["residual"] < 0.2 * STEP).all())


def edge(loop: Loop, column: str, inside: float, outside: float) -> float:
    while outside - inside > 0.003 * outside:
        middle = 0.5 * (inside + outside)
        inside, outside = (
            (middle, outside) if settles(loop, **{column: middle}) else (inside, middle)
        )
    return 0.5 * (inside + outside)


def advised(rate: float, latency: float) -> tuple[LoadedSite, Advice]:
    """Return the simulated room with the gains and limits advised for a tracking system."""
    tracking = {"twin__mocap_rate_hz": rate, "twin__mocap_latency": latency}
    loaded = load_site("bsen", **tracking)
    advice = choose_gains(loaded)
    assert advice is not None
    lines = site_lines(advice, question_of(loaded.site), loaded.site, {})
    keys = {f"{table}__{key}": value for table, row in lines.items() for key, value in row.items()}
    return load_site("bsen", **(tracking | keys)), advice


def flown_delay_edge(loaded: LoadedSite, promised: float) -> float:
    """Return the middle between the longest further delay that a hover holds and the next one [s].

    The firmware runs every 5 ms, so delays are multiples of that. Tracking has no noise: near the
    edge a loop makes a swing of it that lasts, which is no lack of stability.
    """
    extra, _ = nearest_periods(promised)
    quiet = open_site(changed(loaded.site, twin__mocap_noise=0.0))
    holds = hover_swing(quiet, extra).dies_away
    step = CONTROL_PERIOD if holds else -CONTROL_PERIOD
    while hover_swing(quiet, extra + step).dies_away is holds:
        extra += step
    return extra + 0.5 * step


def print_flown_in_the_room() -> None:
    rows, worst = [], 0.0
    for rate, latency in ROOM_TRACKING:
        loaded, advice = advised(rate, latency)
        shipped = load_site(
            "bsen",
            twin__mocap_rate_hz=rate,
            twin__mocap_latency=latency,
            limits__pose_age_level=loaded.site.limits.pose_age_level,
        )
        for name, site, judgement in (
            ("advised", loaded, advice.judgement),
            ("shipped", shipped, judge_gains(shipped)),
        ):
            promised = judgement.margins.delay
            flown = flown_delay_edge(site, promised)
            worst = max(worst, abs(promised / flown - 1.0))
            pair = f"{judgement.loop.alpha:.3g} / {judgement.loop.beta:.3g}"
            rows.append(
                (
                    f"{rate:.0f} Hz, {1000 * latency:.0f} ms", name, pair,
                    f"{1000 * promised:.0f}", f"{1000 * flown:.0f}", f"{promised / flown:.3f}",
                )
            )  # fmt: skip
    print("\n### Delay margins: promised, and flown in the simulated room\n")
    headings = ("tracking", "gains", "alpha / beta", "promised [ms]", "flown [ms]", "ratio")
    print(table(headings, rows))
    print(
        "\nHovers in mode default, tracked without noise, pushed once; flown is the further delay"
        " between the longest at which the true swing dies away and the next one, 5 ms longer."
        f" Largest difference {100 * worst:.1f} % (limit: 5 %)."
    )


def main() -> None:
    rows, worst = [], 0.0
    for paper in (False, True):
        for lag in LAGS:
            for rate, latency in TRACKING:
                loop = Loop(4.0, 4.0, lag, 0.06, tracking_hz=rate, latency=latency, paper=paper)
                gain, delay = gain_margin(loop), delay_margin(loop)
                flown_gain = edge(loop, "gain", 1.0, 1.6 * gain)
                flown_delay = (
                    edge(loop, "delay", loop.delay, min(0.5, loop.delay + 1.6 * delay)) - loop.delay
                )
                ratios = gain / flown_gain, delay / flown_delay
                worst = max(worst, *(abs(ratio - 1.0) for ratio in ratios))
                rows.append(
                    (
                        "paper" if paper else "default", f"{lag:g}",
                        f"{rate:.0f} Hz, {1000 * latency:.0f} ms",
                        f"{gain:.2f} / {flown_gain:.2f}", f"{ratios[0]:.3f}",
                        f"{1000 * delay:.0f} / {1000 * flown_delay:.0f}", f"{ratios[1]:.3f}",
                    )
                )  # fmt: skip
    print("### Margins: predicted and flown\n")
    headings = (
        "filter of mode",
        "lambda [1/s]",
        "tracking",
        "gain margin",
        "ratio",
        "delay margin [ms]",
        "ratio",
    )
    print(table(headings, rows))
    print(
        "\nalpha = beta = 4, command delay 60 ms; predicted by the matrix of the sampled loop /"
        " found by bisection over flights of the nonlinear batch engine. Largest difference"
        f" {100 * worst:.1f} % (limit: 5 %)."
    )
    print_flown_in_the_room()
    start = time.process_time()
    advice = advise(
        GainQuestion(replace(Loop(1.0, 0.25, 7.0, 0.06), tracking_hz=30.0, latency=0.05))
    )
    assert advice is not None
    print(
        f"\nA recommendation (30 Hz, 50 ms) takes {time.process_time() - start:.1f} s of one core: "
        f"natural frequency {sqrt(advice.judgement.loop.beta):.2f} rad/s."
    )


if __name__ == "__main__":
    main()
