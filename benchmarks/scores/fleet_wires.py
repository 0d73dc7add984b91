"""Flies a service with each of several drones at once over real wires: all processes, real time."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import inf, isfinite
from pathlib import Path

import numpy as np

from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.errors import LinkError
from housefly.hub.api.pilot_queries import PreflightView
from housefly.hub.api.pilot_queries_json import from_json
from housefly.lab.lockstep.service_monitor import ServiceMonitor
from housefly.lab.lockstep.simulation import sites_of_drones
from housefly.messages import Order, PilotStep
from housefly.messages.event_code import EventCode
from housefly.record.truth import TRUTH_FILE, judged_outcome, read_truth
from housefly.sites.loaded_site import LoadedSite
from scores.fleet_flight import WAITING_MAX, FlownService

_READY_TIMEOUT = 90.0
"""All processes answer within this [s]."""
_SETTLING_TIME = 3.0
"""How long the drones stand before they are ordered anything [s]."""


@dataclass
class _Heard:
    """What one pilot published since its order.

    Attributes:
        due: when the service is to be ordered [s].
        home: its pad [m].
        patience: how long the service may take [s].
        monitor: of the service; None until an order was taken.
        late: how late each step began [s].
    """

    due: float
    home: tuple[float, float]
    patience: float
    monitor: ServiceMonitor | None = None
    late: list[float] = field(default_factory=list)

    @property
    def outcome(self) -> str:
        """What became of the service; "" while it goes on."""
        return self.monitor.outcome if self.monitor else ""

    def has_waited(self, now: float) -> bool:
        """Return whether the drone was not ready for too long."""
        return now > self.due + WAITING_MAX

    def order(self, order: Order, now: float) -> Order:
        """Return the order as it is given now [s]."""
        self.monitor = ServiceMonitor(now, self.home, self.patience, grace=5.0)
        return replace(order, issued_at=now)

    def take(self, step: PilotStep) -> None:
        """Follow the service by a step; those of before the order do not count."""
        self.late.append(step.inputs.late)
        monitor = self.monitor
        if monitor is None or step.now < monitor.started_at or monitor.outcome:
            return
        codes = [event.code for event in step.outputs.events]
        # What the list said is up to half a second old: who is refused on the pad asks again.
        is_refused = EventCode.ORDER_REFUSED in codes and not monitor.seen
        asks_again = is_refused and not self.has_waited(step.now)
        self.monitor = None if asks_again else monitor.updated(step)


@dataclass(frozen=True, slots=True)
class WiredServices:
    """What became of the services.

    Attributes:
        flown: by the drone's name.
        late: 99th percentile of how late the pilots' steps began [s], by the drone's name.
    """

    flown: dict[str, FlownService]
    late: dict[str, float]


def fly_services_over_wires(
    loaded: LoadedSite, orders: Mapping[str, Order], after: Mapping[str, float], patience: float
) -> WiredServices:
    """Fly the services that are ordered by all processes of a site, and judge them by the truth.

    Args:
        loaded: a site with several drones.
        orders: what each drone flies.
        after: how much later than the first each is ordered [s].
        patience: how long the whole may take [s].

    Raises:
        LinkError: a process does not answer.
    """
    homes = {name: own.room.home for name, own in sites_of_drones(loaded).items()}
    with tempfile.TemporaryDirectory() as at:
        folder = Path(at)
        runtime = new_runtime(loaded.site, folder)
        truth_file = folder / TRUTH_FILE
        processes = processes_of(runtime, truth_file=truth_file)
        with Launcher(runtime, folder, processes) as launcher:
            with ZenohBus(connect=runtime.bus) as bus:
                missing = Readiness(runtime.site(), bus, web=False, video=False).wait(
                    _READY_TIMEOUT
                )
                if missing:
                    raise LinkError(missing)
                heard = _flown(bus, orders, after, homes, patience)
            launcher.stop()
        return WiredServices(
            {
                name: _judged(one, truth_file.with_stem(f"{truth_file.stem}-{name}"), homes[name])
                for name, one in heard.items()
            },
            {name: float(np.percentile(one.late, 99)) for name, one in heard.items()},
        )


def _flown(
    bus: ZenohBus,
    orders: Mapping[str, Order],
    after: Mapping[str, float],
    homes: Mapping[str, tuple[float, float]],
    patience: float,
) -> dict[str, _Heard]:
    began = time.monotonic() + _SETTLING_TIME
    heard = {name: _Heard(began + after.get(name, 0.0), homes[name], patience) for name in orders}
    listening = [bus.subscribe(DroneTopics(name).step, heard[name].take) for name in orders]
    while not all(one.outcome for one in heard.values()):
        now = time.monotonic()
        for name, one in heard.items():
            is_due = one.monitor is None and now >= one.due
            if is_due and (one.has_waited(now) or _may_fly(bus, name)):
                bus.publish(DroneTopics(name).order, one.order(orders[name], time.monotonic()))
        if now > began + patience:
            break
        time.sleep(0.01)
    time.sleep(1.0)
    for reader in listening:
        reader.close()
    return heard


def _may_fly(bus: ZenohBus, drone: str) -> bool:
    """Return whether a drone is ready, as the tasks ask before they order."""
    try:
        return from_json(PreflightView, bus.ask(DroneTopics(drone).preflight, "", 0.5)).ready
    except LinkError:  # a busy machine: it is asked again
        return False


def _judged(heard: _Heard, path: Path, home: tuple[float, float]) -> FlownService:
    truth = read_truth(path)
    assert truth is not None, path
    contacts = tuple(one for one in truth.contacts if one.motors_turned)
    x, y, _ = truth.position[-1]
    off_pad = float(np.hypot(x - home[0], y - home[1]))
    outcome = judged_outcome(heard.outcome or "not done", contacts, off_pad)
    flying = truth.time[truth.airborne]
    return FlownService(
        outcome,
        float(flying[-1] - flying[0]) if len(flying) else 0.0,
        contacts,
        _nearest_drone(path),
        min((one for one in truth.person[truth.airborne].tolist() if isfinite(one)), default=inf),
    )


def _nearest_drone(path: Path) -> float:
    """Return how near the hull came to another's in the air [m]."""
    samples = (json.loads(line) for line in path.read_text().splitlines() if '"airborne"' in line)
    return min((one["drone"] for one in samples if one["airborne"] and one["drone"]), default=inf)
