"""Two simulators of the field flying their own position loops, beside ours, on one core.

The peers are installed into environments of their own by ``python benchmarks/simulators.py
--install`` (about 2 GB); without them the benchmark says so and prints ours alone.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
import venv
from pathlib import Path

import numpy as np

from _run import table
from housefly.config.site import Site
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import FlightPlan, Task

HERE = Path(__file__).resolve().parent
PEERS = {"rotorpy": "rotorpy==3.0.0", "crazyflow": "crazyflow==0.4.0"}
COUNTS = {"rotorpy": ((1, 10.0),), "crazyflow": ((1, 5.0), (100, 2.0), (10_000, 0.2))}
"""Drones and how long they fly [s]: the slower, the shorter."""
ALONE = {
    "OMP_NUM_THREADS": "1",
    "XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false",
    "JAX_PLATFORMS": "cpu",
    "MPLBACKEND": "agg",
}
MISSION = FlightPlan(Task.PATH, ((0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (6.0, 2.0)), 20.0)


def python_of(peer: str) -> Path:
    return HERE / ".peers" / peer / "bin" / "python"


def install() -> None:
    for peer, package in PEERS.items():
        print(f"installing {package} ...", flush=True)
        venv.create(python_of(peer).parents[1], with_pip=True)
        subprocess.run([str(python_of(peer)), "-m", "pip", "install", "-q", package], check=True)


def peer_rate(peer: str, count: int, seconds: float) -> float:
    """Return drone-seconds per core-second of a peer."""
    command = [str(python_of(peer)), str(HERE / f"_peer_{peer}.py"), str(count), str(seconds)]
    done = subprocess.run(
        command, capture_output=True, text=True, check=False, env={**os.environ, **ALONE}
    )
    if done.returncode:
        sys.exit(f"{peer} failed:\n{done.stderr}")
    return float(done.stdout.split()[-1])


def our_rate(count: int) -> float:
    """Return drone-seconds per core-second of ours."""
    fleet = cases(Site(), count, seed=np.arange(count))
    fly_many(fleet[:1], MISSION, threads=1)
    start = time.process_time()
    flown = fly_many(fleet, MISSION, threads=1)
    return float(flown["ended_at"].sum()) / (time.process_time() - start)


def main() -> None:
    if "--install" in sys.argv:
        return install()
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    ours = {count: our_rate(count) for count in (1, 100, 10_000)}
    rows = [("Housefly", count, f"{rate:,.0f}", "1") for count, rate in ours.items()]
    missing = [peer for peer in PEERS if not python_of(peer).exists()]
    for peer in (peer for peer in PEERS if peer not in missing):
        for count, seconds in COUNTS[peer]:
            rate = peer_rate(peer, count, seconds)
            rows.append((PEERS[peer], count, f"{rate:,.1f}", f"{ours[count] / rate:,.0f}"))
    print("### Simulators: drone-seconds per core-second with a position loop, one core\n")
    print(table(("simulator", "drones", "drone-seconds per core-second", "ours / theirs"), rows))
    print(
        "\nNot the same work: ours is the reduced-order drone with lag, drag, delays, late noisy"
        " tracking, filter, acceptor, control and gate at 100 Hz; rotorpy integrates a rigid body"
        " under its SE(3) controller with its motion capture at 100 Hz; crazyflow integrates a"
        " rigid body at 500 Hz under its position controller at 100 Hz with the true state. This is"
        " what one core does for a campaign of missions."
    )
    if missing:
        print(
            f"\nNot installed, so not measured: {', '.join(missing)} (`python"
            " benchmarks/simulators.py --install`)."
        )


if __name__ == "__main__":
    main()
