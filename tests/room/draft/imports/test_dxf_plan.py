"""What a DXF draws is read as CAD shows it, or counted by name: nothing is lost in silence."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from itertools import pairwise
from math import cos, hypot, pi, sin
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.errors import RoomError
from housefly.room.draft.imports.contracts import Imported
from housefly.room.draft.imports.drawing import LeftOut
from housefly.room.draft.imports.dxf_plan import dxf_drawing
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.model import SiteDraft

ezdxf = pytest.importorskip("ezdxf")

CORNERS = ((0, 0), (6000, 0), (6000, 4000), (0, 4000))


def room(space: Any, layer: str = "WALLS", scale: float = 1.0) -> None:
    corners = [(x * scale, y * scale) for x, y in CORNERS]
    space.add_lwpolyline(corners, close=True, dxfattribs={"layer": layer})


def read(folder: Path, draw: Callable[[Any, Any], object], unit: int = 4) -> Imported:
    document = ezdxf.new()
    document.header["$INSUNITS"] = unit
    draw(document, document.modelspace())
    document.saveas(folder / "plan.dxf")
    return imported(SiteDraft("flat"), folder / "plan.dxf")


def said(found: Imported) -> str:
    return "\n".join(found.notes)


def _hatch(block: Any, at: dict[str, Any]) -> None:
    block.add_hatch(dxfattribs=at).paths.add_polyline_path([(0, 0), (400, 0), (400, 400)])


DRAW: dict[str, Callable[[Any, dict[str, Any]], object]] = {
    "LINE": lambda block, at: block.add_line((0, 0), (500, 0), dxfattribs=at),
    "ARC": lambda block, at: block.add_arc((0, 0), 300, 0, 90, dxfattribs=at),
    "CIRCLE": lambda block, at: block.add_circle((0, 0), 300, dxfattribs=at),
    "ELLIPSE": lambda block, at: block.add_ellipse((0, 0), (400, 0), 0.5, dxfattribs=at),
    "SPLINE": lambda block, at: block.add_spline([(0, 0), (9, 90), (300, 9)], dxfattribs=at),
    "SOLID": lambda block, at: block.add_solid(CORNERS, dxfattribs=at),
    "3DFACE": lambda block, at: block.add_3dface(CORNERS, dxfattribs=at),
    "LWPOLYLINE": lambda block, at: block.add_lwpolyline(
        [(0, 0, 0.5), (900, 0, 0)], format="xyb", dxfattribs=at
    ),
    "POLYLINE": lambda block, at: block.add_polyline2d(CORNERS, dxfattribs=at),
    "HATCH": _hatch,
    "MTEXT": lambda block, at: block.add_mtext("a", dxfattribs=at),
    "TEXT": lambda block, at: block.add_text("a", dxfattribs=at),
    "POINT": lambda block, at: block.add_point((0, 0), dxfattribs=at),
    "MESH": lambda block, at: block.add_mesh(dxfattribs=at),
    "XLINE": lambda block, at: block.add_xline((0, 0), (1, 0), dxfattribs=at),
}
NO_SHAPES = {"MTEXT", "TEXT", "POINT", "MESH", "XLINE"}
LAYERS = ("0", "WALL", "GLASS", "FROZEN", "OFF")
ENTITY = st.tuples(st.sampled_from(sorted(DRAW)), st.sampled_from(LAYERS), st.booleans())
BLOCK = st.tuples(st.lists(ENTITY, max_size=4), st.sampled_from(LAYERS), st.sampled_from(LAYERS))


@settings(max_examples=40)
@given(loose=st.lists(ENTITY, max_size=4), blocks=st.lists(BLOCK, max_size=3))
def test_what_is_read_and_what_is_left_out_are_all_that_is_drawn(
    loose: list[tuple[str, str, bool]],
    blocks: list[tuple[list[tuple[str, str, bool]], str, str]],
) -> None:
    """Blocks stand in blocks: one insertion on a layer of its own, the other one inside of it."""
    document = ezdxf.new()
    for name in LAYERS[1:]:
        document.layers.add(name)
    document.layers.get("FROZEN").freeze()
    document.layers.get("OFF").off()
    space = document.modelspace()
    expected: Counter[tuple[str, str]] = Counter()

    def add(block: Any, entities: list[tuple[str, str, bool]], on: list[str]) -> None:
        shown_on = next((layer for layer in reversed(on) if layer != "0"), "0")
        for kind, layer, is_invisible in entities:
            DRAW[kind](block, {"layer": layer, "invisible": int(is_invisible)})
            shown = shown_on if layer == "0" else layer
            hidden = is_invisible or shown in ("FROZEN", "OFF") or "FROZEN" in on
            why = "hidden" if hidden else "none" if kind in NO_SHAPES else shown
            expected[kind, why] += 1

    add(space, loose, [])
    for n, (entities, outer_layer, inner_layer) in enumerate(blocks):
        inner, outer = document.blocks.new(f"INNER{n}"), document.blocks.new(f"OUTER{n}")
        add(inner, entities, [outer_layer, inner_layer])
        outer.add_blockref(f"INNER{n}", (10, 10), dxfattribs={"layer": inner_layer})
        space.add_blockref(f"OUTER{n}", (50, 50), dxfattribs={"layer": outer_layer})
    drawing = dxf_drawing(document)
    found = Counter({(shape.kind, shape.layer): 0 for shape in drawing.shapes})
    for shape in drawing.shapes:
        found[shape.kind, shape.layer] += 1
    for (why, kind), count in drawing.left_out.items():
        found[kind, {LeftOut.HIDDEN: "hidden", LeftOut.NO_SHAPE: "none"}[why]] += count
    assert found == expected


def test_a_wall_on_layer_0_of_a_block_is_on_the_layer_that_it_is_inserted_on(
    tmp_path: Path,
) -> None:
    def draw(document: Any, space: Any) -> None:
        room(document.blocks.new("OUTLINE"), "0")
        document.blocks.new("ROOM").add_blockref("OUTLINE", (0, 0))
        space.add_blockref("ROOM", (500, 500), dxfattribs={"layer": "WALLS"})
        space.add_line((0, 0), (9000, 0), dxfattribs={"layer": "0"})

    found = read(tmp_path, draw)
    assert found.draft.bounds == (0.0, 0.0, 6.0, 4.0)
    assert "left out: 1 '0' (on layers without walls)" in found.notes


def test_a_block_in_rows_and_columns_stands_in_all_of_them(tmp_path: Path) -> None:
    def draw(document: Any, space: Any) -> None:
        room(space)
        document.blocks.new("PILLAR").add_circle((0, 0), 150, dxfattribs={"layer": "WALLS"})
        grid = {"row_count": 2, "column_count": 3, "row_spacing": 1500, "column_spacing": 1800}
        space.add_blockref("PILLAR", (1000, 1000), dxfattribs=grid)

    found = read(tmp_path, draw)
    middles = [
        ((w.start[0] + w.end[0]) / 2, (w.start[1] + w.end[1]) / 2) for w in found.draft.walls
    ]
    for x, y in ((x, y) for x in (1.0, 2.8, 4.6) for y in (1.0, 2.5)):
        assert any(abs(u - x) < 0.2 and abs(v - y) < 0.2 for u, v in middles)


def test_walls_of_every_kind_are_read_and_the_rest_is_named(tmp_path: Path) -> None:
    def draw(document: Any, space: Any) -> None:
        at = {"layer": "Cloisons"}
        space.add_mline(CORNERS, close=True, dxfattribs=at | {"scale_factor": 200})
        for entity in (draw for kind, draw in DRAW.items() if kind not in NO_SHAPES):
            entity(space, at)
        for _ in range(3):
            space.add_mtext("a room", dxfattribs=at)
        space.add_circle((3000, 3000), 5, dxfattribs=at)
        space.add_lwpolyline([(3000, 0), (3000, 900)], dxfattribs=at | {"const_width": 200})

    found = read(tmp_path, draw)
    assert "left out: 3 MTEXT (no lines or shapes)" in found.notes
    assert "left out: 1 CIRCLE (2 cm and smaller)" in found.notes
    assert len(found.draft.walls) > 60
    assert max(wall.thickness for wall in found.draft.walls) == 0.2


def test_the_thinnest_pipe_is_no_gap(tmp_path: Path) -> None:
    """Its circle's parts are each shorter than what counts as a line."""

    def draw(_: Any, space: Any) -> None:
        room(space)
        space.add_circle((3000, 2000), 25, dxfattribs={"layer": "WALLS"})

    found = read(tmp_path, draw)
    near = [wall for wall in found.draft.walls if abs(wall.start[0] - 3.0) < 0.03]
    assert len(near) >= 3


