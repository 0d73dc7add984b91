"""The largest stable frequency: of the loop and not of the air, and of every drone."""

from __future__ import annotations

from math import sqrt
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.reproduction.edges import (
    ESTIMATORS,
    FREQUENCIES,
    RINGING,
    STILL_AIR,
    TRACKING_ALWAYS,
    largest_settling,
    settled_steps,
)
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.fleet import fleet
from housefly.lab.reproduction.routes import hold_plan
from housefly.lab.reproduction.stability_limit import limit_of, stability_limit
from housefly.lab.reproduction.streams import LATENCIES, RATES
from housefly.lab.reproduction.table_plots import drones_counted
from housefly.pilot.estimation.estimator_state import EstimatorKind

ONE_STEP = FREQUENCIES[1] / FREQUENCIES[0]
PAPER = {"estimator": np.array([EstimatorKind.ON_ARRIVAL])}


@given(st.lists(st.one_of(st.just(np.nan), st.sampled_from(list(FREQUENCIES))), min_size=1))
def test_every_drone_counts_whatever_became_of_it(edges: list[float]) -> None:
    drones = np.array(edges)
    limit = limit_of(drones)
    assert limit.drones == drones.size
    assert limit.ringing == np.isnan(drones).sum()
    assert limit.beyond == (drones == FREQUENCIES[-1]).sum()
    assert limit.frequency.value == pytest.approx(np.nan_to_num(drones).mean())
    assert limit.frequency.low <= limit.frequency.value + 1e-9
    assert limit.frequency.high >= limit.frequency.value - 1e-9


def test_in_still_air_every_drone_settles_at_the_lowest_frequency(evidence: Evidence) -> None:
    for estimator in ESTIMATORS:
        for rate in RATES:
            for latency in LATENCIES:
                assert stability_limit(evidence.edges, estimator, rate, latency).ringing == 0


def test_in_gusts_drones_would_ring_that_are_stable_and_each_is_counted(site: Site) -> None:
    """What the mean over finite edges kept silent about."""
    drones = fleet(site, 20)
    air: dict[str, Any] = {name: np.tile(drones[name], FREQUENCIES.size) for name in STILL_AIR}
    in_gusts = settled_steps(site, 20, PAPER, **air)
    still = limit_of(largest_settling(settled_steps(site, 20, PAPER)[0]))
    shaken = largest_settling(in_gusts[0])
    limit = limit_of(shaken)
    assert still.ringing == 0 and limit.ringing > 3
    assert limit.frequency.value < 0.9 * still.frequency.value < np.nanmean(shaken)
    assert f" {limit.ringing} lie below" in drones_counted([limit])


def test_no_rate_dips_below_both_of_its_neighbours(evidence: Evidence) -> None:
    """Within one step of the frequencies tried."""
    for estimator in ESTIMATORS:
        for latency in LATENCIES:
            edges = [
                stability_limit(evidence.edges, estimator, rate, latency).frequency.value
                for rate in RATES
            ]
            for before, here, after in zip(edges, edges[1:], edges[2:], strict=False):
                assert here * ONE_STEP > min(before, after), (estimator, latency, edges)


def test_noise_alone_is_never_taken_for_ringing(site: Site) -> None:
    paper = changed(site, mode="paper")
    drones = fleet(site, 20)
    for estimator in ESTIMATORS:
        flown = fly_many(
            cases(
                paper,
                20,
                **drones
                | STILL_AIR
                | TRACKING_ALWAYS
                | {"estimator": estimator, "alpha": 2.0, "beta": 1.0, "mocap_rate_hz": 100.0},
            ),
            hold_plan(site, 12.0),
        )
        assert flown["residual"].max() < RINGING


def test_without_delay_and_noise_the_limit_is_that_of_routh(site: Site) -> None:
    """s^3 + (lambda + d) s^2 + lambda (d + 2 w) s + lambda w^2 with drag d, by hand."""
    lag, drag = 7.0, 0.58
    drone: dict[str, Any] = {"lag": lag, "drag": drag, "gain": 1.0, "delay": 0.0}
    pilot: dict[str, Any] = {"model_delay": 0.0, "rate_hz": 200.0}
    stream: dict[str, Any] = {
        "mocap_rate_hz": 200.0,
        "mocap_latency": 0.0,
        "mocap_jitter": 0.0,
        "mocap_noise": 0.0,
    }
    ours = {"estimator": np.array([EstimatorKind.DELAY_COMPENSATED])}
    settled = settled_steps(site, 1, ours, **drone, **pilot, **stream)
    by_hand = lag + drag + sqrt((lag + drag) ** 2 + drag * (lag + drag))
    found = float(largest_settling(settled[0])[0])
    assert by_hand / ONE_STEP**2 < found < by_hand * ONE_STEP
