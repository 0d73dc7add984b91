"""Fuzz targets: files that people or other programs wrote."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterable
from pathlib import Path

from fuzz_target import DEEP, HUGE, FuzzTarget, as_file, scratch, split
from mcap.writer import CompressionType, Writer
from PIL import Image

from housefly.bus.codec import to_cdr
from housefly.bus.interfaces import definition, ros_name
from housefly.config.profile import load_profile
from housefly.config.site import Site, site_from_file
from housefly.errors import ConfigError, EditsError, RecordingError, RoomError, StoreError
from housefly.hub.store.import_tms import read_tms
from housefly.messages import Action, Command, Estimate, Inputs, Outputs, PilotStep
from housefly.record.replay import STEP_CHANNEL, read_steps
from housefly.record.truth import read_truth
from housefly.room.edit_versions import EditVersions
from housefly.room.files import room_from_toml, room_to_toml
from housefly.room.model import Place, Room, Shape, Solid
from housefly.room.ros_image import read_ros_map

_TMS = Path(__file__).resolve().parents[1] / "hub" / "store" / "data" / "bsen_now.json"
_TOML_WORDS = (b"[limits]", b"[[lasers]]", b"1e400", b"inf", b"nan", b"true", b'"""', b"speed =")
_MAP = b"image: map.pgm\nresolution: 0.05\norigin: [0.0, -1.0, 0.0]\nnegate: 0\n"
_MAP += b"occupied_thresh: 0.65\nfree_thresh: 0.196\n"


def _site_toml(data: bytes) -> None:
    with as_file(data, "site.toml") as path:
        site_from_file(path)


def _site_json(data: bytes) -> None:
    with as_file(data, "site.json") as path:
        site_from_file(path)


def _site_seeds() -> Iterable[bytes]:
    yield b'name = "a"\nmode = "paper"\n[limits]\nspeed = 0.5\n[twin]\nseed = 7\n'
    yield b'[[lasers]]\nname = "a"\n[[furniture]]\nname = "chair"\nbody = "chair"\n'
    yield b'[drone]\nprofile = "site.toml"\n[constants]\ndrag = 0.5\n[tracking]\nkind = "vicon"\n'
    yield b"limits.speed = " + HUGE
    yield b"limits.speed = " + DEEP
    yield b'[[faults]]\nfault = "off"\n[edits]\nremoved = ["entrance"]\n[map]\nflight_height = 1.0'


def _profile(data: bytes) -> None:
    with as_file(data, "drone.toml") as path:
        load_profile(path)


def _profile_seeds() -> Iterable[bytes]:
    yield b"[constants]\ndrag = 0.5\nattitude_lag = 7\n"
    yield b"[constants]\ndrag = " + HUGE


def _room(data: bytes) -> None:
    try:
        text = data.decode()
    except UnicodeDecodeError:
        return
    room_to_toml(room_from_toml(text, "room.toml"))


def _room_seeds() -> Iterable[bytes]:
    table = Solid("t", "table", Shape.BOX, (1.0, 1.0, 0.4), (1.0, 1.0, 0.8))
    places = (Place("home", (2.0, 1.0), (4.0, 1.0, 1.0)),)
    yield room_to_toml(
        Room("hall", (0.0, 0.0, 5.0, 5.0), 2.6, (table,), places, (), (2.0, 1.0))
    ).encode()


def _ros_map(data: bytes) -> None:
    """First the yaml, then after a form feed the picture."""
    described, picture = split(data, b"\f")
    with as_file(picture, "map.pgm"), as_file(described, "map.yaml") as path:
        read_ros_map(path)


def _ros_map_seeds() -> Iterable[bytes]:
    image = Image.new("L", (5, 4), 200)
    for kind in ("PPM", "PNG"):
        with io.BytesIO() as out:
            image.save(out, kind)
            yield _MAP + b"\f" + out.getvalue()
    yield _MAP.replace(b"0.05", HUGE) + b"\f"
    yield _MAP.replace(b"0.05", DEEP) + b"\f"
    yield _MAP.replace(b"0.05", b"2001-99-99") + b"\f"
    yield (
        b"a: &a [x,x,x,x,x,x,x,x,x]\n"
        + b"".join(
            b"%c: &%c [%s]\n" % (98 + n, 98 + n, b",".join([b"*%c" % (97 + n)] * 9))
            for n in range(8)
        )
        + b"origin: *i\nresolution: 0.05"
    )
    yield _MAP + b"\fP2\n# x\n2 2\n255\n0 10 100 255\n"


