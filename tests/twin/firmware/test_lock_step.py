"""The room in lock step with a program: a tiny one that speaks the same UDP."""

from __future__ import annotations

import itertools
import json
import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from fake_arducopter import packet, pulses

from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import FlightState
from housefly.twin.firmware.lock_step import LockStep
from housefly.twin.simulated_body import BodyState
from housefly.twin.world import SimulatedWorld

STANDING = BodyState((0.0, 0.0, 0.05), (1.0, 0.0, 0.0, 0.0), (0.0,) * 3, (0.0,) * 3, (0.0,) * 3)


class Hovering:
    """The fake, on a thread; ends when it is told, or after a number of frames."""

    def __init__(self, port: int, frames: int = 10**9) -> None:
        self.lines: list[bytes] = []
        self._room, self._frames = ("127.0.0.1", port), frames
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.settimeout(0.2)
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._fly)

    def start(self) -> None:
        self._thread.start()

    def stop(self) -> None:
        self._ends.set()
        self._thread.join()
        self._socket.close()

    def _fly(self) -> None:
        told = [1000] * 4
        for frame in range(self._frames):
            self._socket.sendto(packet(frame, told), self._room)
            line = self._line()
            if line is None:
                return
            self.lines.append(line)
            told = pulses(json.loads(line))

    def _line(self) -> bytes | None:
        while not self._ends.is_set():
            try:
                return self._socket.recv(65536)
            except TimeoutError:
                continue
        return None


@contextmanager
def hovering(frames: int = 10**9) -> Iterator[tuple[SimulatedWorld, LockStep, Hovering]]:
    """Yield a room whose drone the fake flies."""
    loaded = load_site("bsen", drone__kind="arducopter", twin__visitor_present=False)
    world = SimulatedWorld(loaded.site, loaded.room)
    steps = LockStep()
    program = Hovering(steps.port, frames)
    world.first.board(steps)
    program.start()
    try:
        yield world, steps, program
    finally:
        program.stop()
        steps.close()


def flown(seconds: float) -> list[tuple[float, ...]]:
    """Return where the drone was, ten times a second."""
    with hovering() as (world, steps, program):
        while not steps.steps:  # one physics step: the same one is its first, whenever it comes
            world.first.put()
            world.advance(0.0025)
        track: list[tuple[float, ...]] = []
        for _ in range(round(seconds / 0.1)):
            world.advance(0.1)
            track.append(world.truth().pose.position)
        assert not steps.broken and world.onboard().flight is FlightState.FLYING
        assert len(program.lines) <= steps.steps <= len(program.lines) + 1
        return track


def test_it_flies_up_and_stays_there() -> None:
    track = flown(8.0)
    home = track[0]
    assert track[-1][2] == pytest.approx(1.0, abs=0.05)
    assert track[-1][:2] == pytest.approx(home[:2], abs=0.1)


def test_the_same_program_flies_the_same_way_bit_for_bit() -> None:
    assert flown(1.0) == flown(1.0)


def test_its_clock_is_the_rooms_one_physics_step_an_answer() -> None:
    with hovering() as (world, steps, program):
        while not steps.steps:
            world.advance(0.005)
        world.advance(0.5)
        times = [json.loads(line)["timestamp"] for line in program.lines]
        assert {round(b - a, 9) for a, b in itertools.pairwise(times)} == {0.0025}


def test_where_the_program_ends_the_motors_stand_and_the_room_goes_on() -> None:
    with hovering(frames=2000) as (world, steps, _):
        steps.has_ended = lambda: steps.steps >= 2000
        while not steps.steps:
            world.advance(0.005)
        world.advance(8.0)
        assert steps.steps == 2000 and steps.missed > 0
        assert world.onboard().flight is FlightState.LANDED
        assert world.truth().pose.position[2] < 0.1


def test_what_is_no_servo_packet_is_counted_and_a_repeated_frame_moves_nothing() -> None:
    steps = LockStep()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as program:
        room = ("127.0.0.1", steps.port)
        for sent in (b"no", packet(7, [1500] * 4), packet(7, [2000] * 4), packet(8, [1000] * 4)):
            program.sendto(sent, room)
        assert steps.exchange(0.0, STANDING) == (0.5, 0.5, 0.5, 0.5)
        assert steps.exchange(0.0025, STANDING) == (0.0, 0.0, 0.0, 0.0)
    assert (steps.broken, steps.steps, steps.missed) == (1, 2, 0)
    steps.close()
