"""Sentences that the server of ``housefly new`` says in English, each by what says it."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
from drafts import whole_draft
from PIL import Image

from housefly.errors import HouseflyError
from housefly.messages.words import UNSAID, Words, from_tree
from housefly.room.draft.alignment import rigid_fit
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.model import (
    DraftBox,
    DraftDrone,
    DraftPlace,
    DraftTracking,
    DraftZone,
    FramePoint,
    SiteDraft,
    with_size,
)
from housefly.tracking.live_check import Heard, HeardBody, heard_words
from housefly.web.new_site.draft_actions import KeepDraft, SizeRoom, parsed_request
from housefly.web.new_site.draft_answers import draft_refusal
from housefly.web.new_site.draft_view import fit_view, missing_views

_SQUARE = ((1.0, 1.0), (5.0, 1.0), (5.0, 3.0))
_ZONE = DraftZone((2.0, 1.5, 3.0, 2.5), "kept free")
_SVG = '<svg xmlns="http://www.w3.org/2000/svg"><g id="{layer}"><rect {size}/></g></svg>'


def _points(*seen: tuple[float, float]) -> tuple[FramePoint, ...]:
    return tuple(
        FramePoint(f"point {n}", (x, y, 0.05), (u, v, 0.05))
        for n, ((x, y), (u, v)) in enumerate(zip(_SQUARE, seen, strict=False), 1)
    )


FRAMES = (
    _points(*_SQUARE),
    _points(*_SQUARE[:2]),
    _points((1.0, 1.0), (1.1, 1.0)),
    _points((1.0, -1.0), (5.0, -1.0), (5.0, -3.0)),
    _points((2.0, 2.0), (10.0, 2.0), (10.0, 6.0)),
    _points((1.0, 1.0), (5.3, 1.0), (5.0, 3.0)),
    tuple(FramePoint("p", (x, 1.0, 0.0), (x, 1.0, 0.0)) for x in (1.0, 3.0, 5.0)),
    tuple(FramePoint("p", (1.0, 1.0, 0.0), (x, 1.0, 0.0)) for x in (1.0, 3.0)),
)
"""Points that agree, that are too few or too near, and every way in which they do not agree."""


def _drafts() -> list[SiteDraft]:
    whole = whole_draft()
    box = DraftBox("box", 3.0, 2.0, 1.0, 1.0, top=2.0)
    low = replace(box, top=0.2)
    full = tuple(
        DraftBox("b", 0.5 * i, 0.5 * j, 0.3, 0.3, 0.2) for i in range(13) for j in range(9)
    )
    places = [DraftPlace("spot", x, y) for x, y in ((3.0, 2.0), (9.0, 9.0), (3.0, 1.35))]
    behind = DraftPlace("behind", 5.5, 3.5)
    wall = DraftBox("divider", 4.5, 2.0, 0.1, 5.0, 2.5)
    hard = replace(whole, hardware=True)
    tracking = DraftTracking("vicon", "10.0.0.5")
    drafts = [
        SiteDraft(),
        whole,
        replace(whole, pad=None),
        replace(whole, bounds=(3.0, 0.0, 1.0, 4.0)),
        replace(whole, height=1.2),
        replace(whole, walls=()),
        replace(whole, furniture=(box,), pad=(3.0, 2.0)),
        replace(whole, furniture=(low,), pad=(3.0, 2.0)),
        replace(whole, furniture=(low,), pad=(3.0, 1.3)),
        replace(whole, furniture=full),
        with_size(SiteDraft(), 1.0, 1.0),
        replace(whole, pad=(9.0, 9.0)),
        replace(whole, zones=(_ZONE,), pad=(2.5, 2.0)),
        replace(whole, zones=(_ZONE,), pad=(0.8, 0.8), places=(DraftPlace("a", 2.5, 2.0),)),
        replace(whole, furniture=(box,), pad=(0.8, 0.8), places=tuple(places)),
        replace(whole, furniture=(wall,), pad=(1.0, 1.0), places=(behind,)),
        replace(whole, places=()),
        replace(whole, places=(*whole.places, *whole.places)),
        hard,
        replace(hard, tracking=tracking, drone=DraftDrone()),
        replace(hard, tracking=tracking, drone=DraftDrone(profile="x.toml")),
    ]
    return drafts + [replace(hard, frame_points=points) for points in FRAMES]


def missing_sentences() -> set[Words]:
    """Return what drafts lack, with what mends it, and what the points of the frame say."""
    found: set[Words] = set()
    for draft in _drafts():
        for one in missing_views(draft):
            found |= {one.words, one.mend}
        if fit := fit_view(draft):
            found |= set(fit.words)
    return found


def heard_sentences() -> set[Words]:
    """Return what a live test of the tracking system says."""
    body = HeardBody("ardrone", (1.5, 2.5, 0.05), 0.3, 90.0, 0.001)
    heard = Heard("10.0.0.5:801", 100.0, (body,), UNSAID)
    several = (
        heard,
        replace(
            heard, rate_hz=9.0, problem=Words("the connection to {name} was lost", name="10.0.0.5")
        ),
        replace(heard, bodies=()),
        Heard("10.0.0.5:801", 0.0, (), Words("nothing came from {name}", name="10.0.0.5:801")),
    )
    names = ("ardrone", "other")
    return {words for one in several for name in names for words in heard_words(one, name)}


def refusal_sentences(folder: Path) -> set[Words]:
    """Return why values and files are refused."""
    tries: list[Callable[[], object]] = [
        *(partial(parsed_request, kind, body) for kind, body in _BAD),
        partial(with_size, SiteDraft(), 0.1, 4.0),
        partial(rigid_fit, ()),
    ]
    for name, text, hints in (*_FILES, *_FOREIGN):
        (folder / name).write_text(text, encoding="utf-8")
        tries.append(partial(imported, SiteDraft(), folder / name, hints))
    found = {_refused(one) for one in tries}
    return found - {UNSAID}


_DRAFT = b'{"based_on": "a", "draft": {%s}}'
_BAD = (
    (SizeRoom, b'{"based_on": "a", "length": 6, "width": 4}'),
    (SizeRoom, b'{"based_on": "a", "length": 2000, "width": 4, "height": 2}'),
    (SizeRoom, b'{"based_on": "a", "length": 6, "width": 4, "height": 2, "more": 1}'),
    (KeepDraft, _DRAFT % b'"flight_height": 9.0'),
    (KeepDraft, _DRAFT % b'"flight_height": 0.1'),
    (KeepDraft, _DRAFT % b'"name": "%s"' % (b"a" * 61)),
    (KeepDraft, _DRAFT % b'"drone": {"address": ""}'),
    (KeepDraft, _DRAFT % b'"height": "high"'),
    (
        KeepDraft,
        _DRAFT % b'"furniture": [{"name": "", "x": 1, "y": 1, "length": 0, "width": 1, "top": 1}]',
    ),
)
_ANY = ImportHints()
_ROOM = _SVG.format(layer="walls", size='width="6000" height="4000"')
_FILES = (
    ("room.txt", "nothing", _ANY),
    ("empty.svg", '<svg xmlns="http://www.w3.org/2000/svg"/>', _ANY),
    ("broken.svg", "<svg", _ANY),
    ("tiny.svg", _SVG.format(layer="walls", size='width="0.001" height="0.002"'), _ANY),
    ("unit.svg", _ROOM, ImportHints(unit=1.0)),
    ("unit0.svg", _ROOM, ImportHints(unit=1e-9)),
    ("layer.svg", _ROOM, ImportHints(layers=("doors",))),
)


def _refused(work: Callable[[], object]) -> Words:
    try:
        work()
    except HouseflyError as error:
        return from_tree(json.loads(bytes(draft_refusal(error).body))["error"])
    return UNSAID


def import_sentences(folder: Path) -> set[Words]:
    """Return what is said of plans, maps and scans that are read, and of what is left out."""
    rooms = {
        "walls.svg": (_ROOM, _ANY),
        "lines.svg": (_SVG.format(layer="l", size='width="6" height="4"'), ImportHints(unit=1.0)),
        "open.svg": (
            '<svg xmlns="http://www.w3.org/2000/svg"><line x1="0" y1="0" x2="6" y2="0"/>'
            '<line x1="0" y1="0" x2="0" y2="4"/></svg>',
            _ANY,
        ),
        "much.svg": (_MUCH, _ANY),
        "inches.dxf": (_DXF % (0, 240, 180), _ANY),
        "wrong.dxf": (_DXF % (4, 6, 4), _ANY),
        "cut.dxf": (_DXF % (6, 6, 4) + "0\nSECTION\n", _ANY),
        "map.yaml": (_MAP, ImportHints(unexplored="free")),
        "sparse.obj": (_scan(0.05) + "v nan 0 0\nv 1e9 0 0\n", _ANY),
        "feet.obj": (_scan(0.02, 3.281), ImportHints(unit=0.3048)),
    }
    Image.new("L", (90, 70), 254).save(folder / "map.png")
    with Image.open(folder / "map.png") as picture:
        picture.paste(205, (0, 0, 20, 70))
        picture.save(folder / "map.png")
    found: set[Words] = set()
    for name, (text, hints) in rooms.items():
        (folder / name).write_text(text, encoding="utf-8")
        found |= set(imported(SiteDraft(), folder / name, hints).notes)
    return found


_MUCH = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" viewBox="0 0 200 150">'
    '<rect width="100%" height="100%"/><text>a</text><g id="walls"><rect width="160" height="90"/>'
    '<path d="q"/><circle r="0.01"/><line x2="9" display="none"/><line x1="9e4" x2="9e4" y2="1"/>'
    '</g><g id="doors"><line x2="20"/></g></svg>'
)
_DXF = (
    "0\nSECTION\n2\nHEADER\n9\n$LUNITS\n70\n4\n9\n$INSUNITS\n70\n%d\n0\nENDSEC\n0\nSECTION\n2\n"
    "ENTITIES\n0\nSOLID\n8\nwalls\n10\n0\n20\n0\n11\n%d\n21\n0\n12\n0\n22\n%d\n0\nENDSEC\n0\nEOF\n"
)
_MAP = (
    "image: /maps/map.png\nresolution: '0.05'\norigin: [0, 0, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.25\n"
)


def _scan(spacing: float, scale: float = 1.0) -> str:
    """Return the points of a floor and a wall as OBJ."""
    x, y, z = (np.arange(0.0, side, spacing) for side in (3.0, 2.0, 2.5))
    floor = np.stack(np.meshgrid(x, y, [0.0]), axis=-1).reshape(-1, 3)
    wall = np.stack(np.meshgrid(x, [2.0], z), axis=-1).reshape(-1, 3)
    points = scale * np.vstack([floor, wall])
    return "".join(f"v {a:.3f} {b:.3f} {c:.3f}\n" for a, b, c in points)


def _gltf(**keys: object) -> str:
    return json.dumps({"asset": {"version": "2.0"}, **keys})


_FOREIGN = (
    *((f"room.{end}", "", _ANY) for end in ("pgm", "pdf", "dwg", "usdz", "pts")),
    ("draco.gltf", _gltf(extensionsUsed=["KHR_draco_mesh_compression"]), _ANY),
    ("packed.gltf", _gltf(extensionsRequired=["EXT_meshopt_compression"]), _ANY),
    ("half.gltf", _gltf(buffers=[{"uri": "half.bin"}]), _ANY),
    ("whole.gltf", "{", _ANY),
    (
        "numbers.gltf",
        _gltf(
            accessors=[{"componentType": 5122, "normalized": True}],
            meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        ),
        _ANY,
    ),
    ("far.obj", _scan(0.14), _ANY),
    ("line.obj", "".join(f"v {n} 0 0\n" for n in range(600)), _ANY),
    ("nothing.obj", "v nan 0 0\nv 0 nan 0\n", _ANY),
    ("a.pcd", "VERSION 0.7\n", _ANY),
    ("a.las", "LASF", _ANY),
    ("a.e57", "ASTM", _ANY),
    ("entities.svg", '<!DOCTYPE svg [<!ENTITY a "b">]><svg/>', _ANY),
    ("text.svg", "<svg><text>a</text></svg>", _ANY),
)


def draft_sentences(folder: Path) -> set[Words]:
    """Return all of them; small files are written into the folder."""
    return {
        *missing_sentences(),
        *heard_sentences(),
        *refusal_sentences(folder),
        *import_sentences(folder),
    }
