"""What the paper claims in sections VI to VIII: console, battery, experiment, outlook."""

from __future__ import annotations

import numpy as np

from housefly.lab.experiments.intervals import mean, share
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.ruling import (
    Claim,
    Ruling,
    centimetres,
    percent,
    percents,
    untestable,
)
from housefly.lab.reproduction.streams import TYPICAL_LATENCY, TYPICAL_LOSS, TYPICAL_RATE

_COMPLETED = "completed"
_SERVICES_A_DAY = 50
"""Services that one day may ask for without anybody checking the charge."""
_EVERY_FLIGHT = 0.95
"""Share of flights that counts as all of them."""


def _automatic(evidence: Evidence) -> Ruling:
    """Rule on "the drone took off, moved along the path and reached the destination"."""
    flown = evidence.streams.where(
        mode="paper",
        mocap_rate_hz=TYPICAL_RATE,
        mocap_latency=TYPICAL_LATENCY,
        mocap_dropout=TYPICAL_LOSS,
    )
    reached = share(np.isfinite(flown["arrival_time"]))
    error = mean(flown["arrival_error"])
    text = (
        f"In mode paper {percents(reached)} of {flown.size} flights reach the entrance and stay, "
        f"{centimetres(error)} from its middle."
    )
    services = [service for service in evidence.services if service.mode == "paper"]
    completed = sum(service.outcome == _COMPLETED for service in services)
    if services:
        text += (
            f" On the twin {completed} of {len(services)} whole services of mode paper, take-off to"
            " landing, completed."
        )
    if reached.value < _EVERY_FLIGHT or completed < len(services):
        return Ruling(
            Verdict.FAILS if reached.value < 1.0 - _EVERY_FLIGHT else Verdict.CONDITION, text
        )
    return Ruling(Verdict.HOLDS, text)


def _battery(evidence: Evidence) -> Ruling:
    """Rule on "the battery level is of key importance": can a day of services empty it?"""
    used = [
        service.battery_used for service in evidence.services if service.battery_used is not None
    ]
    if not used:
        return Ruling(Verdict.NOT_TESTABLE, "No whole service was flown on the twin in this run.")
    one, floor = float(np.mean(used)), evidence.site.limits.battery_floor
    last = int((1.0 - floor) / one) if one > 0.0 else _SERVICES_A_DAY + 1
    text = (
        f"One service takes {100 * one:.1f} % of a charge: after {last} the last gate lands the"
        f" drone at {percent(floor)}."
    )
    return Ruling(Verdict.HOLDS if last <= _SERVICES_A_DAY else Verdict.FAILS, text)


def _static_map(evidence: Evidence) -> Ruling:
    """Rule on "a static map is not valid when unexpected obstacles are added"."""
    maps = evidence.maps
    text = (
        f"The way planned before touches {maps.hit_static} of {maps.boxes} boxes put on it one"
        " after another."
    )
    return Ruling(Verdict.HOLDS if maps.hit_static else Verdict.FAILS, text)


def _dynamic_map(evidence: Evidence) -> Ruling:
    """Rule on "a map updated each time the algorithm is executed solves this problem"."""
    maps = evidence.maps
    text = (
        f"Planned on the updated map the way touches {maps.hit_updated} of {maps.boxes} boxes; of"
        f" those that appear after planning it touches {maps.hit_static}."
    )
    if maps.hit_updated:
        return Ruling(Verdict.FAILS, text)
    if maps.hit_static:
        return Ruling(
            Verdict.CONDITION, "For obstacles that stand there when the way is planned. " + text
        )
    return Ruling(Verdict.HOLDS, text)


SERVICE_CLAIMS: tuple[Claim, ...] = (
    Claim(
        "easy to use",
        "VI",
        "any user can easily use the application",
        untestable("Needs people; no user was watched here."),
        ("14",),
    ),
    Claim(
        "reset",
        "VI",
        "the reset button stops the motors in flight and resets the software on board",
        untestable(
            "What a press does is the drone's firmware; our twin copies its description and so"
            " cannot confirm it."
        ),
        ("14",),
    ),
    Claim(
        "battery",
        "VI",
        "the battery level is of key importance for safe flights",
        _battery,
        ("14",),
    ),
    Claim(
        "service",
        "VII",
        "the drone took off, moved along the desired path and reached the destination"
        " automatically",
        _automatic,
        ("15", "16", "17"),
    ),
    Claim(
        "static map",
        "VIII",
        "the map is not valid once unexpected obstacles are added",
        _static_map,
        ("7",),
    ),
    Claim(
        "dynamic map",
        "VIII",
        "a map updated at each execution solves this problem",
        _dynamic_map,
        ("7",),
    ),
)
