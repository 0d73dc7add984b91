"""How often the intervals of housefly identify hold the truth: MuJoCo drones with hidden constants,
stepped clock.
"""

from __future__ import annotations

import sys
import time
from concurrent.futures import ProcessPoolExecutor

import numpy as np

from _run import table
from housefly.app.identification_flight import IdentificationFlight, fly_identification_lockstep
from housefly.config.twin import RATE_POLE
from housefly.lab.identification.box import find_box
from housefly.lab.identification.maneuver import IdentificationManeuver
from housefly.lab.identification.pattern import blocks
from housefly.lab.identification.result import Limits, fit_constants
from housefly.lab.identification.samples import samples_of
from housefly.messages import PilotStep
from housefly.messages.stick import Stick
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.twin.simulated_body import CONTROL_PERIOD
from housefly.twin.world import SimulatedWorld

RUNS = int(sys.argv[1]) if len(sys.argv) > 1 else 100
REPEATS = 6
JUMP = 0.05
"""A tilt that changes by more than this in one tick is an edge of a block [rad]."""


def hidden(seed: int) -> dict[str, float]:
    random = np.random.default_rng(seed)
    return {
        "drone__attitude_lag": float(random.uniform(4.0, 10.0)),
        "drone__attitude_gain": float(random.uniform(0.85, 1.1)),
        "drone__drag": float(random.uniform(0.3, 0.8)),
        "drone__climb_lag": float(random.uniform(1.0, 3.0)),
        "twin__command_delay": float(random.uniform(0.04, 0.1)),
        "drone__yaw_lag": float(random.uniform(8.0, 25.0)),
    }


class NotingWorld(SimulatedWorld):
    """Notes when the drone heard a movement command."""

    def __init__(self, loaded: LoadedSite) -> None:
        self.heard_at: list[float] = []
        super().__init__(loaded.site, loaded.room)

    def set_stick(self, stick: Stick) -> None:
        """Note the time and pass it on."""
        self.heard_at.append(self.now)
        super().set_stick(stick)


def mean_wait(steps: list[PilotStep], heard_at: list[float]) -> float:
    """Return how long a changed tilt waited for the driver's next datagram, on average [s]."""
    now = np.array([step.now for step in steps])
    tilts = np.array(
        [(step.outputs.command.setpoint.theta, step.outputs.command.setpoint.phi) for step in steps]
    )
    changed = now[1:][np.abs(np.diff(tilts, axis=0)).max(axis=1) > JUMP]
    heard = np.array(heard_at)
    return float(np.mean(heard[np.searchsorted(heard, changed - 1e-6)] - changed))


def residence(pole: float) -> float:
    """Return how far a loop sampled once a period lags behind on average [s]; its error keeps a
    share after each period.
    """
    kept = 1.0 - pole * CONTROL_PERIOD
    return 0.5 * CONTROL_PERIOD * (1.0 + kept) / (1.0 - kept)


def delay_of(command_delay: float) -> float:
    """Return the time from a datagram to the tilt [s]: the delay, the firmware's next period, and
    its inner rate loop.
    """
    return float(
        CONTROL_PERIOD * np.ceil(command_delay / CONTROL_PERIOD - 1e-9) + residence(RATE_POLE)
    )


def one(seed: int) -> tuple[dict[str, tuple[float, float, float, float]], str]:
    """Fly and fit one drone; return each constant (truth, value, low, high) and the outcome."""
    tracking = {"twin__mocap_rate_hz": 30.0, "twin__mocap_dropout": 0.05, "twin__seed": seed}
    truth = hidden(seed)
    believed, real = (
        open_site(read_site("bsen", **tracking)),
        open_site(read_site("bsen", **tracking, **truth)),
    )
    plan = blocks(REPEATS, believed.site.limits.tilt_max)
    box = find_box(believed.grid, believed.room.home, 0.65, believed.site.map.flight_height)
    maneuver, world = IdentificationManeuver(plan, box), NotingWorld(real)
    steps: list[PilotStep] = []
    outcome = fly_identification_lockstep(
        believed, world, IdentificationFlight(box, maneuver, 500.0), steps.append
    )
    if outcome != "completed":
        return {}, outcome
    found = fit_constants(
        samples_of(steps, tuple(maneuver.flown), "ardrone"), Limits(0.21, 0.7, 1.75), seed
    )
    lags = {
        "attitude_lag": truth["drone__attitude_lag"],
        "attitude_gain": truth["drone__attitude_gain"],
        "drag": truth["drone__drag"],
        "climb_lag": truth["drone__climb_lag"],
        # Turning has no inner loop; the model gives it the delay of the tilt all the same, and what
        # that is too long goes here.
        "yaw_lag": 1.0 / (residence(truth["drone__yaw_lag"]) - residence(RATE_POLE)),
        "command_delay": delay_of(truth["twin__command_delay"]) + mean_wait(steps, world.heard_at),
    }
    found_by_key = ((key, value, found.constants[key]) for key, value in lags.items())
    rows = {
        key: (value, interval.value, interval.low, interval.high)
        for key, value, interval in found_by_key
    }
    return rows, "; ".join(found.problems)


def main() -> None:
    start = time.monotonic()
    with ProcessPoolExecutor(2) as pool:
        results = list(pool.map(one, range(RUNS)))
    flown = [rows for rows, _ in results if rows]
    refused = sum(1 for rows, problems in results if problems)
    print("### Identification: 95 % intervals on drones with hidden constants\n")
    cells = []
    for key in flown[0]:
        truth, value, low, high = np.array([rows[key] for rows in flown]).T
        held = np.mean((low <= truth) & (truth <= high))
        error = np.sqrt(np.mean((value - truth) ** 2))
        bias, half = np.mean(value - truth), np.mean(0.5 * (high - low))
        cells.append(
            (
                key,
                f"{100 * held:.0f} %",
                f"{held / 0.9:.2f}",
                f"{error:.3g}",
                f"{bias:.2g}",
                f"{half:.3g}",
            )
        )
    print(
        table(
            (
                "constant",
                "held the truth",
                "over the goal (90 %)",
                "rms error",
                "bias",
                "mean half interval",
            ),
            cells,
        )
    )
    print(
        f"\n{len(flown)} flights of the simulated room (MuJoCo), {REPEATS} blocks of each kind,"
        f" tracking at 30 Hz with 1 mm noise and 5 % loss; {refused} refused or given up."
        f" {time.monotonic() - start:.0f} s on two processes."
    )


if __name__ == "__main__":
    main()
