"""What the paper claims in sections VI to VIII: console, battery, experiment, outlook."""

from __future__ import annotations

import numpy as np

from housefly.lab.experiments.intervals import mean, share
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import OpposingCases, Verdict
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
    if not flown.size:
        return Ruling(Verdict.NOT_TESTABLE, "No service was flown on the typical stream.")
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
    if reached.value < 1.0 - _EVERY_FLIGHT:
        return Ruling(Verdict.FAILS, text)
    if reached.low < _EVERY_FLIGHT or completed < len(services):
        return Ruling(Verdict.CONDITION, "In most flights, not surely in all. " + text)
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
    """Rule on "a static map is not valid when unexpected obstacles are added".

    Obstacles stand on the way and all over the room; low ones the drone passes over.
    """
    found = evidence.maps.unexpected
    cases = OpposingCases(
        f"The way planned before touches {found.hit_static} of {found.on_way} people who stand on"
        " it one after another.",
        f"Of {found.all_over} people who stand all over the room it touches {found.hit_all_over},"
        f" of {found.on_way} stools on the way {found.hit_low}: for the others the old map stays"
        " good enough.",
    )
    if found.hit_all_over == found.all_over:
        return Ruling(Verdict.HOLDS, cases.speaks_for, cases)
    if found.hit_static:
        return Ruling(
            Verdict.CONDITION,
            "Holds for obstacles beside or on the way that reach the flight height, not for others."
            f" {cases.speaks_for} {cases.speaks_against}",
            cases,
        )
    return Ruling(Verdict.FAILS, f"{cases.speaks_for} {cases.speaks_against}", cases)


def _dynamic_map(evidence: Evidence) -> Ruling:
    """Rule on "a map updated each time the algorithm is executed solves this problem"."""
    found = evidence.maps.unexpected
    cases = OpposingCases(
        f"Planned on the updated map the way touches {found.hit_updated} of {found.on_way} people"
        f" who stand on the way planned before, which touches {found.hit_static}.",
        f"When each has gone one step since the map was updated, in four directions in turn, it"
        f" touches {found.hit_walked} of {found.walked}; people who come later yet it does not know"
        " at all.",
    )
    if found.hit_updated:
        return Ruling(Verdict.FAILS, cases.speaks_for, cases)
    if found.hit_walked:
        return Ruling(
            Verdict.CONDITION,
            "Holds for obstacles that stay where they are, not for those that move after the way"
            f" was planned. {cases.speaks_for} {cases.speaks_against}",
            cases,
        )
    return Ruling(Verdict.HOLDS, cases.speaks_for, cases)


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
