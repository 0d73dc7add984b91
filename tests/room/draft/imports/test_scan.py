"""3-D scans as rooms: any format, unit and axis; furniture stands where it stood."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from depth_scan import scan_points, write_ply

from housefly.app.loaded_site import LoadedSite
from housefly.errors import RoomError
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.imports.point_cloud import fine_spacing
from housefly.room.draft.missing import missing
from housefly.room.draft.model import DraftBox, SiteDraft, with_size
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft
from housefly.room.grid import Cell, OccupancyGrid, build_grid

trimesh = pytest.importorskip("trimesh")

TABLE, LAMP = (4.5, 1.0), (2.0, 3.0)
PARTS = (
    ((6.0, 4.0, 0.1), (3.0, 2.0, -0.05)),
    ((6.0, 0.1, 2.5), (3.0, -0.05, 1.25)),
    ((6.0, 0.1, 2.5), (3.0, 4.05, 1.25)),
    ((0.1, 4.0, 2.5), (-0.05, 2.0, 1.25)),
    ((0.1, 4.0, 2.5), (6.05, 2.0, 1.25)),
    ((1.0, 1.0, 0.7), (*TABLE, 0.35)),
    ((0.4, 0.4, 0.3), (*LAMP, 1.1)),
)
"""A room of 6 m x 4 m with a low table and a lamp at flight height: sizes and middles [m]."""


def room_mesh() -> Any:
    parts = []
    for size, middle in PARTS:
        part = trimesh.creation.box(size)
        part.apply_translation(middle)
        parts.append(part)
    return trimesh.util.concatenate(parts)


def grid_of(draft: SiteDraft) -> OccupancyGrid:
    return build_grid(room_of_draft(draft), site_of_draft(draft))


def moved(
    draft: SiteDraft, point: tuple[float, float], notes: tuple[str, ...]
) -> tuple[float, float]:
    """Return a point of the scan as the draft has it: its corner is told in the notes."""
    x, y = notes[-1].rsplit("(", 1)[1].split(")")[0].split(",")
    return point[0] - float(x), point[1] - float(y)


@pytest.mark.parametrize(
    ("name", "scale", "y_up"),
    [("room.glb", 1.0, True), ("room.obj", 1000.0, False), ("room.ply", 100.0, False),
     ("room.stl", 1.0, True)],
)  # fmt: skip
def test_any_format_unit_and_axis_gives_the_same_room(
    tmp_path: Path, name: str, scale: float, y_up: bool
) -> None:
    mesh = room_mesh()
    mesh.apply_scale(scale)
    if y_up:
        mesh.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, (1, 0, 0)))
    mesh.export(tmp_path / name)
    found = imported(SiteDraft("room"), tmp_path / name)
    draft, grid = found.draft, grid_of(found.draft)
    assert draft.bounds is not None
    assert draft.bounds[2:] == pytest.approx((6.3, 4.3), abs=0.3)
    assert missing(draft) == ()
    table, lamp = (moved(draft, point, found.notes) for point in (TABLE, LAMP))
    assert grid.kind(grid.cell_of(lamp)) is Cell.OCCUPIED
    assert grid.is_free(grid.cell_of(table))  # flown over
    top = max(
        b.top for b in draft.scanned if abs(b.x - table[0]) < 0.4 and abs(b.y - table[1]) < 0.4
    )
    assert 0.65 <= top <= 0.85


def test_a_room_that_the_twins_own_depth_camera_scanned_is_that_room(tmp_path: Path) -> None:
    box = DraftBox("cupboard", 3.9, 0.6, 0.8, 0.6, 1.9)
    truth = replace(with_size(SiteDraft("truth"), 5.0, 4.0), furniture=(box,), pad=(1.5, 2.5))
    room, site = room_of_draft(truth), site_of_draft(truth)
    loaded = LoadedSite(site, room, build_grid(room, site))
    write_ply(scan_points(loaded, step=1.6), tmp_path / "scan.ply")
    found = imported(SiteDraft("scan"), tmp_path / "scan.ply")
    assert missing(found.draft) == ()
    grid = grid_of(found.draft)
    assert grid.kind(grid.cell_of(moved(found.draft, (3.9, 0.85), found.notes))) is Cell.OCCUPIED
    assert grid.is_free(grid.cell_of(moved(found.draft, (1.5, 2.5), found.notes)))
    # Nowhere is the scan's free floor nearer to what truly stands there than the drone may be.
    for i, j in np.argwhere(grid.cells == Cell.FREE):
        x, y = grid.centre_of((int(i), int(j)))
        a, b = moved(found.draft, (0.0, 0.0), found.notes)
        assert loaded.grid.clearance_at((x - a, y - b)) > 0.3


def test_floor_that_nobody_saw_is_not_flown_over(tmp_path: Path) -> None:
    points = np.asarray(trimesh.sample.sample_surface(room_mesh(), 200_000, seed=1)[0])
    hidden = (points[:, 0] > 4.0) & (points[:, 0] < 5.9) & (points[:, 2] < 0.8)
    write_ply(points[~hidden], tmp_path / "scan.ply")
    found = imported(SiteDraft("scan"), tmp_path / "scan.ply")
    grid = grid_of(found.draft)
    assert not grid.is_free(grid.cell_of(moved(found.draft, (5.0, 2.5), found.notes)))
    assert "unexplored" in {box.thing for box in found.draft.scanned}


def test_single_wrong_points_are_not_walls(tmp_path: Path) -> None:
    points = np.asarray(trimesh.sample.sample_surface(room_mesh(), 200_000, seed=1)[0])
    stray = np.array([[3.0, 2.0, 1.1], [3.0, 2.01, 1.1], [1.0, 1.0, 1.0]])
    write_ply(np.vstack([points, stray]), tmp_path / "scan.ply")
    found = imported(SiteDraft("scan"), tmp_path / "scan.ply")
    grid = grid_of(found.draft)
    assert grid.is_free(grid.cell_of(moved(found.draft, (3.0, 2.0), found.notes)))


def test_a_thin_pole_is_in_the_way(tmp_path: Path) -> None:
    points = np.asarray(trimesh.sample.sample_surface(room_mesh(), 200_000, seed=1)[0])
    heights = np.linspace(0.0, 2.0, 400)
    pole = np.column_stack([np.full(400, 3.0), np.full(400, 2.0), heights])
    write_ply(np.vstack([points, pole]), tmp_path / "scan.ply")
    found = imported(SiteDraft("scan"), tmp_path / "scan.ply")
    grid = grid_of(found.draft)
    assert not grid.is_free(grid.cell_of(moved(found.draft, (3.0, 2.0), found.notes)))


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("scan.ply", b"no scan", "cannot be read as a scan"),
        ("scan.obj", b"v 0 0 0\n", "scan"),
        ("scan.glb", b"glTF\x02\x00\x00\x00", "cannot be read as a scan"),
    ],
)
def test_what_is_no_scan_is_refused_in_words(
    tmp_path: Path, name: str, content: bytes, words: str
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(RoomError, match=words):
        imported(SiteDraft("scan"), tmp_path / name)


def test_a_mesh_that_stands_in_a_scene_too_often_is_refused(tmp_path: Path) -> None:
    cloud = trimesh.PointCloud(np.random.default_rng(1).random((20_000, 3)))
    files = trimesh.Scene(cloud).export(file_type="gltf")
    tree = json.loads(files["model.gltf"])
    mesh = next(node["mesh"] for node in tree["nodes"] if "mesh" in node)
    tree["nodes"] = [{"mesh": mesh} for _ in range(2000)]
    tree["scenes"] = [{"nodes": list(range(2000))}]
    for name, content in (files | {"model.gltf": json.dumps(tree).encode()}).items():
        (tmp_path / name).write_bytes(content)
    path = tmp_path / "model.gltf"
    with pytest.raises(RoomError, match="at most"):
        imported(SiteDraft("flat"), path)


def test_many_large_surfaces_share_the_points_of_one_scan() -> None:
    parts = [trimesh.creation.box((12.0, 12.0, 0.01)) for _ in range(40)]
    spacing = fine_spacing(parts, 0.02)
    assert sum(part.area for part in parts) / spacing**2 <= 8_000_001
    assert fine_spacing(parts[:1], 0.02) == 0.02


def test_a_scan_in_no_usual_unit_asks_for_it(tmp_path: Path) -> None:
    mesh = room_mesh()
    mesh.apply_scale(1e6)
    mesh.export(tmp_path / "scan.ply")
    with pytest.raises(RoomError, match="how many metres one unit is"):
        imported(SiteDraft("scan"), tmp_path / "scan.ply")
    said = imported(SiteDraft("scan"), tmp_path / "scan.ply", ImportHints(unit=1e-6))
    assert said.draft.bounds is not None and said.draft.bounds[2] < 7.0
