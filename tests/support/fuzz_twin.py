"""Fuzz targets: the simulated room, how its run is found, and what its campaigns kept."""

from __future__ import annotations

import json
from collections.abc import Iterable
from math import isfinite
from pathlib import Path

from fuzz_target import DEEP, HUGE, FuzzTarget, as_file, scratch, split

from housefly import sites
from housefly.bus.simulated_bell import BellPress, press_from_json, press_to_json
from housefly.bus.simulated_room import (
    SimulatedAct,
    SimulatedDeed,
    SimulatedFault,
    SimulatedOutcome,
    act_from_json,
    act_to_json,
    outcome_from_json,
    outcome_to_json,
)
from housefly.errors import ConfigError, RecordingError, WireError
from housefly.hub.client.discovery import _read as read_announcement
from housefly.hub.things.catalogue import load_catalogue
from housefly.lab.safety_case.campaign import (
    RESULTS_FILE,
    WIRED_RESULTS_FILE,
    flown_results,
    wired_results,
)
from housefly.lab.safety_case.fault_phase import FaultPhase
from housefly.lab.safety_case.flown_by import FLOWN_BY_FILE, read_flown_by
from housefly.lab.safety_case.page import write_safety_case
from housefly.lab.safety_case.trial import TrialKey, TrialResult
from housefly.lab.safety_case.wired_flight import WiredKey, WiredResult
from housefly.messages.words import Words
from housefly.twin.faults.parse import parse_fault
from housefly.twin.hands import Carry, CarryOrder, decode_carry, encode_carry
from housefly.twin.people.scene import load_scene

_SITES = Path(sites.__file__).parent
_PEOPLE = b'name = "a"\nloop = true\npause = 0\n[[people]]\nname = "kim"\nstart = [1, 2]\n'
_SOURCE = b'{"source": "0123456789ab", "since": "2026-11-25 10:00"}'


def _things(data: bytes) -> None:
    with as_file(data, "things.toml") as path:
        load_catalogue(path)


def _things_seeds() -> Iterable[bytes]:
    yield (
        b'[[thing]]\nid = "cup"\nname = "the red cup"\naliases = ["mug"]\ninside = "cabinet"\n'
        b'[[thing]]\nid = "cabinet"\nkind = "furniture"\nposition = [2.0, 1.5, 0.9]\nyaw = 1.57\n'
        b'viewpoints = [{ name = "front", position = [2.0, 0.5, 1.2], yaw = 1.57 }]\n'
        b'facts = { doors = 2, open = false, colour = "red", load = 0.5 }\n'
    )
    yield (_SITES / "demo_things.toml").read_bytes()[:1500].rpartition(b"[[thing]]")[0]
    yield b'[[thing]]\nid = "a"\ninside = "b"\n[[thing]]\nid = "b"\ninside = "a"\n'
    yield b'[[thing]]\nid = "a"\nfacts = { b = ' + HUGE + b", c = nan, d = 2001-01-01 }"
    yield b'[[thing]]\nid = "a"\nyaw = ' + DEEP


def _scene(data: bytes) -> None:
    """A scene, where its people are and what they did at some times of a day."""
    with as_file(data, "scene.toml") as path:
        scene = load_scene(path.name, path.parent)
    for time in (0.0, 1.0, 100.0, 86_400.0):
        for person in scene.at(time).people:
            assert all(map(isfinite, person.position))
    scene.between(-1.0, 50.0)