@pytest.mark.parametrize("backwards", [False, True])
def test_a_curve_of_many_short_lines_is_no_gap(tmp_path: Path, backwards: bool) -> None:
    def draw(_: Any, space: Any) -> None:
        room(space)
        turn = [n * pi / 50 for n in range(101)]
        spots = [(3000 + 150 * cos(a), 2000 + 150 * sin(a)) for a in turn]
        for start, end in pairwise(spots):
            ends = (end, start) if backwards else (start, end)
            space.add_line(*ends, dxfattribs={"layer": "WALLS"})

    found = read(tmp_path, draw)
    assert "2 cm and smaller" not in said(found)
    pillar = found.draft.walls[4:]
    length = sum(hypot(w.end[0] - w.start[0], w.end[1] - w.start[1]) for w in pillar)
    assert length == pytest.approx(2 * pi * 0.15, rel=0.02)


@pytest.mark.parametrize(
    ("unit", "scale", "sides", "words"),
    [
        (0, 1.0, (6.0, 4.0), "are taken for millimetres, a room of 6 m x 4 m"),
        (0, 0.1, (6.0, 4.0), "are taken for centimetres, a room of 6 m x 4 m"),
        (0, 0.001, (6.0, 4.0), "are taken for metres, a room of 6 m x 4 m"),
        (0, 0.04, (6.096, 4.064), "are taken for inches"),
        (5, 1.0, (60.0, 40.0), "are 0.01 m each, as the file says"),
        (6, 0.0145, (87.0, 58.0), "are 1 m each, as the file says"),
        (2, 0.004, (7.315, 4.877), "are 0.3048 m each, as the file says"),
        (4, 0.001, (6.0, 4.0), "cannot be 0.001 m each, as the file says, and were taken for"),
    ],
)
def test_a_unit_is_that_of_the_file_or_the_one_that_makes_a_room_and_is_said(
    tmp_path: Path, unit: int, scale: float, sides: tuple[float, float], words: str
) -> None:
    found = read(tmp_path, lambda _, space: room(space, "Wände", scale), unit)
    assert found.draft.bounds is not None
    assert found.draft.bounds[2:] == pytest.approx(sides, abs=0.01)
    assert words in said(found)


