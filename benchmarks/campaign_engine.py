"""The campaign engine beside the same loop in scalar C (benchmarks/engine_in_c), compiled with -O3:
same drones, same numbers.
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from _run import table
from housefly.config.site import Site
from housefly.geometry import GRAVITY
from housefly.lab.experiments import airframe, loop, measure, random, tracking_noise
from housefly.lab.experiments.cases import CASE, cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.experiments.outcomes import OUTCOME
from housefly.lab.experiments.route import Route, route_of
from housefly.pilot.behavior import nose, ride
from housefly.pilot.control import model
from housefly.pilot.estimation import filter as kalman
from housefly.pilot.estimation import height_yaw, horizon, intake, lagged_axis

FOLDER = Path(__file__).parent / "engine_in_c"
COMPILER = (
    "gcc",
    "-O3",
    "-march=native",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-shared",
    "-fPIC",
)
"""No contraction and no fast mathematics: the numbers must be the same."""
MISSION = FlightPlan(Task.PATH, ((0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (6.0, 2.0)), 20.0)
GOAL, SHARE_GOAL, CLOSE = 40_000, 0.5, 1e-6
FLEETS = ((1, 100.0), (100, 100.0), (10_000, 100.0), (10_000, 30.0))
"""Drones, and the rate of their tracking [Hz]."""
REPEATS = 3

CONSTANTS: dict[str, float] = {
    "GRAVITY": GRAVITY,
    "HOVER_DOUBT": lagged_axis.HOVER_VARIANCE_FACTOR,
    "DISTURBANCE_MAX": lagged_axis.DISTURBANCE_LIMIT,
    "FIRST_VELOCITY_VARIANCE": lagged_axis.INITIAL_VELOCITY_VARIANCE,
    "FIRST_DISTURBANCE": lagged_axis.INITIAL_DISTURBANCE,
    "LONGEST_PREDICTION": horizon.PREDICTION_STEP_MAX,
    "NO_TIME": horizon.TIME_TOLERANCE,
    "ALIKE": horizon.SPAN_TOLERANCE,
    "CLIMB_NOISE": height_yaw.CLIMB_PROCESS_NOISE,
    "TURN_NOISE": height_yaw.YAW_PROCESS_NOISE,
    "YAW_PER_METRE": height_yaw.YAW_NOISE_RATIO,
    "BLIND_REACH": height_yaw.EXTRAPOLATION_MAX,
    "FIRST_RATE_VARIANCE": height_yaw.INITIAL_RATE_VARIANCE,
    "GATE_SIGMAS": height_yaw.INNOVATION_GATE_SIGMAS,
    "GATE_FLOOR": height_yaw.POSITION_GATE_FLOOR,
    "GATE_FLOOR_YAW": height_yaw.YAW_GATE_FLOOR,
    "FUTURE_TOLERANCE": intake.CLOCK_TOLERANCE,
    "OLDEST": intake.SIGHTING_AGE_MAX,
    "HOVER_BRAKE_BELIEVED": kalman.HOVER_BRAKING,
    "WANDER": kalman.DISTURBANCE_WANDER,
    "HOVER_BRAKE": model.HOVER_BRAKE,
    "LONGEST_STEP": airframe.LONGEST_STEP,
    "GUST_TIME": airframe.GUST_TIME,
    "ACCELERATION": ride.REFERENCE_ACCELERATION,
    "LOOK_AHEAD": ride.HEADING_LOOKAHEAD,
    "KEEP_HEADING": ride.HEADING_FREEZE,
    "PATIENCE": ride.LAG_MAX,
    "YAW_SLEW": nose.YAW_REFERENCE_RATE,
    "LONGEST_TICK": loop.LONGEST_TICK,
    "LAST": measure.LAST,
    "FAR": measure.FAR,
    "LOST": measure.LOST,
    "QUIET": measure.QUIET,
    "PERIOD": measure.PERIOD,
    "TAIL": random.TAIL,
}


class CRoute(ctypes.Structure):
    """``Route`` of chain.h."""

    _fields_ = (
        *(
            (name, ctypes.c_void_p)
            for name in ("points", "marks", "speeds", "along", "headings", "cells", "line")
        ),
        *((name, ctypes.c_int64) for name in ("corners", "waypoints", "ends")),
        *(
            (name, ctypes.c_double)
            for name in ("last_x", "last_y", "height", "yaw", "arrival_yaw", "settle", "duration")
        ),
    )


def record(name: str, dtype: np.dtype[Any]) -> str:
    """Return a record of eight-byte numbers as a C struct."""
    fields = " ".join(
        f"{'int64_t' if dtype[field] == np.int64 else 'double'} {field};"
        for field in dtype.names or ()
    )
    return f"typedef struct {{ {fields} }} {name};"


def header() -> str:
    """Return what the C code takes from the Python sources."""
    edges = ", ".join(float(edge).hex() for edge in random.EDGES)
    return "\n".join(
        [
            *(f"#define {name} {float(value).hex()}" for name, value in CONSTANTS.items()),
            f"#define ORDERS {airframe.ORDERS}\n#define FRAMES {tracking_noise.FRAMES}",
            f"static const double EDGES[] = {{{edges}}};",
            record("Case", CASE),
            record("Outcome", OUTCOME),
            record("Score", measure.SCORE),
        ]
    )


def built(folder: Path) -> Any:
    """Compile the C code and return its ``fly_rows``."""
    (folder / "generated.h").write_text(header())
    library = folder / "engine.so"
    subprocess.run(
        [*COMPILER, f"-I{folder}", str(FOLDER / "flight.c"), "-o", str(library), "-lm"], check=True
    )
    fly_rows = ctypes.CDLL(str(library)).fly_rows
    fly_rows.restype = None
    fly_rows.argtypes = [
        ctypes.c_void_p,
        *[ctypes.c_int64] * 2,
        ctypes.POINTER(CRoute),
        ctypes.c_int64,
        ctypes.c_void_p,
    ]
    return fly_rows


def c_route(route: Route) -> CRoute:
    """Return a route as the C code reads it; the arrays stay where they are."""
    way = route.way
    arrays = (*way, route.cells, route.line)
    numbers = (
        route.last_x,
        route.last_y,
        route.height,
        route.yaw,
        route.arrival_yaw,
        route.settle,
        route.duration,
    )
    return CRoute(
        *(a.ctypes.data for a in arrays),
        len(way.points),
        len(route.cells),
        len(route.line),
        *numbers,
    )


def timed(
    fly: Callable[[], NDArray[Any]], clock: Callable[[], float] = time.process_time
) -> tuple[float, NDArray[Any]]:
    """Return the best time of some runs [s], of the processor unless another clock is given, and
    what came out.
    """
    times: list[float] = []
    outcome = None
    for _ in range(REPEATS):
        start = clock()
        outcome = fly()
        times.append(clock() - start)
    assert outcome is not None
    return min(times), outcome


def furthest(ours: NDArray[Any], theirs: NDArray[Any]) -> float:
    """Return the largest difference of any measure of any drone; both not a number is none."""
    pairs = ((ours[name], theirs[name]) for name in OUTCOME.names or ())
    if any((np.isnan(a) != np.isnan(b)).any() for a, b in pairs):
        return float("inf")
    return max(
        float(np.nanmax(np.abs(ours[name] - theirs[name]), initial=0.0))
        for name in OUTCOME.names or ()
    )


def main() -> None:
    route = route_of(MISSION)
    rows, worst, share, reached = [], 0.0, 0.0, 0.0
    with tempfile.TemporaryDirectory() as folder:
        fly_rows = built(Path(folder))
        for count, rate_hz in FLEETS:
            fleet = cases(
                Site(), count, seed=np.arange(count), mocap_rate_hz=rate_hz, mocap_dropout=0.05
            )
            ring = len(loop.desk(fleet).spans)
            flown = np.zeros(count, OUTCOME)
            given = c_route(route)

            def in_c(
                fleet: Any = fleet, ring: int = ring, flown: Any = flown, given: CRoute = given
            ) -> NDArray[Any]:
                fly_rows(
                    fleet.ctypes.data, 0, len(fleet), ctypes.byref(given), ring, flown.ctypes.data
                )
                return flown

            theirs_s, theirs = timed(in_c)
            ours_s, ours = timed(lambda fleet=fleet: fly_many(fleet, MISSION, threads=1))
            two_s, _ = timed(
                lambda fleet=fleet: fly_many(fleet, MISSION, threads=2), time.perf_counter
            )
            flight_s = float(ours["ended_at"].sum())
            worst = max(worst, furthest(ours, theirs))
            share, reached = theirs_s / ours_s, flight_s / ours_s
            rates = (f"{flight_s / seconds:,.0f}" for seconds in (ours_s, two_s, theirs_s))
            rows.append(
                (count, f"{rate_hz:.0f} Hz", *rates, f"{share:.2f}", f"{reached / GOAL:.2f}")
            )
    print(
        "### The campaign engine: drone-seconds per core-second, the whole loop in double"
        " precision\n"
    )
    print(
        table(
            (
                "drones",
                "tracking",
                "ours",
                "ours, 2 threads, per second",
                "C -O3",
                "ours / C",
                "ours / goal (40 000)",
            ),
            rows,
        )
    )
    print(
        "\nMode default, pilot at 100 Hz, noise, jitter, 5 % of frames lost,"
        f" {MISSION.duration:.0f} s each; best of {REPEATS}. Largest difference of any measure of"
        f" any drone between ours and C: {worst:.1g} (limit {CLOSE:g}). C:"
        f" `{' '.join(COMPILER[:4])}`."
    )
    if worst > CLOSE:
        sys.exit("the two engines do not fly the same flights")


if __name__ == "__main__":
    main()
