"""A drone that flies along x beside its own report and its tracking, without a world."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import cos, exp, inf, isnan, pi, sin, sqrt

import numpy as np
from ardrone_flow import FLOW

from housefly.config.airframe import airframe_named
from housefly.geometry import quaternion_from_euler
from housefly.messages import DroneStatus, Pose, Sighting, Telemetry
from housefly.pilot.estimation.displacement import OdometryTolerance
from housefly.pilot.estimation.tracking_monitor import TrackingMonitor
from housefly.pilot.safety.tracking_rules import DRIFT_LAND, DRIFT_LASTS, DRIFT_WARN

TICK = 0.01
_SONAR = airframe_named("ardrone").sonar
_DELAY_TICKS = 4
_KEEP = exp(-TICK / FLOW.bias_time)


@dataclass(frozen=True)
class FeltFlight:
    """What happens in a flight; every function is of the time [s].

    Attributes:
        speed: true, along x [m/s].
        turning: [rad/s].
        lie: what tracking adds along y [m].
        flow: what becomes of a reported velocity [m/s].
        reports: whether the report of this moment comes.
        sees: whether tracking sees the drone.
        clock: of the drone [s]; nan where it tells none.
        seen_every, told_every: time between two poses, and two reports [s].
        way_error: of the odometry that is tolerated.
        seed: of all noise.
    """

    speed: Callable[[float], float] = lambda t: 0.0
    turning: Callable[[float], float] = lambda t: 0.0
    lie: Callable[[float], float] = lambda t: 0.0
    flow: Callable[[float, float], float] = lambda t, v: v
    reports: Callable[[float], bool] = lambda t: True
    sees: Callable[[float], bool] = lambda t: True
    clock: Callable[[float], float] | None = None
    seen_every: float = 0.02
    told_every: float = 0.02
    way_error: float = 0.05
    seed: int = 0


@dataclass
class Judgement:
    """What the monitor said.

    Attributes:
        drifts: time [s], lie [m] and drift [m] at every pose.
        frame_error: the greatest [rad].
        mirrored: whether it ever said so.
    """

    drifts: list[tuple[float, float, float]] = field(default_factory=list)
    frame_error: float = 0.0
    mirrored: bool = False

    def lie_when(self, drift: float) -> float:
        """Return how large the lie was when this drift was first said [m]; inf for never."""
        return next((lie for _, lie, said in self.drifts if said > drift), inf)

    @property
    def lie_when_landing(self) -> float:
        """Return how large the lie was when a rule of the gate lands the drone [m]."""
        since = inf
        for at, lie, said in self.drifts:
            since = min(since, at) if said > DRIFT_WARN else inf
            if said > DRIFT_LAND or at - since >= DRIFT_LASTS:
                return lie
        return inf

    @property
    def is_silent_at_the_end(self) -> bool:
        """Whether nothing could be said of the last pose."""
        return isnan(self.drifts[-1][2])

    @property
    def largest(self) -> float:
        """The largest drift that was said [m]."""
        return max((said for _, _, said in self.drifts if not isnan(said)), default=0.0)


def judged(flight: FeltFlight, seconds: float) -> Judgement:
    """Return what the monitor says of a flight of so many seconds."""
    rng, monitor = (
        np.random.default_rng(flight.seed),
        TrackingMonitor(OdometryTolerance(0.002, flight.way_error, FLOW), 0.58, _SONAR),
    )
    judgement, past = Judgement(), [0.0] * (_DELAY_TICKS + 1)
    x = psi = next_seen = next_told = 0.0
    bias, drive = np.zeros(2), FLOW.bias * sqrt(1.0 - _KEEP * _KEEP)
    for tick in range(int(seconds / TICK)):
        t = tick * TICK
        x += TICK * flight.speed(t)
        psi += TICK * flight.turning(t)
        past = [*past[1:], flight.speed(t)]
        bias = _KEEP * bias + drive * rng.standard_normal(2)
        noise = FLOW.noise * rng.standard_normal(2)
        if t >= next_told - 1e-9:
            next_told += flight.told_every
            if flight.reports(t):
                forward = flight.flow(t, past[0] * cos(psi) + bias[0] + noise[0])
                left = flight.flow(t, -past[0] * sin(psi) + bias[1] + noise[1])
                monitor.feel(_report(t, psi, forward, left, flight), DroneStatus.FLYING, 0.0)
        if t >= next_seen - 1e-9:
            next_seen += flight.seen_every
            if flight.sees(t):
                place = (x, flight.lie(t), 1.0) + 0.001 * np.append(rng.standard_normal(2), 0.0)
                _judge(monitor, _seen(t, place, psi), judgement, flight.lie(t))
    return judgement


def _report(t: float, psi: float, forward: float, left: float, flight: FeltFlight) -> Telemetry:
    return Telemetry(
        received_at=t,
        status=DroneStatus.FLYING,
        battery=0.8,
        phi=0.001 + 1e-6 * (t % 1.0),
        theta=0.001,
        psi=(psi + pi) % (2.0 * pi) - pi,
        height=1.0,
        velocity=(float(forward), float(left), 0.0),
        drone_time=flight.clock(t) if flight.clock else None,
    )


def _seen(t: float, place: np.ndarray, psi: float) -> Sighting:
    position = (float(place[0]), float(place[1]), float(place[2]))
    pose = Pose(position, quaternion_from_euler(0.0, 0.0, psi))
    return Sighting(body="drone", pose=pose, captured_at=t, received_at=t)


def _judge(monitor: TrackingMonitor, seen: Sighting, judgement: Judgement, lie: float) -> None:
    if monitor.agrees(seen, None):
        monitor.accept(seen)
    else:
        monitor.refuse(seen.captured_at)
    known = monitor.consistency(seen.captured_at)
    judgement.drifts.append((seen.captured_at, lie, known.drift))
    judgement.mirrored |= known.mirrored
    if not isnan(known.frame_error):
        judgement.frame_error = max(judgement.frame_error, abs(known.frame_error))
