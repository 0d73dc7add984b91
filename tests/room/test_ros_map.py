"""ROS maps as rooms: shipped ones fly, generated ones keep their walls, bad ones are refused."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from housefly.config.site import site_from_file
from housefly.errors import RoomError
from housefly.pilot.planning.planner import plan
from housefly.room.files import load_room
from housefly.room.grid import build_grid
from housefly.room.mjcf import room_to_mjcf
from housefly.room.rectangles import rectangles
from housefly.room.ros_image import read_ros_map
from housefly.room.ros_map import import_ros_map

FREE, UNKNOWN, WALL = 254, 205, 0


def write_map(folder: Path, pixels: np.ndarray, suffix: str = "pgm", **keys: object) -> Path:
    Image.fromarray(pixels.astype(np.uint8)).save(folder / f"map.{suffix}")
    values = {
        "image": f"map.{suffix}",
        "resolution": 0.05,
        "origin": [0.0, 0.0, 0.0],
        "negate": 0,
        "occupied_thresh": 0.65,
        "free_thresh": 0.196,
        **keys,
    }
    path = folder / "map.yaml"
    path.write_text(
        "".join(f"{key}: {value}\n" for key, value in values.items() if value is not None)
    )
    return path


def hall() -> np.ndarray:
    """Return a hall of 8 m x 4 m with a pillar, one side open to the unknown."""
    pixels = np.full((100, 180), UNKNOWN)
    pixels[10:90, 10:170] = FREE
    for edge in (np.s_[10, 10:170], np.s_[89, 10:170], np.s_[10:90, 10]):
        pixels[edge] = WALL
    pixels[45:55, 85:95] = WALL
    return pixels


@pytest.mark.parametrize("name", ["small_house", "turtlebot3"])
def test_the_maps_of_others_become_rooms_with_a_way_to_every_place(
    name: str, shared_data: Path, tmp_path: Path
) -> None:
    room = import_ros_map(shared_data / "rooms" / name / "map.yaml", tmp_path)
    site = site_from_file(tmp_path / "site.toml")
    assert load_room(site.room.model, tmp_path) == room
    assert len(room.places) >= 4
    assert len(room.solids) < 1500
    grid = build_grid(room, site)
    answers = {
        place.name: plan(grid, room.home, place.viewpoint, site.limits.speed, shortcut=True)
        for place in room.places
    }
    assert {name: answer.reason for name, answer in answers.items() if answer.path is None} == {}
    assert max(answer.path.length for answer in answers.values() if answer.path) > 3.0
    assert mujoco.MjModel.from_xml_string(room_to_mjcf(room)).ngeom > len(room.solids)


@pytest.mark.parametrize("suffix", ["pgm", "png"])
def test_a_hall_keeps_its_pillar_and_its_size(suffix: str, tmp_path: Path) -> None:
    room = import_ros_map(write_map(tmp_path, hall(), suffix), tmp_path / "out")
    assert room.bounds[2] == pytest.approx(8.0, abs=0.3)
    assert room.bounds[3] == pytest.approx(4.0, abs=0.3)
    grid = build_grid(room, site_from_file(tmp_path / "out" / "site.toml"))
    assert {solid.thing for solid in room.solids} == {"wall", "unexplored", "home pad"}
    assert grid.clearance_at((4.0, 2.0)) < 0.1
    assert grid.clearance_at((2.0, 2.0)) > 1.0


def test_what_nobody_saw_is_no_way_out(tmp_path: Path) -> None:
    room = import_ros_map(write_map(tmp_path, hall()), tmp_path / "out")
    grid = build_grid(room, site_from_file(tmp_path / "out" / "site.toml"))
    x_max = room.bounds[2]
    assert not any(grid.is_free(grid.cell_of((x_max - 0.05, y))) for y in np.arange(0.0, 4.0, 0.05))


def test_a_negated_map_reads_the_same(tmp_path: Path) -> None:
    pixels = hall()
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    plain = read_ros_map(write_map(tmp_path / "a", pixels))
    negated = read_ros_map(write_map(tmp_path / "b", 255 - pixels, negate=1))
    assert np.array_equal(plain.occupied, negated.occupied)
    assert np.array_equal(plain.free, negated.free)


def test_the_picture_is_turned_so_that_y_points_to_its_top(tmp_path: Path) -> None:
    pixels = np.full((20, 30), FREE)
    pixels[0, 29] = WALL
    assert np.argwhere(read_ros_map(write_map(tmp_path, pixels)).occupied).tolist() == [[29, 19]]


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ({"resolution": None}, "resolution"),
        ({"resolution": -0.05}, "resolution"),
        ({"resolution": ".nan"}, "resolution"),
        ({"origin": [0, 0, 0.5]}, "yaw"),
        ({"origin": [0, 0]}, "origin"),
        ({"origin": "here"}, "origin"),
        ({"mode": "colour"}, "mode"),
        ({"image": "gone.pgm"}, "gone.pgm"),
        ({"image": "map.yaml"}, "map.yaml"),
        ({"free_thresh": 0.9}, "free_thresh"),
        ({"negate": 1}, "negate"),
    ],
)
def test_a_bad_map_is_refused_with_words(
    keys: dict[str, object], words: str, tmp_path: Path
) -> None:
    pixels = np.full((60, 60), FREE) if "negate" in keys else hall()
    with pytest.raises(RoomError, match=words):
        import_ros_map(write_map(tmp_path, pixels, **keys), tmp_path / "out")


def test_a_room_too_narrow_for_the_hull_is_refused(tmp_path: Path) -> None:
    pixels = np.full((40, 60), UNKNOWN)
    pixels[10:20, 10:50] = FREE
    with pytest.raises(RoomError, match="fits nowhere"):
        import_ros_map(write_map(tmp_path, pixels), tmp_path / "out")


@given(st.binary(max_size=400))
def test_bytes_that_are_no_map_are_refused_politely(data: bytes) -> None:
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "map.yaml"
        path.write_bytes(data)
        with pytest.raises(RoomError):
            read_ros_map(path)


@given(st.integers(0, 12), st.integers(0, 12), st.data())
def test_rectangles_cover_a_mask_exactly_once(nx: int, ny: int, data: st.DataObject) -> None:
    cells = data.draw(st.lists(st.booleans(), min_size=nx * ny, max_size=nx * ny))
    mask = np.array(cells, dtype=bool).reshape(nx, ny)
    count = np.zeros((nx, ny), dtype=int)
    for i0, j0, i1, j1 in rectangles(mask):
        count[i0:i1, j0:j1] += 1
    assert np.array_equal(count, mask.astype(int))
