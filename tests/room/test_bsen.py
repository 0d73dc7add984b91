"""Our B-sen against B-sen's own furniture poses, 0.1 m grid and camera calibration."""

from __future__ import annotations

import csv
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from housefly.config.site import Mode, changed, site_from_file
from housefly.geometry import rotate
from housefly.pilot.planning.planner import plan
from housefly.room.bsen import bsen
from housefly.room.coverage import seen_by
from housefly.room.distance import clearance_field, footprints
from housefly.room.grid import Cell, build_grid
from housefly.room.reach import flood, reachable

SITES = Path(__file__).parents[2] / "src" / "housefly" / "sites"

# Where the robot model's collision shape is not where its mesh is, the mesh counts: footprint low
# x, low y, high x, high y, in the mesh's own frame [m].
MESHES = {
    "refrigerator": (-0.572, -0.004, -0.008, 0.476),
    "intelingent_shelf": (-0.297, 0.0, 0.0, 0.457),
}
OURS = {
    "kitchen": "kitchen",
    "meeting_table": "meeting table",
    "tree": "tree",
    "tv_table": "tv table",
    "sofa": "sofa",
    "sofa_table": "sofa table",
    "bed": "bed",
    "carpet": "carpet",
    "drawer": "drawer",
    "wardrobe": "wardrobe",
    "workdesk": "work desk",
    "tv_multi": "tv",
    "intelingent_shelf": "smart shelf",
    "refrigerator": "refrigerator",
}

Box = tuple[float, float, float, float]


def their_footprints(urdf: Path) -> dict[str, Box]:
    root = ElementTree.parse(urdf).getroot()
    poses = {}
    for joint in root.findall("joint"):
        child, origin = joint.find("child"), joint.find("origin")
        if child is not None and origin is not None:
            poses[child.get("link")] = [
                float(v) for v in f"{origin.get('xyz')} {origin.get('rpy')}".split()
            ]
    found: dict[str, Box] = {}
    for link in root.findall("link"):
        name = (link.get("name") or "").removesuffix("_link")
        if name not in OURS:
            continue
        x, y, _, _, _, yaw = poses[f"{name}_link"]
        low_x, low_y, high_x, high_y = MESHES.get(name) or collision_rectangle(link)
        turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
        corners = np.array(
            [(low_x, low_y), (high_x, low_y), (high_x, high_y), (low_x, high_y)]
        ) @ turn.T + (x, y)
        found[name] = (*corners.min(axis=0), *corners.max(axis=0))
    return found


def collision_rectangle(link: ElementTree.Element) -> Box:
    geometry = link.find("collision/geometry")
    assert geometry is not None
    box, cylinder = geometry.find("box"), geometry.find("cylinder")
    if box is not None:
        length, width, _ = (float(v) for v in (box.get("size") or "").split())
    else:
        assert cylinder is not None
        length = width = 2 * float(cylinder.get("radius") or 0)
    return -length / 2, -width / 2, length / 2, width / 2


def our_footprint(thing: str) -> Box:
    corners = []
    for solid in bsen().solids:
        if solid.thing == thing:
            c, s = abs(np.cos(solid.yaw)), abs(np.sin(solid.yaw))
            a, b = (
                (c * solid.size[0] + s * solid.size[1]) / 2,
                (s * solid.size[0] + c * solid.size[1]) / 2,
            )
            x, y, _ = solid.position
            corners.append((x - a, y - b, x + a, y + b))
    low, high = np.min(corners, axis=0), np.max(corners, axis=0)
    return low[0], low[1], high[2], high[3]


def overlap(a: Box, b: Box) -> float:
    width = max(0.0, min(a[2], b[2]) - max(a[0], b[0]))
    height = max(0.0, min(a[3], b[3]) - max(a[1], b[1]))
    area = (a[2] - a[0]) * (a[3] - a[1]) + (b[2] - b[0]) * (b[3] - b[1]) - width * height
    return width * height / area


