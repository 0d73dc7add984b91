"""The visitor service flown by ArduCopter's own program, all processes, over its own MAVLink.

    ARDUCOPTER=PATH unshare -rn sh -c 'ip link set lo up; python benchmarks/their_service.py'

Judged on the truth of the room. Without ARDUCOPTER our simulated vehicle flies. ``--noise`` is of
the tracking [m], ``--kill`` kills the driver's process so long after the order [s].
"""

from __future__ import annotations

import argparse
import os
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.lab.lockstep.service_monitor import ServiceMonitor
from housefly.messages import Order, OrderKind, PilotStep
from housefly.record.truth import read_truth
from housefly.sites.loaded_site import load_site

_READY_TIME, _SERVICE_TIME = 120.0, 240.0
"""Longest wait for everything to answer, longest service [s]."""
_ORDERS, _REFUSED_WITHIN = 8, 5.0
"""An order that is refused, on a machine that is late, is given again so often; and when [s]."""


def fly(options: argparse.Namespace) -> str:
    """Fly one service; return how it ended, in a line."""
    loaded = load_site(
        "bsen", drone__kind="arducopter", drone__address="127.62.0.1",
        tracking__address="127.62.0.1", drone__has_video=False, twin__video=False,
        twin__seed=options.seed, twin__mocap_noise=options.noise,
        hub__enabled=False, tasks__enabled=False,
    )  # fmt: skip
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        runtime, truth = new_runtime(loaded.site, folder), folder / "truth.jsonl"
        topics, done = DroneTopics(loaded.site.drone.name), threading.Event()
        with (
            Launcher(runtime, folder, processes_of(runtime, truth_file=truth)),
            ZenohBus(connect=runtime.bus) as bus,
        ):
            missing = Readiness(runtime.site(), bus, web=False, video=False).wait(_READY_TIME)
            if missing:
                return f"not ready: {missing}"
            time.sleep(options.settle)
            begun = time.monotonic()
            monitor = ServiceMonitor(begun, loaded.room.home, _SERVICE_TIME)
            phases: list[tuple[float, str]] = []
            said: list[str] = []

            def heard(step: PilotStep) -> None:
                nonlocal monitor
                monitor = monitor.updated(step)
                phase = step.outputs.phase.value
                if not phases or phases[-1][1] != phase:
                    phases.append((round(time.monotonic() - begun, 1), phase))
                said.extend(str(event.text) for event in step.outputs.events)
                if monitor.outcome:
                    done.set()

            bus.subscribe(topics.step, heard)
            for _ in range(_ORDERS):
                done.clear()
                begun = time.monotonic()
                monitor = ServiceMonitor(begun, loaded.room.home, _SERVICE_TIME)
                order = Order(
                    OrderKind.SERVICE, "entrance", look_s=3.0, issued_at=begun, sender="benchmark"
                )
                bus.publish(topics.order, order)
                if not (done.wait(_REFUSED_WITHIN) and "refused" in monitor.outcome):
                    break
            if options.kill:
                time.sleep(options.kill)
                _kill_driver(folder)
            done.wait(_SERVICE_TIME + 10.0)
            took = time.monotonic() - begun
        found = read_truth(truth)
        touched = "unknown" if found is None else len(found.contacts)
        stalls = (folder / "twin.log").read_text().rpartition("dropped, ")[2].strip()
        own = "ArduCopter's program" if os.environ.get("ARDUCOPTER") else "our simulated one"
        return (
            f"{own}, seed {options.seed}, noise {1000 * options.noise:g} mm: "
            f"{monitor.outcome or 'no end'} after {took:.0f} s, {touched} contacts;"
            f" {phases}; {said}; {stalls}"
        )


def _kill_driver(folder: Path) -> None:
    """Kill the driver of this run, as a crash would."""
    listed = subprocess.run(["ps", "-eo", "pid,args"], capture_output=True, text=True, check=True)
    for line in listed.stdout.splitlines():
        pid, _, args = line.strip().partition(" ")
        if "housefly.app.driver_main" in args and f"housefly.app.child {os.getpid()} " in args:
            os.kill(int(pid), signal.SIGKILL)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seed", type=int, default=1, help="of all noise")
    parser.add_argument("--noise", type=float, default=0.001, help="of the tracking [m]")
    parser.add_argument("--kill", type=float, default=0.0, help="kill the driver after this [s]")
    parser.add_argument("--settle", type=float, default=25.0, help="wait before the order [s]")
    print(fly(parser.parse_args()))


if __name__ == "__main__":
    main()
