"""The true course of a flight, as a file."""

from __future__ import annotations

import json
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from housefly.record.truth import read_truth
from housefly.room.model import Room, Solid
from housefly.twin.truth_log import TRUTH_RATE_HZ, TruthLog
from housefly.twin.world import SimulatedWorld


def test_samples_come_at_their_rate_and_are_the_truth(
    tmp_path: Path, make_world: Callable[..., SimulatedWorld]
) -> None:
    world = make_world()
    path, clock = tmp_path / "truth.jsonl", lambda: world.now + 100.0
    with closing(TruthLog(world, path, clock)) as log:
        for _ in range(200):
            world.advance(0.005)
            log.sample()
    truth = read_truth(path)
    assert truth is not None
    assert len(truth.time) == pytest.approx(TRUTH_RATE_HZ, abs=1)
    assert 100.0 < truth.time[0] < 100.1
    assert truth.position[-1] == pytest.approx(world.truth().pose.position, abs=1e-4)
    assert not truth.airborne.any()
    assert truth.contacts == ()


def test_on_a_full_disk_the_file_ends_and_the_room_goes_on(
    make_world: Callable[..., SimulatedWorld],
) -> None:
    world, told = make_world(), list[str]()
    with closing(TruthLog(world, Path("/dev/full"), lambda: world.now, told.append)) as log:
        for _ in range(200):
            world.advance(0.005)
            log.sample()
    (line,) = told
    assert line.endswith("/dev/full: No space left on device")
    told.clear()
    TruthLog(world, Path("/proc/none/truth.jsonl"), lambda: world.now, told.append).sample()
    assert len(told) == 1


def test_a_contact_is_told_with_whom_when_and_how_fast(
    tmp_path: Path, make_room: Callable[..., Room], make_world: Callable[..., SimulatedWorld],
    wall: Solid, hand: type,
) -> None:  # fmt: skip
    world = make_world(make_room(solids=(wall,)))
    path = tmp_path / "truth.jsonl"
    with closing(TruthLog(world, path, lambda: world.now)) as log:
        sticks = hand(world)
        sticks.hover()
        for _ in range(40):
            sticks.fly(forward=0.5, seconds=0.1)
            log.sample()
    truth = read_truth(path)
    assert truth is not None and truth.contacts
    contact, true = truth.contacts[0], world.contact_log[0]
    assert (contact.kind, contact.name) == (true.kind.value, true.name)
    assert contact.at_s == pytest.approx(true.began_at, abs=0.01)
    assert contact.speed == pytest.approx(true.speed, abs=0.001) and contact.speed > 0.1
    assert contact.motors_turned
    assert len(truth.contacts) == len(world.contact_log)
    assert truth.solid.min() == 0.0


def test_a_line_that_was_cut_off_is_left_out(tmp_path: Path) -> None:
    path = tmp_path / "truth.jsonl"
    line = {"at": 1.0, "position": [0, 0, 1], "airborne": True, "solid": 0.5, "person": None}
    path.write_text(json.dumps(line) + "\n" + json.dumps(line)[:30])
    truth = read_truth(path)
    assert truth is not None and len(truth.time) == 1
    assert read_truth(tmp_path / "nothing.jsonl") is None
