"""How well each model of drone flies in the simulated room, on the truth: a hover, a figure eight,
ten errands from place to place, and the visitor service with one seed after the other.

    python benchmarks/drones.py                          every model, about 10 minutes each
    python benchmarks/drones.py --models tello --seeds 3
    python benchmarks/drones.py --models crazyflie --no-service
    python benchmarks/drones.py --wires --seeds 3        the services over real wires, in real time
"""

from __future__ import annotations

import argparse
import sys
import time
from contextlib import closing
from dataclasses import dataclass, replace

import numpy as np

from _run import table
from housefly import fly, load_site
from housefly.config.airframe import airframe_names
from housefly.numeric import FloatArray
from housefly.record.summary import Summary
from quality_gate.errands import BSEN_ERRANDS
from quality_gate.flown_row import FlownRow
from quality_gate.flown_track import COLUMNS
from quality_gate.fly import fly_row
from quality_gate.quality_flight import QualityFlight
from quality_gate.rooms import GateRoom, gate_site
from quality_gate.rows import GATE_ROWS
from quality_gate.scenario import Scenario, Way

HOVER_TIME = 20.0
PLACE, LOOK_S = "table", 3.0
_X, _RX = COLUMNS.index("x"), COLUMNS.index("rx")
_ROWS = {row.name: row for row in GATE_ROWS}
_EIGHT = _ROWS["eight-100"]
_ERRANDS = replace(_ROWS["errands-0.5"], name="ten errands", goals=BSEN_ERRANDS[:10])


@dataclass(frozen=True, slots=True)
class Hover:
    """A hover of ``HOVER_TIME``: how far it truly was from where it should be [m]."""

    rms: float
    most: float


def hovered(model: str) -> Hover | None:
    """Hover in the middle of the hall; None where it did not rise."""
    flight = QualityFlight(gate_site(GateRoom.HALL, drone__kind=model))
    if not flight.rise():
        return None
    first = len(flight.track.rows)
    flight.wait(HOVER_TIME)
    away = _off_reference(flight.track.part(first))
    return Hover(float(np.sqrt(np.mean(away**2))), float(away.max()))


def _off_reference(rows: FloatArray) -> FloatArray:
    away: FloatArray = rows[:, _X : _X + 3] - rows[:, _RX : _RX + 3]
    distance: FloatArray = np.sqrt(np.sum(away**2, axis=1))
    return distance


def flown(row: Scenario, model: str) -> FlownRow:
    """Fly a row of the flight-quality gate by trajectories in space."""
    return fly_row(row, Way.SPACE, model, {"drone__kind": model})


def served(model: str, seed: int, *, lockstep: bool) -> Summary:
    """Fly the visitor service; over real wires with all processes of a run, in real time."""
    address = f"127.58.{airframe_names().index(model)}.{1 + seed % 250}"
    at = {"drone__address": address, "tracking__address": address}
    loaded = load_site("bsen", drone__kind=model, twin__seed=seed, twin__video=False, **at)
    with closing(fly(PLACE, loaded, lockstep=lockstep, look_s=LOOK_S)) as flight:
        return flight.summary


def _quality_row(model: str) -> list[object]:
    hover, eight, errands = hovered(model), flown(_EIGHT, model), flown(_ERRANDS, model)
    return [
        model,
        f"{1000 * hover.rms:.0f} / {1000 * hover.most:.0f}" if hover else "did not rise",
        *(_cell(one) for one in (eight, errands)),
        f"{errands.measures.time:.0f}",
        f"{1000 * errands.measures.overshoot:.0f}",
        f"{errands.measures.gap:.2f}",
        eight.outcome or errands.outcome or "all arrived",
    ]


def _cell(row: FlownRow) -> str:
    measures = row.measures
    off = f"{1000 * measures.reference_rms:.0f} / {1000 * measures.reference_max:.0f}"
    return f"{measures.arrived:.0f} of {measures.legs:.0f}: {off}"


def _service_row(model: str, seeds: int, *, lockstep: bool) -> list[object]:
    done, touched, errors, landed = 0, 0, list[float](), list[float]()
    ended = set[str]()
    for seed in range(1, seeds + 1):
        summary = served(model, seed, lockstep=lockstep)
        contacts = len(summary.contacts or ())
        _tell(f"{model}, seed {seed}: {summary.outcome}, {contacts} contacts")
        done += summary.outcome == "completed"
        touched += contacts
        errors += [] if summary.rms_error_m is None else [summary.rms_error_m]
        landed += [] if summary.landed_error_m is None else [summary.landed_error_m]
        ended |= {str(summary.outcome)}
    rms = f"{1000 * min(errors):.0f} to {1000 * max(errors):.0f}" if errors else "-"
    off_pad = f"{1000 * max(landed):.0f}" if landed else "-"
    return [model, f"{done} of {seeds}", touched, rms, off_pad, ", ".join(sorted(ended))]


def _tell(words: str) -> None:
    print(f"[{time.strftime('%H:%M:%S')}] {words}", file=sys.stderr, flush=True)


def main() -> None:
    """Fly and print."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    known = airframe_names()
    parser.add_argument("--models", nargs="+", default=known, choices=known, metavar="MODEL")
    parser.add_argument("--seeds", type=int, default=20, help="of the service (default: 20)")
    parser.add_argument("--no-service", action="store_true", help="hover, eight and errands only")
    parser.add_argument("--no-quality", action="store_true", help="the service only")
    parser.add_argument("--wires", action="store_true", help="the service only, over real wires")
    wanted = parser.parse_args()
    print("### How well each drone flies, on the truth\n")
    if not (wanted.no_quality or wanted.wires):
        headings = [
            "model", "hover of 20 s off its place rms / max [mm]",
            "figure eight at 0.5 m/s, off its reference [mm]",
            "ten errands at 0.5 m/s, off their reference [mm]", "time of them [s]",
            "overshoot [mm]", "hull to solid [m]", "outcome",
        ]  # fmt: skip
        rows = []
        for model in wanted.models:
            rows.append(_quality_row(model))
            _tell(f"{model}: {rows[-1]}")
        print(table(headings, rows), "\n", flush=True)
    if not wanted.no_service:
        headings = [
            "model", "services completed", "contacts", "rms off the path [mm]",
            "landed off the pad, most [mm]", "outcomes",
        ]  # fmt: skip
        rows = [
            _service_row(model, wanted.seeds, lockstep=not wanted.wires) for model in wanted.models
        ]
        print(table(headings, rows))


if __name__ == "__main__":
    main()
