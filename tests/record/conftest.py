"""A small room and a made-up service in it: take-off, out, look, back, landing."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import hypot, sin
from typing import Any

import av
import numpy as np
import pytest

from housefly.config.site import Site, changed
from housefly.geometry import quaternion_from_euler
from housefly.messages import (
    Action,
    Behavior,
    Command,
    DroneStatus,
    Estimate,
    Event,
    EventCode,
    Inputs,
    Order,
    OrderKind,
    Outputs,
    Path,
    Phase,
    PilotStep,
    Pose,
    Reference,
    SafetyMode,
    Setpoint,
    Severity,
    Sighting,
    Telemetry,
    VideoFrame,
)
from housefly.room.grid import OccupancyGrid, build_grid
from housefly.room.model import Place, Room, Shape, Solid

RATE_HZ = 50.0
OFFSET = 0.05
"""How far beside its path the made-up drone flies [m]."""
PHASES = (
    (Phase.IDLE, 1.0),
    (Phase.TAKING_OFF, 2.0),
    (Phase.OUTBOUND, 8.0),
    (Phase.LOOKING, 3.0),
    (Phase.RETURNING, 8.0),
    (Phase.LANDING, 2.0),
    (Phase.IDLE, 1.0),
)
OUT = Path(((1.0, 1.0), (5.0, 1.0), (5.0, 3.0)), 6.0, 0.6)
BACK = Path(tuple(reversed(OUT.waypoints)), 6.0, 0.6)
STATUS = {
    Phase.TAKING_OFF: DroneStatus.TAKING_OFF,
    Phase.LANDING: DroneStatus.LANDING,
    Phase.IDLE: DroneStatus.LANDED,
}


def along(path: Path, share: float) -> tuple[float, float]:
    """Return the point at a share of the way along a path."""
    left = share * path.length
    for (x0, y0), (x1, y1) in zip(path.waypoints, path.waypoints[1:], strict=False):
        leg = hypot(x1 - x0, y1 - y0)
        if left <= leg:
            return x0 + (x1 - x0) * left / leg, y0 + (y1 - y0) * left / leg
        left -= leg
    return path.waypoints[-1]


@pytest.fixture(scope="session")
def site() -> Site:
    return changed(Site(), map__flight_height=1.0)


@pytest.fixture(scope="session")
def room() -> Room:
    walls = tuple(
        Solid(f"wall {number}", "wall", Shape.BOX, (x, y, 1.25), (length, width, 2.5))
        for number, (x, y, length, width) in enumerate(
            [(3.0, 0.0, 6.2, 0.1), (3.0, 4.0, 6.2, 0.1), (0.0, 2.0, 0.1, 4.0), (6.0, 2.0, 0.1, 4.0)]
        )
    )
    table = Solid("table", "table", Shape.BOX, (3.0, 2.6, 0.6), (1.4, 0.7, 1.2), yaw=0.3)
    lamp = Solid("lamp", "lamp", Shape.CYLINDER, (0.6, 3.4, 0.9), (0.4, 0.4, 1.8))
    places = (
        Place("home", (1.0, 1.0), (2.0, 1.0, 1.0)),
        Place("entrance", (5.0, 3.0), (6.0, 3.0, 1.2), "Entrance"),
    )
    return Room(
        "small room",
        (0.0, 0.0, 6.0, 4.0),
        2.5,
        (*walls, table, lamp),
        places,
        (),
        (1.0, 1.0),
        visitor=(5.7, 3.0),
    )


@pytest.fixture(scope="session")
def grid(room: Room, site: Site) -> OccupancyGrid:
    return build_grid(room, site)


def step_at(sequence: int, now: float, phase: Phase, share: float) -> PilotStep:
    path = {Phase.OUTBOUND: OUT, Phase.LOOKING: OUT, Phase.RETURNING: BACK}.get(phase)
    x, y = along(path, 1.0 if phase is Phase.LOOKING else share) if path else (1.0, 1.0)
    height = {
        Phase.IDLE: 0.1,
        Phase.TAKING_OFF: 0.1 + 0.9 * share,
        Phase.LANDING: 1.0 - 0.9 * share,
    }.get(phase, 1.0)
    pose = Pose((x, y + OFFSET, height), quaternion_from_euler(0.0, 0.0, 0.1 * share))
    status = STATUS.get(phase, DroneStatus.FLYING)
    started = phase is Phase.TAKING_OFF and share == 0.0
    return PilotStep(
        sequence,
        now,
        Inputs(
            sightings=(
                Sighting("ardrone", pose, now - 0.02, now - 0.001),
                Sighting("visitor", Pose((5.7, 3.0, 0.0)), now - 0.02, now),
            ),
            telemetry=Telemetry(now - 0.005, status, 0.9 - 0.004 * now, height=height),
            orders=(
                (Order(OrderKind.SERVICE, "entrance", issued_at=now, sender="test"),)
                if started
                else ()
            ),
        ),
        Outputs(
            command=Command(
                Action.FLY, Setpoint(0.1 * sin(now), 0.05 * sin(2 * now), 0.0, 0.2 * sin(now))
            ),
            estimate=Estimate(now, pose.position, (0.5, 0.0, 0.0), pose.yaw, 0.02, 0.004),
            reference=Reference((x, y, 1.0), (0.5, 0.0, 0.0), 0.0) if path else None,
            behavior=(
                Behavior.PATH_TRACKING
                if phase in (Phase.OUTBOUND, Phase.RETURNING)
                else Behavior.HOVER
            ),
            phase=phase,
            safety=(
                SafetyMode.HOLD
                if phase is Phase.RETURNING and 0.4 < share < 0.45
                else SafetyMode.NOMINAL
            ),
            goal_name="entrance" if phase in (Phase.OUTBOUND, Phase.LOOKING) else "",
            path=path,
            events=(
                (
                    Event(
                        now,
                        Severity.INFO,
                        EventCode.ORDER_ACCEPTED,
                        "taking off for <entrance> & back",
                    ),
                )
                if started
                else ()
            ),
        ),
    )


@pytest.fixture(scope="session")
def flight() -> tuple[PilotStep, ...]:
    """A whole service at 50 steps a second; times start at 100 s."""
    steps: list[PilotStep] = []
    for phase, duration in PHASES:
        count = int(duration * RATE_HZ)
        for index in range(count):
            number = len(steps)
            steps.append(step_at(number, 100.0 + number / RATE_HZ, phase, index / count))
    return tuple(steps)


def encoded(count: int, width: int = 64, height: int = 48) -> Iterator[tuple[bytes, bool]]:
    encoder: Any = av.CodecContext.create("libx264", "w")
    encoder.width, encoder.height, encoder.pix_fmt = width, height, "yuv420p"
    encoder.time_base, encoder.framerate = Fraction(1, 30), Fraction(30)
    encoder.options = {"preset": "ultrafast", "tune": "zerolatency", "g": "15"}
    for number in range(count):
        picture = np.full((height, width, 3), 5 * number % 255, dtype=np.uint8)
        frame = av.VideoFrame.from_ndarray(picture, format="rgb24")
        frame.pts = number
        for packet in encoder.encode(frame):
            yield bytes(packet), packet.is_keyframe


@pytest.fixture(scope="session")
def pictures() -> tuple[VideoFrame, ...]:
    """Two seconds of H.264 with a key frame every half second, arriving with a little jitter."""
    return tuple(
        VideoFrame(data, keyframe, 64, 48, number, 100.0 + number / 30.0 + 0.003 * (number % 3))
        for number, (data, keyframe) in enumerate(encoded(60))
    )
