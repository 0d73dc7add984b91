"""The simulated tracking system: frames at a rate, noisy, some lost, each arriving late."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.lab.experiments.random import RandomState, exponential, normal, uniform
from housefly.numeric import compiled, wrapped
from housefly.pilot.control.model import DroneState, between
from housefly.pilot.estimation.height_yaw import YAW_NOISE_RATIO

FRAME = np.dtype([(name, "f8") for name in ("captured_at", "received_at", "x", "y", "z", "yaw")])
"""One sighting on its way to the pilot: times [s], position [m], heading [rad]."""
FRAMES = 1024
"""Sightings that can be under way; more are lost."""
Frames = NDArray[Any]
"""Ring of ``FRAMES`` sightings."""


class Camera(NamedTuple):
    """How the tracking system sees.

    Attributes:
        rate_hz: frames per second.
        phase: of the first frame, as a share of the interval.
        latency, jitter: from exposure to arrival, and the mean of what comes on top [s].
        noise: one sigma of a coordinate [m].
        dropout: share of frames lost.
    """

    rate_hz: float
    phase: float
    latency: float
    jitter: float
    noise: float
    dropout: float


class Stream(NamedTuple):
    """How many frames were exposed, sent and delivered, and the times of the next [s]."""

    exposed: int
    sent: int
    delivered: int
    next_at: float
    arrived_at: float


@compiled
def stream_begun(camera: Camera) -> Stream:
    """Return the stream before its first frame."""
    return Stream(
        exposed=0, sent=0, delivered=0, next_at=camera.phase / camera.rate_hz, arrived_at=0.0
    )


@compiled
def exposed(
    stream: Stream,
    camera: Camera,
    frames: Frames,
    random: RandomState,
    before: DroneState,
    after: DroneState,
    start: float,
    dt: float,
) -> Stream:
    """Return the stream after dt [s] from ``start`` [s], with what was exposed sent off."""
    while stream.next_at < start + dt:
        frame = stream.exposed
        following = (frame + 1 + camera.phase) / camera.rate_hz
        at = stream.next_at
        lost = camera.dropout > 0.0 and uniform(random) < camera.dropout
        if lost or stream.sent - stream.delivered >= frames.size:
            stream = Stream(
                exposed=frame + 1,
                sent=stream.sent,
                delivered=stream.delivered,
                next_at=following,
                arrived_at=stream.arrived_at,
            )
            continue
        late = exponential(random, camera.jitter) if camera.jitter > 0.0 else 0.0
        arrival = max(stream.arrived_at, at + camera.latency + late)
        x, y, z, yaw = between(before, after, dt, at - start)
        _write(
            frames[stream.sent & (frames.size - 1)], camera.noise, random, at, arrival, x, y, z, yaw
        )
        stream = Stream(
            exposed=frame + 1,
            sent=stream.sent + 1,
            delivered=stream.delivered,
            next_at=following,
            arrived_at=arrival,
        )
    return stream


@compiled
def is_due(stream: Stream, frames: Frames, now: float) -> bool:
    """Return whether a sighting has arrived that was not delivered yet."""
    return (
        stream.delivered < stream.sent
        and frames[stream.delivered & (frames.size - 1)].received_at <= now
    )


@compiled
def delivered(stream: Stream) -> Stream:
    """Return the stream with one more sighting delivered."""
    return Stream(
        exposed=stream.exposed,
        sent=stream.sent,
        delivered=stream.delivered + 1,
        next_at=stream.next_at,
        arrived_at=stream.arrived_at,
    )


@compiled
def _write(
    frame: Any,
    noise: float,
    random: RandomState,
    at: float,
    arrival: float,
    x: float,
    y: float,
    z: float,
    yaw: float,
) -> None:
    frame.captured_at, frame.received_at = at, arrival
    frame.x, frame.y, frame.z, frame.yaw = x, y, z, yaw
    if noise > 0.0:
        frame.x, frame.y, frame.z = (
            x + noise * normal(random),
            y + noise * normal(random),
            z + noise * normal(random),
        )
        frame.yaw = wrapped(yaw + YAW_NOISE_RATIO * noise * normal(random))
