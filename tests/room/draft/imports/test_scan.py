"""3-D scans as rooms: any format, unit and axis; furniture stands where it stood."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from depth_scan import scan_points, write_ply
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.errors import RoomError
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.imports.imported import imported
from housefly.room.draft.imports.point_cloud import fine_spacing
from housefly.room.draft.imports.scan_part import (
    ScanPart,
    cloud_part,
    without_broken_points,
)
from housefly.room.draft.missing import missing
from housefly.room.draft.model import DraftBox, SiteDraft, with_size
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft
from housefly.room.grid import Cell, OccupancyGrid, build_grid
from housefly.sites.loaded_site import LoadedSite

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
        ("scan.usdz", b"", "export the scan as .glb or .ply"),
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


@pytest.mark.parametrize("name", ["scan.ply", "scan.obj"])
def test_points_that_are_no_numbers_or_far_away_are_left_out_and_counted(
    tmp_path: Path, name: str
) -> None:
    mesh = room_mesh()
    count = len(mesh.vertices)
    odd = np.array([[np.nan, 0, 0], [0, np.inf, 0], [1e7, 0, 0]])
    faces = np.vstack([mesh.faces, [[0, 1, count], [1, 2, count + 1], [2, 3, count + 2]]])
    if name.endswith("obj"):
        lines = [f"v {x} {y} {z}" for x, y, z in np.vstack([mesh.vertices, odd])]
        lines += [f"f {a} {b} {c}" for a, b, c in faces + 1]
        (tmp_path / name).write_text("\n".join(lines))
    else:
        sampled = np.asarray(trimesh.sample.sample_surface(mesh, 200_000, seed=1)[0])
        write_ply(np.vstack([sampled, odd]), tmp_path / name)
        count = 200_000
    found = imported(SiteDraft("room"), tmp_path / name)
    assert found.notes[:2] == (
        f"left out: 2 of {count + 3} points (no numbers)",
        f"left out: 1 of {count + 3} points (far away from all the rest)",
    )
    assert missing(found.draft) == ()
    assert found.draft.bounds is not None
    assert found.draft.bounds[2:] == pytest.approx((6.3, 4.3), abs=0.3)


@settings(max_examples=30)
@given(
    sizes=st.lists(st.integers(0, 20), min_size=1, max_size=3),
    broken=st.lists(st.sampled_from([np.nan, np.inf, -np.inf]), max_size=6),
)
def test_every_point_of_every_part_is_kept_or_counted(
    sizes: list[int], broken: list[float]
) -> None:
    rng = np.random.default_rng(1)
    clouds = [rng.random((size, 3)) for size in sizes]
    clouds[0] = np.vstack([clouds[0], *([value, 0.0, 0.0] for value in broken)])
    whole = sum(map(len, clouds))
    try:
        parts, notes = without_broken_points(map(cloud_part, clouds), "scan.ply")
    except RoomError:
        assert whole == len(broken)
        return
    assert all(np.isfinite(part.vertices).all() for part in parts)
    assert sum(len(part.vertices) for part in parts) == whole - len(broken)
    words = f"left out: {len(broken)} of {whole} points (no numbers)"
    assert notes == ((words,) if broken else ())


def test_a_triangle_of_a_broken_point_is_left_out_and_the_others_stay() -> None:
    vertices = np.vstack([[np.nan, 0, 0], np.random.default_rng(1).random((6, 3))])
    faces = np.array([[0, 1, 2], [1, 2, 3], [4, 0, 5], [4, 5, 6]])
    (part,), _ = without_broken_points([ScanPart(vertices, faces)], "scan.obj")
    assert np.array_equal(part.vertices[part.faces], vertices[faces[[1, 3]]])


def sheet(x: float, y: float, spacing: float) -> Any:
    """Return points in a grid from 0 to x and y, one in the middle of each cell."""
    along = [np.arange(spacing / 2, side, spacing) for side in (x, y)]
    return np.stack(np.meshgrid(*along), axis=-1).reshape(-1, 2)


def sparse_room(spacing: float) -> Any:
    """Return a room of 6 m x 4 m whose points stand apart: floor, and walls of one layer."""
    floor, long, short = (sheet(*size, spacing) for size in ((6, 4), (6, 2.5), (4, 2.5)))
    parts = [np.insert(floor, 2, 0.0, axis=1)]
    parts += [np.insert(long, 1, y, axis=1) for y in (0.0, 4.0)]
    parts += [np.insert(short, 0, x, axis=1) for x in (0.0, 6.0)]
    return np.vstack(parts)


@pytest.mark.parametrize("spacing", [0.02, 0.03, 0.05, 0.08, 0.1])
def test_points_up_to_ten_centimetres_apart_make_the_room(tmp_path: Path, spacing: float) -> None:
    write_ply(sparse_room(spacing), tmp_path / "scan.ply")
    found = imported(SiteDraft("scan"), tmp_path / "scan.ply")
    assert missing(found.draft) == ()
    grid = grid_of(found.draft)
    assert grid.is_free(grid.cell_of(moved(found.draft, (3.0, 2.0), found.notes)))
    for wall in ((0.0, 2.0), (6.0, 2.0), (3.0, 0.0), (3.0, 4.0)):
        spot = moved(found.draft, wall, found.notes)
        assert grid.clearance_at(spot) < 0.15
    assert found.draft.height == 2.5  # the upper rows of the walls are no ceiling


def test_points_that_are_too_far_apart_are_refused_with_the_true_reason(tmp_path: Path) -> None:
    write_ply(sparse_room(0.17), tmp_path / "scan.ply")
    with pytest.raises(RoomError, match=r"more than 10 cm apart.*export it denser"):
        imported(SiteDraft("scan"), tmp_path / "scan.ply")


def gltf(folder: Path, change: Callable[[dict[str, Any]], object]) -> Path:
    """Write the room as glTF with its tree changed."""
    mesh = room_mesh()
    mesh.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, (1, 0, 0)))
    files = trimesh.Scene(mesh).export(file_type="gltf")
    tree = json.loads(files.pop("model.gltf"))
    for name, content in files.items():
        (folder / name).write_bytes(content)
    change(tree)
    path = folder / "room.gltf"
    path.write_text(json.dumps(tree))
    return path


def needing(extension: str, normalized: bool = False) -> Callable[[dict[str, Any]], None]:
    def change(tree: dict[str, Any]) -> None:
        tree["extensionsUsed"] = tree["extensionsRequired"] = [extension]
        if normalized:
            at = tree["meshes"][0]["primitives"][0]["attributes"]["POSITION"]
            tree["accessors"][at] |= {"componentType": 5122, "normalized": True}

    return change


@pytest.mark.parametrize(
    ("extension", "normalized"),
    [
        ("KHR_draco_mesh_compression", False),
        ("EXT_meshopt_compression", False),
        ("KHR_mesh_quantization", True),
    ],
)
def test_a_compressed_gltf_is_named_with_the_way_out(
    tmp_path: Path, extension: str, normalized: bool
) -> None:
    path = gltf(tmp_path, needing(extension, normalized))
    with pytest.raises(RoomError, match=f"{extension}.*export it without compression"):
        imported(SiteDraft("scan"), path)


def test_a_gltf_whose_other_half_is_not_there_names_it(tmp_path: Path) -> None:
    path = gltf(tmp_path, lambda tree: tree["buffers"][0].update(uri="scene.bin"))
    with pytest.raises(RoomError, match=r"needs 'scene.bin', which is not beside it"):
        imported(SiteDraft("scan"), path)


def test_an_extension_that_hides_no_points_is_no_hindrance(tmp_path: Path) -> None:
    found = imported(SiteDraft("scan"), gltf(tmp_path, needing("KHR_materials_unlit")))
    assert missing(found.draft) == ()


def write_pcd(points: Any, path: Path) -> None:
    pypcd4 = pytest.importorskip("pypcd4")
    cloud = pypcd4.PointCloud.from_xyz_points(points.astype(np.float32))
    cloud.save(path, encoding=pypcd4.Encoding.BINARY_COMPRESSED)


def write_las(points: Any, path: Path) -> None:
    laspy = pytest.importorskip("laspy")
    pytest.importorskip("lazrs")
    header = laspy.LasHeader(point_format=3, version="1.2")
    header.offsets, header.scales = (432_100.0, 5_812_345.0, 35.0), (0.001, 0.001, 0.001)
    las = laspy.LasData(header)
    # What a scanner calls noise stands in the middle of the room.
    points = np.vstack([points, np.tile((3.0, 2.0, 1.1), (50, 1))])
    las.x, las.y, las.z = (points + header.offsets).T
    las.classification = np.where(np.arange(len(points)) < len(points) - 50, 2, 7).astype(np.uint8)
    las.write(path)


def write_e57(points: Any, path: Path) -> None:
    pye57 = pytest.importorskip("pye57")
    file = pye57.E57(str(path), mode="w")
    for half, shift in ((points[::2], 0.0), (points[1::2], 5.0)):
        axes = dict(zip(("cartesianX", "cartesianY", "cartesianZ"), half.T, strict=True))
        axes["cartesianX"] = axes["cartesianX"] - shift
        file.write_scan_raw(
            axes, translation=np.array([shift, 0.0, 0.0]), rotation=np.array([1.0, 0.0, 0.0, 0.0])
        )
    file.close()


@pytest.mark.parametrize(
    ("name", "write", "words"),
    [
        ("room.pcd", write_pcd, "taken for metres"),
        ("room.las", write_las, "left out: 50 points that it calls noise"),
        ("room.laz", write_las, "left out: 50 points that it calls noise"),
        ("room.e57", write_e57, "are 1 m each, as the file says"),
    ],
)
def test_the_files_of_scanners_give_the_room(
    tmp_path: Path, name: str, write: Callable[[Any, Path], None], words: str
) -> None:
    write(sparse_room(0.03), tmp_path / name)
    found = imported(SiteDraft("scan"), tmp_path / name)
    assert missing(found.draft) == ()
    assert words in "; ".join(found.notes)
    assert found.draft.bounds is not None
    grid, (_, _, length, width) = grid_of(found.draft), found.draft.bounds
    assert grid.is_free(grid.cell_of((length / 2, width / 2)))
    assert found.draft.bounds[2:] == pytest.approx((6.3, 4.3), abs=0.3)


@pytest.mark.parametrize(
    ("name", "write"),
    [("a.pcd", write_pcd), ("a.las", write_las), ("a.laz", write_las), ("a.e57", write_e57)],
)
def test_half_a_file_of_a_scanner_is_refused_in_words(
    tmp_path: Path, name: str, write: Callable[[Any, Path], None]
) -> None:
    path = tmp_path / name
    write(sparse_room(0.1), path)
    data = path.read_bytes()
    path.write_bytes(data[: len(data) // 2])
    with pytest.raises(RoomError, match=r"is the file whole|ends in the middle|is damaged"):
        imported(SiteDraft("scan"), path)


def test_a_scan_in_no_usual_unit_asks_for_it(tmp_path: Path) -> None:
    mesh = room_mesh()
    mesh.apply_scale(1e6)
    mesh.export(tmp_path / "scan.ply")
    with pytest.raises(RoomError, match="how many metres one unit is"):
        imported(SiteDraft("scan"), tmp_path / "scan.ply")
    said = imported(SiteDraft("scan"), tmp_path / "scan.ply", ImportHints(unit=1e-6))
    assert said.draft.bounds is not None and said.draft.bounds[2] < 7.0
