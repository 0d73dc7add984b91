"""Senders that send too much are dropped and named; the loop and the other senders go on."""

from __future__ import annotations

import asyncio
import time
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from housefly.bus.codec import decoded
from housefly.bus.endpoint import endpoint_in
from housefly.bus.topics import DroneTopics, Topic
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.tracking import TrackingConfig
from housefly.messages import Order, OrderKind, Sighting
from housefly.tracking.rate_limit import FRAMES_PER_SECOND_MAX
from housefly.tracking.vicon import ViconTracker
from housefly.wires.vicon import (
    FrameInfo,
    GlobalSegments,
    ObjectEnums,
    StreamInfo,
    encode_packet,
)

TOPICS = DroneTopics()

pytestmark = pytest.mark.wire
OFFERED = frozenset({StreamInfo.KIND, FrameInfo.KIND, GlobalSegments.KIND})


async def test_a_flood_of_vicon_frames_does_not_hold_the_loop(loopback: str) -> None:
    frames = b"".join(encode_packet([FrameInfo(number)]) for number in range(1, 20_000))

    async def flood(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(encode_packet([ObjectEnums(OFFERED)]))
        with suppress(OSError):
            while True:
                writer.write(frames)
                await writer.drain()

    server = await asyncio.start_server(flood, loopback, 8010)
    tracker = ViconTracker(TrackingConfig(address=loopback))
    told: list[tuple[Sighting, ...]] = []
    running = asyncio.create_task(tracker.run(told.append))
    turns, end = 0, time.monotonic() + 1.5
    while time.monotonic() < end:
        await asyncio.sleep(0)
        turns += 1
    assert tracker.counts.flooded > FRAMES_PER_SECOND_MAX
    assert tracker.counts.frames <= 3 * FRAMES_PER_SECOND_MAX
    assert "more than 2000 frames a second" in tracker.problem
    assert turns > 200, "the loop hardly turned"
    running.cancel()
    server.close()
    await asyncio.gather(running, return_exceptions=True)


def test_a_message_that_is_too_long_is_dropped_before_it_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tmp_path.chmod(0o700)
    endpoint = endpoint_in(tmp_path)
    heard: list[Order] = []
    read: list[int] = []

    def noted(topic: Topic[Any], payload: bytes) -> object:
        read.append(len(payload))
        return decoded(topic, payload)

    monkeypatch.setattr("housefly.bus.zenoh_bus.decoded", noted)
    wide_open = replace(TOPICS.order, fault=lambda _: "")
    with ZenohBus(listen=endpoint) as bus, ZenohBus(connect=endpoint) as other:
        bus.subscribe(TOPICS.order, heard.append)
        end = time.monotonic() + 20.0
        while not heard and time.monotonic() < end:
            other.publish(TOPICS.order, Order(OrderKind.HOVER))
            time.sleep(0.05)
        heard.clear()
        for length in (300_000, 30_000_000):
            other.publish(wide_open, Order(OrderKind.GO, "x" * length))
        other.publish(wide_open, Order(OrderKind.GO, goal=(1e308, 1e308)))
        other.publish(TOPICS.order, Order(OrderKind.LAND, sender="last"))
        while not any(order.sender == "last" for order in heard) and time.monotonic() < end:
            time.sleep(0.02)
    assert {order.kind for order in heard} <= {OrderKind.HOVER, OrderKind.LAND}
    assert heard[-1].sender == "last"
    assert 0 < max(read) <= TOPICS.order.max_size
