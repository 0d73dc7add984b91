"""How long one step of the pilot takes beside the period of its loop, flying through B-sen."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from housefly.config.site import Mode, Site, changed
from housefly.geometry import quaternion_from_euler
from housefly.messages import (
    Action,
    DroneStatus,
    Inputs,
    Order,
    OrderKind,
    Outputs,
    Pose,
    Sighting,
    Telemetry,
)
from housefly.pilot.assembly import make_pilot, warm_up
from housefly.pilot.control.model import Constants, DroneState, drone_step
from housefly.room.files import load_room
from housefly.room.grid import build_grid

PERIOD = 0.01
SECONDS = 40.0


@dataclass(frozen=True, slots=True)
class Timing:
    """Durations of the steps of one flight [s], and of the step that planned the way."""

    steps: np.ndarray
    order: float


def flight(mode: Mode, rate_hz: float) -> Timing:
    """Fly towards the entrance with the reduced-order drone and time every step."""
    site = changed(Site(), mode=mode)
    room = load_room("bsen")
    grid = build_grid(room, site)
    warm_up(site, room, grid)
    pilot = make_pilot(site, room, grid)
    body = DroneState(*room.home, 1.1, room.home_yaw)
    random = np.random.default_rng(1)
    durations, order_time, outputs = [], 0.0, None
    for tick in range(round(SECONDS / PERIOD)):
        now = tick * PERIOD
        body = moved(body, outputs)
        ordered = tick == 50
        orders = (Order(OrderKind.GO, "entrance", issued_at=now),) if ordered else ()
        inputs = Inputs(
            sightings(site, body, now, tick, rate_hz, random),
            Telemetry(now, DroneStatus.FLYING, 0.9),
            orders,
        )
        start = time.perf_counter()
        outputs = pilot.step(now, inputs)
        spent = time.perf_counter() - start
        order_time = spent if ordered else order_time
        durations.append(spent)
    return Timing(np.array(durations), order_time)


def moved(body: DroneState, outputs: Outputs | None) -> DroneState:
    """Return the drone one period later."""
    if outputs is None or outputs.command.action is not Action.FLY:
        return body
    s = outputs.command.setpoint
    return drone_step(body, s.theta, s.phi, s.vz, s.yaw_rate, (0.0, 0.0), Constants(), PERIOD)


def sightings(
    site: Site, body: DroneState, now: float, tick: int, rate_hz: float, random: np.random.Generator
) -> tuple[Sighting, ...]:
    """Return what the tracking system sees in this period."""
    if tick % round(1.0 / (rate_hz * PERIOD)):
        return ()
    x, y, z = (random.normal((body.x, body.y, body.z), 0.001)).tolist()
    pose = Pose((x, y, z), quaternion_from_euler(body.phi, body.theta, body.psi))
    return (Sighting(site.tracking.body, pose, now, now),)


def main() -> None:
    """Print the section."""
    print("### One step of the pilot\n")
    print(
        "| mode, tracking | p50 | p99 | share of the 10 ms period (p50) | step that plans the way |"
    )
    print("|---|---|---|---|---|")
    modes: tuple[Mode, ...] = ("default", "paper")
    for mode in modes:
        for rate_hz in (100.0, 10.0):
            timing = flight(mode, rate_hz)
            p50, p99 = np.percentile(timing.steps, [50, 99])
            cells = (
                f"{mode}, {rate_hz:.0f} Hz",
                f"{1e6 * p50:.0f} us",
                f"{1e6 * p99:.0f} us",
                f"{100.0 * p50 / PERIOD:.1f} %",
            )
            print(f"| {' | '.join(cells)} | {1e3 * timing.order:.1f} ms |")
    print(
        f"\nWall time of `Pilot.step` over {SECONDS:.0f} s of flight in B-sen at 100 steps per"
        " second, beside the loop's period."
    )


if __name__ == "__main__":
    main()