def _scene_seeds() -> Iterable[bytes]:
    steps = (
        'do = "go"\nto = [3, 4]', 'do = "wait"\nseconds = 2', 'do = "vanish"',
        'do = "sit"\nat = [1, 1]\nseconds = 5', 'do = "lie"\nat = [1, 1]\nyaw = 1',
        'do = "take"\nthing = "cup"', 'do = "put"\nthing = "cup"\nat = [1, 2, 1]',
        'do = "open"\nwhat = "door"', 'do = "press"\nwhat = "door"', 'do = "appear"\nat = [1, 1]',
    )  # fmt: skip
    acts = "".join(f"[[people.steps]]\n{step}\n" for step in steps).encode()
    yield (
        _PEOPLE + acts + b'[[things]]\nname = "cup"\ntag = "E2"\ninside = "door"\n'
        b'[[devices]]\nkind = "door"\nid = "door"\nposition = [1, 2, 1]\n'
    )
    yield (_SITES / "bsen_scene.toml").read_bytes()[:2000].rpartition(b"[[")[0]
    yield _PEOPLE + b'steps = [{do = "wait", seconds = 1e-300}]'
    yield _PEOPLE + b'steps = [{do = "wait", seconds = 1e-9}]'
    yield _PEOPLE + b'steps = [{do = "take", thing = "a"}]'
    yield _PEOPLE + b"steps = [{do = " + HUGE + b"}]"
    yield b'name = "a"\nseed = ' + HUGE
    yield b"people = " + DEEP


def _carry(data: bytes) -> None:
    order = decode_carry(data)
    assert decode_carry(encode_carry(order)) == order
    for now in (1.0, 1.5, 100.0):
        position, *_ = Carry(order, (0.0, 0.0, 0.0), 0.0, 1.0).at(now)
        assert all(map(isfinite, position))


def _carry_seeds() -> Iterable[bytes]:
    yield encode_carry(CarryOrder((1.0, 2.0, 0.5), 1.5, 3.0))
    yield b'{"position": [' + HUGE + b', 0, 0], "yaw": 0, "duration": 1}'
    yield b'{"position": ["1", "_2", "nan"], "yaw": true, "duration": "0.1"}'
    yield b'{"position": ' + DEEP


def _bell(data: bytes) -> None:
    press = press_from_json(data.decode(errors="surrogateescape"))
    press_to_json(press)


def _bell_seeds() -> Iterable[bytes]:
    yield press_to_json(BellPress(True, "somebody presses it", 1.7e9, False)).encode()
    yield b'{"pressed": 1, "words": "\\ud800", "at": ' + HUGE + b"}"
    yield b'{"pressed": ' + DEEP


def _simulated(data: bytes) -> None:
    """What is done to a simulated room behind a 0, what came of it behind anything else."""
    text = data[1:].decode(errors="surrogateescape")
    if data[:1] == b"\0":
        act_to_json(act_from_json(text))
    else:
        outcome_to_json(outcome_from_json(text))


def _simulated_seeds() -> Iterable[bytes]:
    yield b"\0" + act_to_json(SimulatedAct(SimulatedDeed.FAULT, "drone", "F03", 30.0)).encode()
    fault = SimulatedFault("F47", Words("the drone's sonar fails"))
    outcome = SimulatedOutcome(True, Words("the drone has a full battery"), (fault,), 1)
    yield b"\1" + outcome_to_json(outcome).encode()
    yield b'\0{"deed": "fault", "seconds": ' + HUGE + b"}"
    yield b'\1{"done": ' + DEEP


def _announcement(data: bytes) -> None:
    with as_file(data, "1.json") as path:
        read_announcement(path)


def _announcement_seeds() -> Iterable[bytes]:
    told = {"site": "B-sen", "address": "http://127.0.0.1:8080", "key": "k", "pid": 7, "bus": "b"}
    yield json.dumps(told).encode()
    yield b'{"site": "a", "address": "b", "key": "c", "pid": ' + HUGE + b"}"
    yield b'{"site": "a", "address": "b", "key": "c", "pid": 1e999}'
    yield b'{"site": ' + DEEP


def _fault(data: bytes) -> None:
    for fault in parse_fault(data.decode(errors="surrogateescape")):
        assert isfinite(fault.start)


