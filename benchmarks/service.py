"""The whole service in lock step with the twin: mode default against mode paper, at tracking rates
from 100 to 10 Hz.
"""

from __future__ import annotations

import time
from pathlib import Path
from statistics import mean
from tempfile import TemporaryDirectory

from _run import table
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.series import collect
from housefly.record.summary import Summary, summarize_flight
from housefly.record.truth import read_truth
from housefly.sites.loaded_site import LoadedSite, open_site, read_site

SEEDS = (1, 2, 3)
CASES = ((100.0, 0.02, 0.0), (30.0, 0.02, 0.2), (10.0, 0.05, 0.0), (10.0, 0.1, 0.3))


def fly(loaded: LoadedSite) -> tuple[Summary, float]:
    """Fly one service; return its summary and the flight seconds per second of processor time."""
    steps: list[PilotStep] = []
    order = Order(OrderKind.SERVICE, "entrance", look_s=3.0)
    with TemporaryDirectory() as folder:
        course = Path(folder) / "truth.jsonl"
        start = time.process_time()
        outcome = fly_lockstep(loaded, order, steps.append, truth_file=course)
        speed = steps[-1].now / (time.process_time() - start)
        truth = read_truth(course)
    flight = collect(steps, loaded.site.tracking.body)
    site, room, grid = loaded.site, loaded.room, loaded.grid
    return summarize_flight(flight, outcome, site, room, grid, truth=truth), speed


def row(mode: str, rate: float, latency: float, loss: float) -> list[object]:
    """Fly one case with every seed and return its row."""
    changes = {
        "twin__mocap_rate_hz": rate,
        "twin__mocap_latency": latency,
        "twin__mocap_dropout": loss,
    }
    flown = [
        fly(open_site(read_site("bsen", mode=mode, twin__seed=seed, **changes))) for seed in SEEDS
    ]
    summaries = [summary for summary, _ in flown]
    done = sum(summary.outcome == "completed" for summary in summaries)

    def average(key: str, unit: float = 0.001) -> str:
        values: list[float | None] = [getattr(summary, key) for summary in summaries]
        known: list[float] = [value for value in values if value is not None]
        return f"{mean(known) / unit:.0f}" if len(known) == len(values) else "-"

    return [
        mode,
        f"{rate:.0f} Hz, {1000 * latency:.0f} ms, {loss:.0%} lost",
        f"{done} of {len(SEEDS)}",
        average("duration_s", unit=1.0),
        average("rms_error_m"),
        average("max_error_m"),
        average("arrival_error_m"),
        average("landed_error_m"),
        f"{mean(s.behavior_switches_per_s or 0.0 for s in summaries):.1f}",
        f"{mean(speed for _, speed in flown):.0f}",
    ]


def main() -> None:
    """Print the table."""
    print(
        "### The service: home to the entrance and back, with pilot, firmware, physics and"
        " tracking, stepped clock\n"
    )
    headings = [
        "mode", "tracking: rate, latency, loss", "completed", "duration [s]",
        "rms off the path [mm]", "largest [mm]",
        "off the goal [mm]", "landed off the pad [mm]", "state switches per s",
        "flight seconds per core-second",
    ]  # fmt: skip
    print(table(headings, [row(mode, *case) for case in CASES for mode in ("default", "paper")]))
    print(
        f"\nMeans over seeds {', '.join(map(str, SEEDS))}. Errors are of the true place against the"
        " planned path."
    )


if __name__ == "__main__":
    main()
