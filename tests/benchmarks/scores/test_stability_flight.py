"""Margins are promises about flights: kept below them and lost above, on the truth."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from housefly.app.public.gains import judge_gains
from housefly.config.airframe import airframe_named
from housefly.config.estimation import ONLY_LEVEL_PUSHES
from housefly.lab.tuning.advice import Judgement
from housefly.lab.tuning.margins import delay_margin
from housefly.sites.loaded_site import LoadedSite, load_site
from scores.stability_flight import (
    Swing,
    hover_swing,
    nearest_periods,
)

COMMAND_DELAY = airframe_named("ardrone").response.command_delay

TOLERANCE = 0.05
"""What is promised is flown within this share."""
SETTINGS = ((100.0, 0.02), pytest.param(10.0, 0.1, marks=pytest.mark.interop))


def tracked(rate: float, latency: float) -> LoadedSite:
    # The linear analysis knows no delay that is found in flight.
    plain = ONLY_LEVEL_PUSHES.model_dump()
    return load_site(
        "bsen", twin__mocap_rate_hz=rate, twin__mocap_latency=latency, estimation=plain
    )


@cache
def judged(rate: float, latency: float) -> tuple[LoadedSite, Judgement]:
    loaded = tracked(rate, latency)
    return loaded, judge_gains(loaded)


@pytest.mark.interop
@pytest.mark.parametrize(("rate", "latency"), SETTINGS)
def test_a_flight_holds_the_delay_margin_less_five_percent(rate: float, latency: float) -> None:
    loaded, judgement = judged(rate, latency)
    extra, _ = nearest_periods((1.0 - TOLERANCE) * judgement.margins.delay)
    assert extra > 0.1
    assert hover_swing(loaded, extra).dies_away


@pytest.mark.interop
@pytest.mark.parametrize(("rate", "latency"), SETTINGS)
def test_a_flight_fails_at_the_delay_margin_and_five_percent(rate: float, latency: float) -> None:
    loaded, judgement = judged(rate, latency)
    _, extra = nearest_periods((1.0 + TOLERANCE) * judgement.margins.delay)
    assert not hover_swing(loaded, extra).dies_away


@pytest.mark.interop
@pytest.mark.interop
def test_a_model_without_datagrams_would_promise_what_no_flight_holds() -> None:
    loaded, judgement = judged(*SETTINGS[0])
    naive = delay_margin(replace(judgement.loop, delay=COMMAND_DELAY))
    assert naive > (1.0 + TOLERANCE) * judgement.margins.delay
    extra, _ = nearest_periods((1.0 - 0.2 * TOLERANCE) * naive)
    assert not hover_swing(loaded, extra).dies_away


@pytest.mark.parametrize(
    ("swing", "dies_away"),
    [
        (Swing(0.05, 0.01), True), (Swing(0.05, 0.05), False), (Swing(0.0, float("inf")), False),
        (Swing(0.0005, 0.0006), True),
    ],
)  # fmt: skip
def test_a_swing_dies_away_when_it_shrinks_or_is_noise(swing: Swing, dies_away: bool) -> None:
    assert swing.dies_away is dies_away