def _tms_huge() -> Iterable[bytes]:
    line = _TMS.read_bytes().splitlines()[1]
    yield re.sub(rb'"x" : [^,]*', b'"x" : ' + HUGE, line)
    yield re.sub(rb'"place" : [^,]*', b'"place" : ' + HUGE, line)
    yield line.replace(b'"id" : 1', b'"id" : ' + DEEP)


def _tms(data: bytes) -> None:
    with as_file(data, "dump.json") as path:
        read_tms(path)


def _tms_seeds() -> Iterable[bytes]:
    lines = _TMS.read_bytes().splitlines()
    yield from (b"\n".join(lines[at : at + 2]) for at in range(0, min(len(lines), 12), 2))
    yield from _tms_huge()


def _mcap(data: bytes) -> None:
    with as_file(data, "flight.mcap") as path:
        for _ in read_steps(path):
            pass


def _mcap_seeds() -> Iterable[bytes]:
    here = Estimate(2.0, (1.0, 2.0, 3.0), (0.1, 0.2, 0.3), 0.5, 0.02, 0.01)
    step = PilotStep(1, 2.0, Inputs(), Outputs(Command(Action.IDLE), here))
    for compression in (CompressionType.NONE, CompressionType.ZSTD):
        with io.BytesIO() as out:
            log = Writer(out, compression=compression)
            log.start("ros2", "housefly")
            name = ros_name("PilotStep")
            text = definition(name).encode()
            schema = log.register_schema(name, "ros2msg", text)
            channel = log.register_channel(STEP_CHANNEL, "cdr", schema)
            log.add_message(channel, 2_000_000_000, to_cdr(step), 2_000_000_000)
            log.finish()
            yield out.getvalue()


def _truth(data: bytes) -> None:
    with as_file(data, "truth.jsonl") as path:
        read_truth(path)


def _truth_seeds() -> Iterable[bytes]:
    sample = {"at": 1.0, "position": [1, 2, 3], "airborne": True, "solid": 0.5, "person": None}
    touch = {"at": 1.0, "began": 1.0, "kind": "wall", "contact": "w", "speed": 0.1, "height": 1.0}
    touch |= {"duration": 0.1, "motors": True}
    yield "\n".join(json.dumps(value) for value in (sample, touch)).encode()
    yield b'{"position": [' + HUGE + b"]}"
    yield DEEP


def _edit_versions(data: bytes) -> None:
    folder = scratch() / "edits"
    folder.mkdir(exist_ok=True)
    for path in folder.iterdir():
        path.unlink()
    (folder / "0001.json").write_bytes(data)
    EditVersions(folder).newest()


def _edit_seeds() -> Iterable[bytes]:
    place = {"name": "corner", "title": "", "viewpoint": [6, 4], "look_at": [5, 5, 1]}
    zone = {"rectangle": [1, 1, 2, 2], "reason": "mine"}
    edits = {"places": [place], "removed": ["entrance"], "zones": [zone]}
    yield json.dumps({"equals": 1, "saved_at": 5.0, "by": "a", "edits": edits}).encode()
    yield b'{"equals": 1, "saved_at": ' + HUGE + b', "by": "a", "edits": {}}'
    yield b'{"equals": 1e999, "saved_at": 5, "by": "a", "edits": {}}'
    yield DEEP


FILES: dict[str, FuzzTarget] = {
    "site_toml": FuzzTarget(_site_toml, _site_seeds, (ConfigError,), words=_TOML_WORDS),
    "site_json": FuzzTarget(
        _site_json, lambda: (Site().model_dump_json().encode(),), (ConfigError,), 4096
    ),
    "drone_profile": FuzzTarget(_profile, _profile_seeds, (ConfigError,), 512),
    "room_toml": FuzzTarget(_room, _room_seeds, (ConfigError, RoomError)),
    "ros_map": FuzzTarget(
        _ros_map, _ros_map_seeds, (RoomError,), words=(b"&a", b"*a", b"!!", b"2001-01-01", b"IDAT")
    ),
    "tms_dump": FuzzTarget(_tms, _tms_seeds, (StoreError,), words=(b'"etcdata"', b'"time"')),
    "mcap": FuzzTarget(_mcap, _mcap_seeds, (RecordingError,), 16_384),
    "truth": FuzzTarget(_truth, _truth_seeds, words=(b'"contact"', b'"position"', b"NaN")),
    "edit_versions": FuzzTarget(_edit_versions, _edit_seeds, (EditsError,), 1024),
}