def test_the_furniture_stands_where_bsens_own_model_puts_it(
    shared_data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    theirs = their_footprints(shared_data / "rooms" / "bsen" / "all_components.urdf")
    scores = {name: overlap(box, our_footprint(OURS[name])) for name, box in theirs.items()}
    with capsys.disabled():
        print("\noverlap with B-sen's furniture poses (intersection over union):")
        print(
            "  " + ", ".join(f"{OURS[name]} {score:.2f}" for name, score in sorted(scores.items()))
        )
    assert set(scores) == set(OURS)
    assert min(scores.values()) > 0.8
    assert np.mean(list(scores.values())) > 0.9


BUILDING = {"wall", "window", "entrance door", "room door"}


def test_the_floor_plan_agrees_with_bsens_own_grid(
    shared_data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The grid shows another year's furniture than the poses, so only the walls must agree."""
    with (shared_data / "rooms" / "bsen" / "bsen_room.csv").open() as file:
        rows = list(csv.reader(file))[1:]
    theirs = np.array([[int(float(cell)) for cell in row if cell] for row in rows]) == 1
    xs, ys = np.arange(theirs.shape[0]) * 0.1, np.arange(theirs.shape[1]) * 0.1
    # Robots on wheels made that grid: to them a carpet is an obstacle.
    solids = [
        replace(solid, collides=solid.collides or solid.thing == "carpet")
        for solid in bsen().solids
    ]
    walls = clearance_field(
        footprints([s for s in solids if s.thing in BUILDING], 0.0, 2.0), xs, ys, 20.0
    )
    everything = clearance_field(footprints(solids, 0.0, 2.0), xs, ys, 20.0)
    floor = reachable(walls, xs, ys, 0.1, bsen().home) & (walls >= 0.05)
    their_walls = np.asarray(flood(np.pad(theirs, 1, constant_values=True), 0, 0))[1:-1, 1:-1]
    plan_agrees = float((~floor == their_walls).mean())
    all_agrees = float(((~floor | (everything < 0.05)) == theirs).mean())
    inside = float((floor & ~theirs).sum() / (~theirs).sum())
    with capsys.disabled():
        print(
            f"\noverlap with B-sen's 0.1 m grid: {100 * plan_agrees:.1f} % of cells agree on the"
            " floor plan,"
        )
        print(
            f"  {100 * all_agrees:.1f} % with the furniture; {100 * inside:.1f} % of its free cells"
            " lie on our floor"
        )
    assert plan_agrees > 0.94
    assert inside > 0.96
    assert all_agrees > 0.84


def test_the_cameras_are_those_of_the_calibration(shared_data: Path) -> None:
    text = (shared_data / "rooms" / "bsen" / "LatestCalibration_20160519.xcp").read_text()
    pattern = r'USERID="(\d+)">.*?FOCAL_LENGTH="([^"]*)".*?ORIENTATION="([^"]*)" POSITION="([^"]*)"'
    entries = {int(number): (o, p) for number, _, o, p in re.findall(pattern, text, re.S)}
    assert len(entries) == len(bsen().cameras) == 18
    for camera in bsen().cameras:
        orientation, position = entries[int(camera.name.split("#")[1])]
        x, y, z, w = (float(v) for v in orientation.split())
        dot = np.dot(camera.orientation, (w, -x, -y, -z))
        assert abs(dot) == pytest.approx(1.0, abs=1e-4)
        assert (
            np.linalg.norm(
                np.array(camera.position) - np.array([float(v) / 1000 for v in position.split()])
            )
            < 0.35
        )


def test_all_cameras_look_down_into_the_room_and_hang_level() -> None:
    for camera in bsen().cameras:
        ahead, down, right = (
            rotate(camera.orientation, axis) for axis in ((0.0, 0, 1.0), (0, 1.0, 0), (1.0, 0, 0))
        )
        assert -0.85 < ahead[2] < -0.35
        assert abs(down[2]) > 0.5
        assert abs(right[2]) < 0.25
        aim = np.array(camera.position[:2]) + 1.5 * np.array(ahead[:2])
        assert 0.15 < aim[0] < 14.75 and 0.55 < aim[1] < 6.25


@pytest.mark.parametrize("mode", ["default", "paper"])
def test_the_way_to_the_entrance_is_tracked_and_ends_before_the_visitor(mode: Mode) -> None:
    site = changed(site_from_file(SITES / "bsen.toml"), mode=mode)
    room = bsen()
    grid = build_grid(room, site)
    entrance = room.place("entrance")
    answer = plan(
        grid,
        room.home,
        entrance.viewpoint,
        0.5,
        every_cell=site.mode == "paper",
        shortcut=site.mode == "default",
    )
    assert answer.path is not None, answer.reason
    assert 8.0 <= answer.path.length <= 12.0
    assert len(answer.path.waypoints) >= 4, "the way has turns"
    assert answer.path.clearance >= 0.45
    points = [
        (a + (b - a) * k / 20)
        for a, b in zip(*_ends(answer.path.waypoints), strict=True)
        for k in range(21)
    ]
    seen = seen_by(room, np.array([(x, y, site.map.flight_height) for x, y in points])).sum(axis=1)
    assert seen.min() >= 4
    visitor = np.array(room.visitor)
    assert 1.5 <= np.linalg.norm(visitor - entrance.viewpoint) <= 2.5
    points = np.array([(*visitor, 1.4), (*visitor, 1.75)])
    assert (seen_by(room, points).sum(axis=1) >= 2).all()


def _ends(waypoints: tuple[tuple[float, float], ...]) -> tuple[np.ndarray, np.ndarray]:
    points = np.array(waypoints)
    return points[:-1], points[1:]


@pytest.mark.parametrize("mode", ["default", "paper"])
def test_all_places_can_be_flown_to_on_the_shipped_sites(mode: Mode) -> None:
    site = changed(site_from_file(SITES / "bsen.toml"), mode=mode)
    grid = build_grid(bsen(), site)
    for place in bsen().places:
        assert plan(grid, bsen().home, place.viewpoint, 0.5).path is not None, place.name


def test_nobody_flies_into_the_visitor() -> None:
    site = site_from_file(SITES / "bsen.toml")
    grid = build_grid(bsen(), site)
    x, y = bsen().visitor or (0.0, 0.0)
    for dx in np.arange(-0.8, 0.81, 0.1):
        for dy in np.arange(-0.8, 0.81, 0.1):
            assert grid.kind(grid.cell_of((x + dx, y + dy))) is not Cell.FREE


def test_names_of_solids_differ_and_the_home_pad_touches_nothing() -> None:
    names = [solid.name for solid in bsen().solids]
    assert len(set(names)) == len(names)
    assert not any(solid.collides for solid in bsen().solids if solid.thing == "home pad")
