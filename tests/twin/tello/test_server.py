"""The simulated Tello on its ports, asked and flown by lines, on a stepped clock."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from math import hypot

import pytest
import pytest_asyncio

pytest.importorskip("mujoco")

from tello_ports import tello_ports

from housefly.config.site import Site, changed
from housefly.errors import ConfigError, LinkError
from housefly.room.model import Place, Room
from housefly.twin.contracts import EncodedPicture, FlightState
from housefly.twin.tello.server import TelloServer
from housefly.twin.world import SimulatedWorld
from housefly.wires.tello.lines import COMMAND_PORT, STATE_PORT, VIDEO_PORT
from housefly.wires.tello.pieces import PictureJoiner
from housefly.wires.tello.state import TelloState, decode_state

pytestmark = [pytest.mark.wire]

HALL = Room(
    "hall",
    (0.0, 0.0, 12.0, 5.0),
    2.6,
    (),
    (Place("home", (2.0, 2.5), (3.0, 2.5, 1.0)),),
    (),
    (2.0, 2.5),
    0.0,
    None,
)
AIR = (FlightState.FLYING, FlightState.HOVERING)


class Client(asyncio.DatagramProtocol):
    """A client that says lines and keeps what comes."""

    def __init__(self, world: SimulatedWorld, address: str) -> None:
        self.world, self.address = world, address
        self.answers: list[str] = []
        self.states: list[TelloState] = []
        self.pieces: list[bytes] = []

    async def open(self) -> None:
        loop = asyncio.get_running_loop()
        self.talk, _ = await loop.create_datagram_endpoint(
            lambda: Ear(lambda data: self.answers.append(data.decode())),
            local_addr=(self.address, 0),
            remote_addr=(self.address, COMMAND_PORT),
        )
        for port, hear in (
            (STATE_PORT, lambda data: self.states.append(decode_state(data))),
            (VIDEO_PORT, self.pieces.append),
        ):
            await loop.create_datagram_endpoint(
                lambda hear=hear: Ear(hear), local_addr=(self.address, port)
            )

    def say(self, line: str) -> None:
        self.talk.sendto(line.encode())

    async def lasts(self, seconds: float) -> None:
        """Let the world run; the server sees each twentieth of a second of it."""
        for _ in range(max(1, round(20 * seconds))):
            self.world.advance(0.05)
            await asyncio.sleep(0.022)

    async def answer(self, line: str, patience: float = 25.0) -> str:
        """Say a line; return what is answered first."""
        self.answers.clear()
        self.say(line)
        await self.until(lambda: bool(self.answers), patience)
        return self.answers[0]

    async def until(self, holds: Callable[[], bool], patience: float = 25.0) -> None:
        for _ in range(round(20 * patience)):
            await self.lasts(0.05)
            if holds():
                return
        raise AssertionError(f"not within {patience} s: {self.states[-1:]}, {self.answers}")


class Ear(asyncio.DatagramProtocol):
    def __init__(self, hear: Callable[[bytes], object]) -> None:
        self.hear = hear

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        self.hear(data)


@pytest.fixture
def world() -> SimulatedWorld:
    return SimulatedWorld(changed(Site(), drone__kind="tello"), HALL)


@pytest_asyncio.fixture
async def client(world: SimulatedWorld, loopback: str) -> AsyncIterator[Client]:
    with tello_ports():
        server = TelloServer(world, loopback)
        await server.start()
        speaker = Client(world, loopback)
        speaker.server = server
        await speaker.open()
        yield speaker
        await server.stop()


async def test_it_is_silent_until_it_is_greeted_and_then_tells_ten_states_a_second(client) -> None:
    client.say("battery?")
    client.say("nonsense")
    await client.lasts(0.5)
    assert not client.answers and not client.states
    assert await client.answer("command") == "ok"
    client.states.clear()
    await client.lasts(2.0)
    assert 18 <= len(client.states) <= 22
    assert client.states[-1].bat == 100 and client.states[-1].tof == 10
    assert {state.time for state in client.states} == {0}, "its motors stand"


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("battery?", "100"),
        ("sdk?", "20"),
        ("time?", "0s"),
        ("tof?", "100mm"),
        ("attitude?", "pitch:0;roll:0;yaw:0;"),
        ("speed 50", "ok"),
        ("forward 100", "error Motor stop"),
        ("land", "error"),
        ("flip l", "error"),
        ("rc 0 0 0 900", "error"),
    ],
)
async def test_it_answers_and_refuses_as_a_tello_does(client, line: str, answer: str) -> None:
    await client.answer("command")
    assert await client.answer(line) == answer


async def test_a_flight_by_lines(client, world: SimulatedWorld) -> None:
    def place() -> tuple[float, float, float]:
        return world.truth().pose.position

    await client.answer("command")
    client.answers.clear()
    client.say("takeoff")
    await client.until(lambda: world.onboard().flight is FlightState.TAKING_OFF)
    assert await client.answer("land") == "error", "a landing is not heard while it takes off"
    client.answers.clear()
    await client.until(lambda: "ok" in client.answers)
    assert world.onboard().flight in AIR and place()[2] > 0.8
    assert client.states[-1].time >= 2 and client.states[-1].tof > 70

    x, y, z = place()
    assert await client.answer("forward 100") == "ok"
    assert hypot(place()[0] - x - 1.0, place()[1] - y) < 0.2
    assert await client.answer("ccw 90") == "ok"
    assert world.truth().pose.yaw == pytest.approx(1.57, abs=0.15)
    assert await client.answer("up 40") == "ok"
    assert place()[2] == pytest.approx(z + 0.4, abs=0.15)

    x, y, _ = place()
    client.answers.clear()
    client.say("rc 0 50 0 0")
    await client.lasts(3.0)
    assert world.truth().velocity[1] == pytest.approx(0.75, abs=0.1), "the last sticks hold"
    assert client.answers == [], "sticks are never answered"
    client.say("rc 0 0 0 0")
    await client.lasts(2.5)
    assert hypot(*world.truth().velocity[:2]) < 0.1, "centred sticks stop it"

    assert await client.answer("land") == "ok"
    assert world.onboard().flight is FlightState.LANDED
    assert await client.answer("takeoff") == "ok", "and it takes off again"
    assert await client.answer("emergency") == "ok"
    await client.until(lambda: world.onboard().flight is FlightState.EMERGENCY)
    assert world.onboard().motors == (0.0, 0.0, 0.0, 0.0)


@pytest.mark.interop
async def test_in_silence_it_flies_on_for_fifteen_seconds_and_then_lands(
    client, world: SimulatedWorld
) -> None:
    await client.answer("command")
    await client.answer("takeoff")
    client.say("rc 0 20 0 0")
    await client.lasts(1.0)
    spoken = world.now
    await client.until(lambda: world.onboard().flight is FlightState.LANDING, 20.0)
    assert 13.5 < world.now - spoken < 14.5, "15 s after the sticks"
    assert world.truth().pose.position[0] > 4.5, "meanwhile it flew on"
    await client.until(lambda: world.onboard().flight is FlightState.LANDED)
    assert await client.answer("takeoff") == "ok", "a client that is back may fly it again"


async def test_its_pictures_leave_in_pieces_once_they_are_asked_for(client) -> None:
    picture = EncodedPicture(1, b"\0\0\0\1\x65" + b"\x99" * 4000, True, 960, 720, 0.0)
    await client.answer("command")
    client.server.publish(picture)
    await client.lasts(0.1)
    assert client.pieces == []
    assert await client.answer("streamon") == "ok"
    client.server.publish(picture)
    await client.lasts(0.1)
    joiner = PictureJoiner()
    assert [len(piece) for piece in client.pieces] == [1460, 1460, 1085]
    assert [got for piece in client.pieces for got in joiner.feed(piece)] == [picture.data]
    assert await client.answer("streamoff") == "ok"
    client.server.publish(picture)
    await client.lasts(0.1)
    assert len(client.pieces) == 3 and client.server.counters.frames_sent == 1


async def test_garbage_is_refused_counted_and_changes_nothing(client) -> None:
    await client.answer("command")
    for noise in (b"\xff" * 40, b"", b"rc " * 200, b"takeoff\0"):
        client.talk.sendto(noise)
    await client.lasts(0.3)
    assert client.server.counters.malformed >= 3
    assert await client.answer("battery?") == "100"


async def test_a_taken_address_is_told_in_words(client, world, loopback: str) -> None:
    with pytest.raises(LinkError, match=f"cannot serve a Tello at {loopback}:8889"):
        await TelloServer(world, loopback).start()


def test_only_loopback_is_served_unless_asked(world) -> None:
    with pytest.raises(ConfigError, match=r"drone\.address: is 192\.168\.10\.1"):
        TelloServer(world, "192.168.10.1")
    TelloServer(world, "192.168.10.1", beyond_loopback=True)
