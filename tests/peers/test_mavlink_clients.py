"""PyPI pymavlink (mavutil) and MAVSDK fly the simulated ArduCopter and PX4 as real ones."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from dataclasses import dataclass
from math import cos, nan, pi, sin
from typing import Any

import pytest

from housefly.clock import RealClock
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import FlightState
from housefly.twin.mavlink.server import MavlinkServer, Px4Server
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.world import SimulatedWorld

mavsdk = pytest.importorskip("mavsdk")
mavutil = pytest.importorskip("pymavlink.mavutil")
from mavsdk.asyncio.plugins.action import ActionAsync  # noqa: E402
from mavsdk.asyncio.plugins.mocap import MocapAsync  # noqa: E402
from mavsdk.asyncio.plugins.telemetry import TelemetryAsync  # noqa: E402
from mavsdk.plugins.mocap import (  # noqa: E402
    AngleBody,
    Covariance,
    PositionBody,
    VisionPositionEstimate,
)

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]
SERVERS = {"arducopter": MavlinkServer, "px4": Px4Server}


@dataclass
class Served:
    """A simulated drone on its ports in real time."""

    world: SimulatedWorld
    server: MavlinkServer
    address: str
    highest: float = 0.0

    @property
    def flight(self) -> FlightState:
        return self.world.onboard().flight

    def place_ned(self) -> tuple[float, float, float]:
        x, y, z = self.world.truth().pose.position
        return y, x, -z

    def heading_ned(self) -> float:
        return pi / 2 - self.world.truth().pose.yaw

    async def until(self, holds: Callable[[], bool], patience: float = 15.0) -> None:
        async with asyncio.timeout(patience):
            while not holds():
                self.highest = max(self.highest, self.world.truth().pose.position[2])
                await asyncio.sleep(0.02)


@pytest.fixture
async def served(request: pytest.FixtureRequest, loopback: str) -> AsyncIterator[Served]:
    loaded = load_site("bsen", drone__kind=request.param)
    world = SimulatedWorld(loaded.site, loaded.room)
    server = SERVERS[request.param](world, loopback)
    await server.start()
    running = asyncio.create_task(RealTimeRunner(world, RealClock()).run())
    try:
        yield Served(world, server, loopback)
    finally:
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)
        await server.stop()


def fly_with_mavutil(uri: str, twin: Served) -> dict[str, Any]:
    """Connect, be refused, be told where it is, arm, take off, move, land."""
    link = mavutil.mavlink_connection(uri, source_system=255)
    found: dict[str, Any] = {}

    def pump(seconds: float, until: Callable[[], Any] = lambda: None) -> Any:
        end, beat = time.monotonic() + seconds, 0.0
        while time.monotonic() < end:
            if time.monotonic() > beat:
                beat = time.monotonic() + 1.0
                link.mav.heartbeat_send(6, 8, 0, 0, 4)
            if found.get("sees"):
                x, y, z = twin.place_ned()
                turn, nothing = 0.5 * twin.heading_ned(), [float("nan")] * 21
                link.mav.odometry_send(
                    int(time.monotonic() * 1e6), 20, 12, x, y, z, [cos(turn), 0, 0, sin(turn)],
                    0, 0, 0, 0, 0, 0, nothing, nothing,
                )  # fmt: skip
            if found.get("asks"):
                link.mav.set_position_target_local_ned_send(
                    0, 1, 1, 8, 0x5C7, 0, 0, 0, *found["asks"], 0, 0, 0, 0, 0
                )
            while (message := link.recv_match()) is not None:
                if message.get_type() == "STATUSTEXT":
                    found.setdefault("said", []).append(message.text)
                if message.get_type() == "COMMAND_ACK":
                    found.setdefault("acks", []).append((message.command, message.result))
            if answer := until():
                return answer
            time.sleep(0.02)
        return None

    def order(command: int, *parameters: float) -> int:
        found["acks"] = []
        link.mav.command_long_send(1, 1, command, 0, *parameters, *(0,) * (7 - len(parameters)))
        return pump(3.0, lambda: found["acks"] and found["acks"][-1])[1]

    assert pump(5.0, lambda: link.messages.get("HEARTBEAT")), "no heartbeat"
    link.target_system, link.target_component = 1, 1
    found["version"] = order(512, 148)
    found["first try"] = order(400, 1)
    found["sees"] = True
    pump(0.5)
    link.mav.set_gps_global_origin_send(1, 450000000, 70000000, 0)
    pump(0.3)
    link.set_mode(link.mode_mapping()["GUIDED"])
    pump(2.0, lambda: link.flightmode == "GUIDED")
    found["mode"] = link.flightmode
    found["armed"] = order(400, 1)
    found["take-off"] = order(22, 0, 0, 0, 0, 0, 0, 1.0)
    pump(12.0, lambda: link.messages["EXTENDED_SYS_STATE"].landed_state == 2)
    found["asks"] = (0.4, 0.0, 0.0)
    before = twin.place_ned()
    pump(2.5)
    after, ahead = twin.place_ned(), twin.heading_ned()
    found["moved"] = cos(ahead) * (after[0] - before[0]) + sin(ahead) * (after[1] - before[1])
    found["asks"] = (0.0, 0.0, 0.0)
    pump(0.5)
    found["asks"] = None
    found["land"] = order(21)
    pump(12.0, lambda: not link.motors_armed())
    found["disarmed"] = not link.motors_armed()
    link.close()
    return found


@pytest.mark.parametrize("served", ["arducopter"], indirect=True)
@pytest.mark.parametrize("uri", ["tcp:{}:5760", "udpout:{}:14550"])
async def test_mavutil_arms_takes_off_moves_and_lands_it(served: Served, uri: str) -> None:
    found = await asyncio.to_thread(fly_with_mavutil, uri.format(served.address), served)
    assert found["first try"] == 4 and "Arm: Need Position Estimate" in found["said"]
    assert (found["mode"], found["armed"], found["take-off"], found["land"]) == (
        "GUIDED", 0, 0, 0,
    )  # fmt: skip
    assert found["moved"] > 0.5 and found["disarmed"]
    assert served.flight is FlightState.LANDED and served.server.broken == 0


async def fly_with_mavsdk(uri: str, twin: Served) -> None:
    """Connect, tell it where it is, arm, take off, land."""
    kind = mavsdk.ComponentType.GROUND_STATION
    async with mavsdk.asyncio.Mavsdk(
        mavsdk.Configuration.create_with_component_type(kind)
    ) as ground:
        await ground.add_any_connection(uri)
        system = await ground.first_autopilot(timeout_s=10.0)
        assert system is not None
        action, mocap, telemetry = ActionAsync(system), MocapAsync(system), TelemetryAsync(system)

        async def tell() -> None:
            while True:
                x, y, z = twin.place_ned()
                await mocap.set_vision_position_estimate(
                    VisionPositionEstimate(
                        int(time.monotonic() * 1e6),
                        PositionBody(x, y, z),
                        AngleBody(0.0, 0.0, twin.heading_ned()),
                        Covariance([nan]),
                    )
                )
                await asyncio.sleep(0.03)

        telling = asyncio.create_task(tell())
        try:
            await asyncio.sleep(0.5)
            await action.set_gps_global_origin(45.0, 7.0, 0.0)
            await action.arm()
            await action.takeoff()
            await twin.until(lambda: twin.flight is FlightState.HOVERING)
            assert await telemetry.in_air()
            await action.land()
            await twin.until(lambda: not twin.server.vehicle.armed)
            await settled(telemetry.armed, False)
        finally:
            telling.cancel()


async def settled(ask: Callable[[], Awaitable[Any]], wanted: Any) -> None:
    async with asyncio.timeout(5.0):
        while await ask() != wanted:
            await asyncio.sleep(0.1)


@pytest.mark.parametrize("served", ["px4"], indirect=True)
async def test_mavsdk_arms_takes_off_and_lands_it(served: Served) -> None:
    await fly_with_mavsdk(f"udpout://{served.address}:14580", served)
    assert served.highest > 0.9
    assert served.flight is FlightState.LANDED and served.server.broken == 0