def _fault_seeds() -> Iterable[bytes]:
    yield from (b"F13@20s", b"F13/5cm@20s+3s#7", b"F24/killed", b"mocap:wrong@20s+5s=0.3#2")
    yield from (b"link.up:late@1e1+.5=0.1", b"mocap:off@1e999s", b"motor:off=1e400")
    yield "F\N{ARABIC-INDIC DIGIT ONE}\N{ARABIC-INDIC DIGIT TWO}@\N{SUPERSCRIPT TWO}s".encode()
    yield "mocap:off#\N{ARABIC-INDIC DIGIT ONE}".encode()


def _flights(data: bytes) -> None:
    """What a campaign kept, a form feed between its files, and the page of it."""
    (folder := scratch() / "safety").mkdir(exist_ok=True)
    flown, rest = split(data, b"\f")
    contents = (flown, *split(rest, b"\f"))
    for name, content in zip(
        (RESULTS_FILE, WIRED_RESULTS_FILE, FLOWN_BY_FILE), contents, strict=True
    ):
        (folder / name).write_bytes(content)
    by = read_flown_by(folder) if contents[2] else None
    write_safety_case(folder, flown_results(folder), wired_results(folder), {"by": str(by)})


def _flights_seeds() -> Iterable[bytes]:
    flights = (
        TrialResult(
            TrialKey("F13/2cm", 7), FaultPhase.CRUISE, (), "stands", 0.2, 6.0, 0.1, 0.4, None, 0.5
        ),
        TrialResult(
            TrialKey("F03/5s", 3, False), FaultPhase.CRUISE, ("I1: touched",), "lies", None, None,
            0.1, None, 0.2, 0.5, "lost", "kim",
        ),
    )  # fmt: skip
    wired = WiredResult(WiredKey("F24/killed", 0), 3.0, ("I1",), "landed")
    lines = "".join(f"{json.dumps(flight.to_json())}\n" for flight in flights).encode()
    yield lines + b"\f" + json.dumps(wired.to_json()).encode() + b"\n\f" + _SOURCE
    yield lines[:-40]
    yield lines.replace(b"0.2,", HUGE + b",", 1)
    yield lines.replace(b"0.2,", b'"a",', 1)
    yield lines.replace(b"6.0", b"NaN").replace(b'"F13/2cm"', b"[]")
    yield lines.replace(b"7", b"{}").replace(b'["I1: touched"]', b'["\\ud800"]')
    yield b"\f\f" + _SOURCE.replace(b"0123456789ab", b"<b>")
    yield DEEP + b"\n" + lines


TWIN: dict[str, FuzzTarget] = {
    "things_toml": FuzzTarget(
        _things, _things_seeds, (ConfigError,), words=(b"[[thing]]", b"viewpoints =", b"1e400")
    ),
    "scene_toml": FuzzTarget(
        _scene,
        _scene_seeds,
        (ConfigError,),
        words=(b"[[people]]", b"[[people.steps]]", b"[[things]]", b"[[devices]]", b'do = "go"'),
    ),
    "carry": FuzzTarget(_carry, _carry_seeds, (WireError,), 512, (b'"position"', b"1e309", b"NaN")),
    "simulated_room": FuzzTarget(
        _simulated, _simulated_seeds, (WireError,), 512, (b'"deed"', b'"done"')
    ),
    "bell_press": FuzzTarget(_bell, _bell_seeds, (WireError,), 512, (b'"pressed"', b'"at"')),
    "announcement": FuzzTarget(
        _announcement, _announcement_seeds, length_max=512, words=(b'"site"', b'"pid"', b"1e309")
    ),
    "fault_text": FuzzTarget(
        _fault, _fault_seeds, (ConfigError,), 96, (b"mocap:", b":wrong", b"@", b"F13/5cm", b"1e309")
    ),
    "safety_flights": FuzzTarget(
        _flights, _flights_seeds, (RecordingError,), words=(b'"key"', b'"row"', b"NaN", b"1e999")
    ),
}  # fmt: skip
