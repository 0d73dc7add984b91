"""The picture and the yaml of a ROS map: any depth, mode and way of writing reads the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from housefly.errors import RoomError
from housefly.room.ros_image import RosMap, read_ros_map
from housefly.room.ros_map import cropped, import_ros_map

FREE, UNKNOWN, WALL = 254, 205, 0
YAML = {
    "image": "map.png",
    "resolution": "0.05",
    "origin": "[0.0, 0.0, 0.0]",
    "negate": "0",
    "occupied_thresh": "0.65",
    "free_thresh": "0.25",
}
TMP = settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture])


def house() -> np.ndarray:
    """Return a room of 6 m x 4 m with a corner that was never seen, unseen floor around it."""
    pixels = np.full((140, 180), UNKNOWN, np.uint8)
    pixels[20:100, 20:140] = FREE
    for edge in (np.s_[20, 20:140], np.s_[99, 20:140], np.s_[20:100, 20], np.s_[20:100, 139]):
        pixels[edge] = WALL
    pixels[30:60, 100:139] = UNKNOWN
    return pixels


def written(folder: Path, pixels: np.ndarray | Image.Image, **keys: str) -> Path:
    image = pixels if isinstance(pixels, Image.Image) else Image.fromarray(pixels)
    described = YAML | keys
    image.save(folder / described["image"])
    path = folder / "map.yaml"
    path.write_text("".join(f"{key}: {value}\n" for key, value in described.items()))
    return path


def same(one: RosMap, other: RosMap) -> bool:
    return np.array_equal(one.occupied, other.occupied) and np.array_equal(one.free, other.free)


@TMP
@given(free_to=st.floats(0.01, 0.64), negate=st.booleans())
def test_what_map_saver_never_saw_is_never_free(
    tmp_path: Path, free_to: float, negate: bool
) -> None:
    pixels = 255 - house() if negate else house()
    found = read_ros_map(
        written(tmp_path, pixels, free_thresh=f"{free_to:.4f}", negate=str(int(negate)))
    )
    assert not (found.free & (house()[::-1].T == UNKNOWN)).any()
    assert bool(found.notes) == (free_to > 0.1961)
    assert found.free.any() and found.occupied.any()


def test_a_grey_of_205_among_all_greys_is_one_of_them(tmp_path: Path) -> None:
    ramp = np.tile(np.arange(256, dtype=np.uint8), (20, 1))
    found = read_ros_map(written(tmp_path, ramp))
    assert found.free[205].all() and found.notes == ()


@pytest.mark.parametrize("name", ["map.png", "map.pgm", "map.tif"])
def test_a_picture_of_sixteen_bits_reads_as_that_of_eight(tmp_path: Path, name: str) -> None:
    deep = house().astype(np.uint16) * 257
    plain = read_ros_map(written(tmp_path, house()))
    if name.endswith("pgm"):
        path = written(tmp_path, house(), image=name)
        header = b"P5\n%d %d\n65535\n" % deep.shape[::-1]
        (tmp_path / name).write_bytes(header + deep.astype(">u2").tobytes())
    else:
        path = written(tmp_path, deep, image=name)
    assert same(read_ros_map(path), plain)


def test_colours_count_by_their_mean_as_map_server_has_it(tmp_path: Path) -> None:
    shades = [(255, 0, 0), (255, 255, 0), (255, 255, 255), (0, 0, 255)]
    found = read_ros_map(written(tmp_path, np.array([shades], np.uint8)))
    assert found.occupied[:, 0].tolist() == [True, False, False, True]
    assert found.free[:, 0].tolist() == [False, False, True, False]


def test_what_is_transparent_is_unknown(tmp_path: Path) -> None:
    pixels = np.full((1, 3, 4), 255, np.uint8)
    pixels[0, :, 3] = (255, 0, 90)
    found = read_ros_map(written(tmp_path, pixels, mode="scale"))
    assert found.free[:, 0].tolist() == [True, False, False]


def test_a_raw_map_holds_per_cent_and_beyond_a_hundred_nothing(tmp_path: Path) -> None:
    raw = np.array([[0, 25, 40, 65, 100, 101, 255]], np.uint8)
    found = read_ros_map(written(tmp_path, raw, mode="raw"))
    assert found.free[:, 0].tolist() == [True, True] + 5 * [False]
    assert found.occupied[:, 0].tolist() == 3 * [False] + [True, True] + 2 * [False]


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ({"resolution": "'0.050000'"}, "resolution has the text '0.050000', read as"),
        ({"resolution": "5e-2"}, "resolution has the text '5e-2', read as the number 0.05"),
        ({"origin": "['0', 0, \"0.0\"]"}, "origin has the text"),
        ({"negate": "'0'"}, "negate has the text"),
        ({"image": "/home/robot/maps/map.png"}, "map.png beside the yaml was read"),
        ({"image": "C:\\maps\\map.png"}, "map.png beside the yaml was read"),
    ],
)
def test_what_can_be_meant_only_in_one_way_is_read_and_said(
    tmp_path: Path, keys: dict[str, str], words: str
) -> None:
    plain = read_ros_map(written(tmp_path, house(), free_thresh="0.15"))
    path = tmp_path / "map.yaml"
    path.write_text(
        "".join(f"{k}: {v}\n" for k, v in (YAML | {"free_thresh": "0.15"} | keys).items())
    )
    found = read_ros_map(path)
    assert same(found, plain)
    assert words in found.notes[0]


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ({"resolution": "5 cm"}, "resolution is the text '5 cm'; allowed: a number from 0.005"),
        ({"resolution": "'50'"}, "resolution is the text '50'; allowed"),
        ({"occupied_thresh": ""}, "occupied_thresh is None; allowed: a number from 0 to 1"),
        ({"negate": "2"}, "negate is 2; allowed: 0 or 1"),
        ({"negate": "!!set {a}"}, "negate is {'a'}; allowed: 0 or 1"),
        ({"mode": "colour"}, "mode is the text 'colour'; allowed: trinary, scale, raw"),
        ({"origin": "[0, 0]"}, "allowed: a list x, y, yaw"),
    ],
)
def test_a_bad_value_is_refused_with_key_value_and_what_is_allowed(
    tmp_path: Path, keys: dict[str, str], words: str
) -> None:
    with pytest.raises(RoomError) as refused:
        read_ros_map(written(tmp_path, house(), **keys))
    assert words in str(refused.value)


def test_a_missing_key_is_named(tmp_path: Path) -> None:
    path = written(tmp_path, house())
    path.write_text(path.read_text().replace("resolution: 0.05\n", ""))
    with pytest.raises(RoomError, match="resolution is missing; allowed: a number"):
        read_ros_map(path)


@pytest.mark.parametrize("dtype", [np.float32, np.int32])
def test_a_picture_of_unknown_depth_is_refused(tmp_path: Path, dtype: type) -> None:
    path = written(tmp_path, house().astype(dtype) * dtype(1000), image="map.tif")
    with pytest.raises(RoomError, match="save it as png or pgm with 8"):
        read_ros_map(path)


def test_how_much_was_never_seen_is_said_and_the_pad_lies_where_it_was_seen(
    tmp_path: Path,
) -> None:
    path = written(tmp_path, house())
    part, _ = cropped(read_ros_map(path), path)
    assert "16 % of its 25.0 m^2 were never seen" in part.notes[-1]
    for is_free in (False, True):
        told: list[str] = []
        room = import_ros_map(path, tmp_path / "out", unexplored_is_free=is_free, tell=told.append)
        i, j = (int(side / part.resolution) for side in room.home)
        assert part.free[i, j]
        assert ("unexplored" in {solid.thing for solid in room.solids}) != is_free
        assert told == list(part.notes)
