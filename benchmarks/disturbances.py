"""Loads, gusts, noise, sag and draughts in the simulated room in lock step, scored on the truth.

python benchmarks/disturbances.py                       as shipped, and each part left out
python benchmarks/disturbances.py --only "as shipped"   one of them
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass
from math import hypot, sqrt
from typing import Any

import numpy as np

from _ablation import ablations
from _run import table
from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.messages import DroneStatus, Order, OrderKind
from housefly.sites.loaded_site import load_site
from housefly.twin.disturbance import NEUTRAL, Disturbances, Payload
from housefly.twin.quadrotor.body import DRONE_MASS

BEGINS_AT, SCORED_AFTER, HOVER_TIME = 3.0, 5.0, 12.0
LAND_AT, LAND_LIMIT = 10.0, 30.0
_UPDRAUGHT = 0.1 * DRONE_MASS * 9.81 / 0.35
"""Rising air that lifts a tenth of the weight [m/s]."""


class ThrustNoise:
    """All motors together, one sigma 5 %, twenty times a second, never above full thrust."""

    def __init__(self) -> None:
        self._random, self._number = np.random.default_rng(5), -1
        self._now = NEUTRAL

    def __call__(self, now: float) -> Disturbances:
        """Return what disturbs at a time [s]."""
        if int(20 * now) != self._number:
            self._number = int(20 * now)
            share = float(np.clip(1.0 + 0.05 * self._random.standard_normal(), 0.0, 1.0))
            self._now = Disturbances(motor_thrust=(share,) * 4)
        return self._now


def _always(disturbances: Disturbances) -> Callable[[], Callable[[float], Disturbances]]:
    return lambda: lambda now: disturbances


HOVERS: dict[str, Callable[[], Callable[[float], Disturbances]]] = {
    "5 % heavier": _always(Disturbances(payload=Payload(0.05 * DRONE_MASS))),
    "10 % heavier": _always(Disturbances(payload=Payload(0.1 * DRONE_MASS))),
    "10 % lighter": _always(Disturbances(wind=(0.0, 0.0, _UPDRAUGHT))),
    "gusts of 0.3 m/s^2": _always(Disturbances(gust=0.3 / 0.58)),
    "thrust noise": ThrustNoise,
    "sag of 1.5 V": _always(Disturbances(voltage_sag=1.5)),
    "draught of 1 m/s": _always(Disturbances(wind=(0.0, 1.0, 0.0))),
}


@dataclass(frozen=True, slots=True)
class HoverScore:
    """How a place was held [m], and what was told.

    Attributes:
        dip: largest error of the height since the disturbance began.
        height, height_rms: error of the height from 5 s after that on: largest, rms.
        place_rms: of the place in the plane.
        told: codes of the events.
    """

    dip: float
    height: float
    height_rms: float
    place_rms: float
    told: tuple[str, ...]


class _Hovering:
    """A drone that hovers above its pad, and the loop it is in."""

    def __init__(self, changes: dict[str, Any]) -> None:
        loaded = load_site("bsen", hub__enabled=False, twin__video=False, **changes)
        self.loop = Simulation(loaded)
        self.place = (*loaded.room.home, loaded.site.map.flight_height)
        self._yaw, self._hovers = loaded.room.home_yaw, False

    def tick(self, disturbances: Disturbances, order: OrderKind | None) -> Any:
        """Run one control period and return the step of the pilot."""
        if self.loop.now < SETTLING_TIME:
            self.loop.world.put_drone(self.place, self._yaw)
        elif not self._hovers:
            self.loop.world.hover_drone(self.place, self._yaw)
            self._hovers = True
        self.loop.advance()
        self.loop.world.disturb(disturbances)
        now = self.loop.now
        orders = (Order(order, issued_at=now),) if order is not None else ()
        return self.loop.step(self.loop.inputs(*orders))


def hover_score(disturbed: Callable[[float], Disturbances], changes: dict[str, Any]) -> HoverScore:
    """Return how well a place is held while something begins to disturb it."""
    flight, errors, times, told = _Hovering(changes), [], [], []
    ordered = False
    while flight.loop.now < BEGINS_AT + HOVER_TIME:
        now = flight.loop.now
        order = OrderKind.HOVER if not ordered and now >= 1.0 else None
        ordered = ordered or order is not None
        step = flight.tick(disturbed(now) if now >= BEGINS_AT else NEUTRAL, order)
        truth = flight.loop.world.truth().pose.position
        errors.append([a - b for a, b in zip(truth, flight.place, strict=True)])
        times.append(now)
        told += [event.code for event in step.outputs.events if now > BEGINS_AT]
    all_errors, at = np.array(errors), np.array(times)
    late = all_errors[at > BEGINS_AT + SCORED_AFTER]
    late = late - [*late[:, :2].mean(axis=0), 0.0]
    return HoverScore(
        dip=float(np.abs(all_errors[at > BEGINS_AT, 2]).max()),
        height=float(np.abs(late[:, 2]).max()),
        height_rms=float(sqrt(np.square(late[:, 2]).mean())),
        place_rms=float(sqrt(np.square(late[:, :2]).sum(axis=1).mean())),
        told=tuple(dict.fromkeys(told)),
    )


def landing_error(wind: tuple[float, float], seed: int, changes: dict[str, Any]) -> float:
    """Return how far from its pad the drone stands that came home in a draught [m]."""
    flight = _Hovering({**changes, "twin__seed": seed})
    orders = [(1.0, OrderKind.HOVER), (LAND_AT, OrderKind.HOME)]
    air = Disturbances(wind=(*wind, 0.0))
    while flight.loop.now < LAND_LIMIT:
        now = flight.loop.now
        order = orders.pop(0)[1] if orders and now >= orders[0][0] else None
        step = flight.tick(air if now >= 2.0 else NEUTRAL, order)
        report = step.inputs.telemetry
        if now > LAND_AT and report is not None and report.status is DroneStatus.LANDED:
            break
    x, y, _ = flight.loop.world.truth().pose.position
    return hypot(x - flight.place[0], y - flight.place[1])


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", choices=[*ablations()])
    only = parser.parse_args().only
    for name, changes in ablations().items():
        if only in (None, name):
            _print(name, changes)


def _print(name: str, changes: dict[str, Any]) -> None:
    print(f"### {name}\n")
    rows = []
    for what, made in HOVERS.items():
        score = hover_score(made(), changes)
        numbers = (score.dip, score.height, score.height_rms, score.place_rms)
        rows.append([what, *(f"{1000 * number:.0f}" for number in numbers), ", ".join(score.told)])
    head = ("disturbance", "dip mm", "height after 5 s mm", "height rms mm", "place rms mm", "told")
    print(table(head, rows) + "\n")
    winds = ((0.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.7, 0.7))
    errors = [landing_error(wind, seed, changes) for wind in winds for seed in (1, 2)]
    print(f"Landing in a draught of 1 m/s: {1000 * max(errors):.0f} mm at most of {len(errors)}.\n")


if __name__ == "__main__":
    main()