@pytest.mark.parametrize("end", [(900_000, 900_000), (0, 400_000), (-700_000, 2000)])
@pytest.mark.parametrize("start", [(0.0, 0.0), None])
def test_one_line_far_away_changes_neither_unit_nor_room(
    tmp_path: Path, start: tuple[float, float] | None, end: tuple[float, float]
) -> None:
    def draw(_: Any, space: Any) -> None:
        room(space)
        space.add_line(start or (end[0] + 900, end[1]), end, dxfattribs={"layer": "WALLS"})

    found = read(tmp_path, draw)
    assert found.draft.bounds == (0.0, 0.0, 6.0, 4.0)
    assert "as the file says" in said(found)
    assert "left out: 1 LINE (far away from all the rest)" in found.notes


@pytest.mark.parametrize("how", ["freeze", "off"])
def test_a_layer_that_is_not_shown_is_no_wall(tmp_path: Path, how: str) -> None:
    def draw(document: Any, space: Any) -> None:
        getattr(document.layers.add("OLD WALLS"), how)()
        room(space)
        space.add_line((3000, 0), (3000, 4000), dxfattribs={"layer": "old walls"})

    found = read(tmp_path, draw)
    assert len(found.draft.walls) == 4
    assert "left out: 1 LINE (hidden, or on a layer that is frozen or off)" in found.notes


def test_a_plan_of_what_draws_no_wall_says_what_it_holds(tmp_path: Path) -> None:
    with pytest.raises(RoomError, match=r"holds no lines.*left out: 2 MTEXT"):
        read(tmp_path, lambda _, space: [space.add_mtext("a") for _ in range(2)])


def test_blocks_that_are_not_in_the_file_are_named(tmp_path: Path) -> None:
    def draw(_: Any, space: Any) -> None:
        room(space)
        space.add_blockref("ELSEWHERE", (0, 0))

    assert "INSERT of 'ELSEWHERE', which is not in it" in said(read(tmp_path, draw))


@pytest.mark.parametrize("mark", [b"LWPOLYLINE", b"OBJECTS"])
def test_a_file_that_was_cut_off_says_so(tmp_path: Path, mark: bytes) -> None:
    read(tmp_path, lambda _, space: room(space))
    path = tmp_path / "plan.dxf"
    text = path.read_bytes()
    path.write_bytes(text[: text.rindex(mark)])
    try:
        words = said(imported(SiteDraft("flat"), path))
    except RoomError as error:
        words = str(error)
    assert "the file ends in the middle: it was cut off" in words
