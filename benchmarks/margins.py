"""Margins that the gain advisor predicts, beside the edge that the batch engine finds by flying."""

from __future__ import annotations

import time
from dataclasses import replace
from math import sqrt

import numpy as np

from _run import table
from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan, Task
from housefly.lab.tuning.advice import GainQuestion, advise
from housefly.lab.tuning.loop import Loop
from housefly.lab.tuning.margins import delay_margin, gain_margin
from housefly.pilot.estimation.estimator import EstimatorKind

STEP = 0.02
TRACKING = ((100.0, 0.02), (30.0, 0.05), (10.0, 0.1))
LAGS = (5.0, 7.0, 10.0)
DRONES = 6


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
    case = cases(Site(), DRONES, seed=np.arange(DRONES), **(columns | truth))
    flown = fly_many(case, FlightPlan(Task.STEP, ((0.0, 0.0), (STEP, 0.0)), SETTLE + 60.0))
    return bool((flown["residual"] < 0.2 * STEP).all())


def edge(loop: Loop, column: str, inside: float, outside: float) -> float:
    while outside - inside > 0.003 * outside:
        middle = 0.5 * (inside + outside)
        inside, outside = (
            (middle, outside) if settles(loop, **{column: middle}) else (inside, middle)
        )
    return 0.5 * (inside + outside)


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
