"""Floor plans as walls: SVG and DXF in any unit, doors and furniture left out."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.errors import ConfigError, RoomError
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.missing import missing
from housefly.room.draft.model import DraftTracking, SiteDraft

ezdxf = pytest.importorskip("ezdxf")
pytest.importorskip("svgpathtools")

L_SHAPE = "M0,0 h800 v300 h-400 v200 h-400 z"


def svg(folder: Path, shapes: str) -> Path:
    path = folder / "plan.svg"
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{shapes}</svg>')
    return path


def dxf(folder: Path, unit: int = 4) -> Path:
    document = ezdxf.new()
    document.header["$INSUNITS"] = unit
    space = document.modelspace()
    corners = [(1000, 500), (9000, 500), (9000, 5500), (1000, 5500)]
    space.add_lwpolyline(corners, close=True, dxfattribs={"layer": "A-WALL"})
    space.add_line((5000, 500), (5000, 3500), dxfattribs={"layer": "A-WALL"})
    space.add_arc((5000, 3500), 900, 0, 90, dxfattribs={"layer": "A-DOOR"})
    pillar = document.blocks.new("PILLAR")
    pillar.add_circle((0, 0), 150, dxfattribs={"layer": "A-WALL"})
    space.add_blockref("PILLAR", (7000, 3000))
    path = folder / "plan.dxf"
    document.saveas(path)
    return path


def test_an_svg_in_centimetres_becomes_metres_with_y_up(tmp_path: Path) -> None:
    plan = svg(
        tmp_path,
        f'<g id="walls" transform="translate(50,50)"><path d="{L_SHAPE}"/></g>'
        '<g id="furniture"><rect x="100" y="400" width="150" height="80"/></g>',
    )
    found = imported(SiteDraft("flat"), plan)
    draft = found.draft
    assert draft.bounds == (0.0, 0.0, 8.0, 5.0)
    assert len(draft.walls) == 6
    assert "centimetres" in " ".join(found.notes)
    # The picture's lower right corner is outside of the L: nothing is there to fly in.
    outside = [box for box in draft.scanned if box.thing == "unexplored"]
    assert sum(box.length * box.width for box in outside) == pytest.approx(8.0, abs=1.5)
    assert all(box.x > 4.0 and box.y < 2.0 for box in outside)
    assert missing(draft) == ()


def test_a_dxf_says_its_own_unit_and_its_blocks_are_read(tmp_path: Path) -> None:
    found = imported(SiteDraft("flat"), dxf(tmp_path))
    assert found.draft.bounds == (0.0, 0.0, 8.0, 5.0)
    xs = [x for wall in found.draft.walls for x, _ in (wall.start, wall.end)]
    assert sum(1 for x in xs if 5.7 < x < 6.3) > 8  # the round pillar
    assert not any(4.1 < x < 4.8 for x in xs)  # the door's arc is no wall
    assert "A-WALL" in " ".join(found.notes)
    assert missing(found.draft) == ()


def test_a_unit_that_is_said_wins(tmp_path: Path) -> None:
    found = imported(SiteDraft("flat"), dxf(tmp_path), ImportHints(unit=0.002))
    assert found.draft.bounds == (0.0, 0.0, 16.0, 10.0)


def test_layers_that_are_said_are_taken_and_unknown_ones_refused_with_names(
    tmp_path: Path,
) -> None:
    plan = dxf(tmp_path)
    with pytest.raises(RoomError, match="A-DOOR"):
        imported(SiteDraft("flat"), plan, ImportHints(layers=("Mauerwerk",)))
    both = imported(SiteDraft("flat"), plan, ImportHints(layers=("wall", "door")))
    assert len(both.draft.walls) > len(imported(SiteDraft("flat"), plan).draft.walls)


def test_walls_that_do_not_close_are_told(tmp_path: Path) -> None:
    plan = svg(tmp_path, '<path id="wall" d="M0,0 H800 V500 H300 M200,500 H0 V0"/>')
    found = imported(SiteDraft("flat"), plan)
    assert found.draft.scanned == ()
    assert "do not close" in " ".join(found.notes)


def test_a_plan_without_a_usual_unit_asks_for_it(tmp_path: Path) -> None:
    plan = svg(tmp_path, '<path id="wall" d="M0,0 H1 V100000 Z"/>')
    with pytest.raises(RoomError, match="how many metres one unit is"):
        imported(SiteDraft("flat"), plan)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("plan.svg", "<svg", "cannot be read as SVG"),
        ("plan.svg", '<svg xmlns="http://www.w3.org/2000/svg"/>', "holds no lines"),
        ("plan.svg", '<!DOCTYPE svg [<!ENTITY a "b">]><svg/>', "plain SVG"),
        ("plan.dxf", "no drawing", "cannot be read as DXF"),
        ("plan.pdf", "", "allowed: .yaml"),
    ],
)
def test_what_is_no_plan_is_refused_in_words(
    tmp_path: Path, name: str, text: str, words: str
) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(RoomError, match=words):
        imported(SiteDraft("flat"), tmp_path / name)


def test_a_file_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RoomError, match="is no file"):
        imported(SiteDraft("flat"), tmp_path / "plan.svg")


def test_blocks_in_blocks_that_never_end_are_refused_at_once(tmp_path: Path) -> None:
    document = ezdxf.new()
    document.blocks.new("B0").add_line((0, 0), (6000, 4000))
    for level in range(1, 10):
        block = document.blocks.new(f"B{level}")
        for _ in range(10):
            block.add_blockref(f"B{level - 1}", (0, 0))
    document.modelspace().add_blockref("B9", (0, 0))
    path = tmp_path / "plan.dxf"
    document.saveas(path)
    with pytest.raises(RoomError, match="blocks"):
        imported(SiteDraft("flat"), path)


def test_blocks_with_millions_of_lines_are_refused(tmp_path: Path) -> None:
    document = ezdxf.new()
    block = document.blocks.new("B")
    for n in range(500):
        block.add_line((0, 0), (6000, n))
    for _ in range(1000):
        document.modelspace().add_blockref("B", (0, 0))
    path = tmp_path / "plan.dxf"
    document.saveas(path)
    with pytest.raises(RoomError, match="more than 100000"):
        imported(SiteDraft("flat"), path)


@pytest.mark.parametrize("unit", [150.0, 0.001, 0.0, -1.0, 20000.0])
def test_a_unit_that_makes_no_room_of_a_plan_is_refused(tmp_path: Path, unit: float) -> None:
    plan = svg(tmp_path, '<rect x="0" y="0" width="6" height="4"/>')
    with pytest.raises((ConfigError, RoomError), match="unit"):
        imported(SiteDraft("flat"), plan, ImportHints(unit=unit))


def test_a_new_plan_keeps_name_and_tracking(tmp_path: Path) -> None:
    tracking = DraftTracking("vicon", "10.0.0.5")
    found = imported(SiteDraft("flat", tracking=tracking, hardware=True), dxf(tmp_path))
    assert (found.draft.name, found.draft.tracking) == ("flat", tracking)
