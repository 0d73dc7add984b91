"""The database of ROS-TMS: read, written, read again."""

from __future__ import annotations

import json
from dataclasses import replace
from math import pi
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import StoreError
from housefly.geometry import quaternion_from_euler, yaw_of
from housefly.hub.store.export_tms import tms_lines
from housefly.hub.store.import_tms import TmsDump, parse_tms, read_tms, slug, viewpoints_of
from housefly.hub.store.sql_store import SqlStore
from housefly.hub.store.tms_rows import KIND_BY_THOUSANDS
from housefly.hub.things.thing import NamedPose, Thing, ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Observation

BSEN = Path(__file__).parent / "data" / "bsen_now.json"
ROW = {
    "time": "0000-00-00 00:00:00.000000", "id": 6017, "name": "bed", "type": "furniture",
    "x": 8.0, "y": 2.3, "z": 0, "rr": 0, "rp": 0, "ry": pi,
    "place": 5002, "sensor": 0, "state": 0, "etcdata": "", "tag": "",
}  # fmt: skip


def line(**changes: object) -> str:
    return json.dumps(ROW | changes)


@pytest.fixture(scope="module")
def bsen() -> TmsDump:
    return read_tms(BSEN)


def test_the_room_of_the_laboratory_is_read_whole(bsen: TmsDump) -> None:
    assert (len(bsen.things), len(bsen.samples), bsen.skipped) == (68, 37, 1)
    assert bsen.remarks == (
        "row 70: skipped: id is 0: no thing (things have ids from 1000 to 7999)",
    )
    kinds = {kind: sum(thing.kind is kind for thing in bsen.things) for kind in ThingKind}
    assert kinds[ThingKind.FURNITURE] == 23
    assert kinds[ThingKind.OBJECT] == 25
    assert kinds[ThingKind.PERSON] == 4


def test_approach_poses_become_viewpoints_of_a_robot(bsen: TmsDump) -> None:
    bed = WorldModel(bsen.things).find("bed")
    assert bed.viewpoints == (
        NamedPose("for smartpal5_2", (12.0, 0.9, 0.0), 1.57079633, robot="smartpal5_2"),
    )
    assert bed.orientation is not None and abs(yaw_of(bed.orientation)) == pytest.approx(pi)


def test_what_a_sensor_wrote_is_a_sample_and_its_place_a_container(bsen: TmsDump) -> None:
    world = WorldModel(bsen.things)
    for sample in bsen.samples:
        world.observe(sample)
    assert world.where("greentea_bottle").position == (7.2, 5.65, 0.73)
    assert world.chain("greentea_bottle") == ("refrigerator", "space-5001")
    assert "greentea_bottle" in world.contents("refrigerator")
    assert world.find("drink").id == "soukentea_bottle"
    assert {sample.source for sample in world.latest_observations("person_1_oculus")} == {"vicon"}
    newest = next(sample for sample in bsen.samples if sample.thing == "double")
    assert newest.captured_at == pytest.approx(1517946457.033465), "2018-02-07 04:47:37 in Japan"
    absent = next(sample for sample in bsen.samples if sample.thing == "teapot")
    assert (absent.valid, absent.position) == (False, None)


def test_the_room_of_the_laboratory_survives_the_way_there_and_back(bsen: TmsDump) -> None:
    again = parse_tms(tms_lines(bsen.things, bsen.samples))
    assert again.remarks == ()
    for one, other in zip(
        (*bsen.things, *bsen.samples), (*again.things, *again.samples), strict=True
    ):
        assert_alike(one, other)


def test_the_exported_rows_say_what_the_read_rows_said(bsen: TmsDump) -> None:
    rows = [json.loads(text) for text in BSEN.read_text().splitlines()][:-1]
    exported = {
        (row["id"], row["sensor"], row["time"]): row
        for row in map(json.loads, tms_lines(bsen.things, bsen.samples))
    }
    compared = 0
    for row in rows:
        if row["id"] == 7005 and row["sensor"] == 0:
            row = row | {"x": 0}
        found = exported.get((row["id"], row["sensor"], row["time"]))
        if found is None:  # a time of the catalogue is written in another form
            continue
        compared += 1
        unknown = (row["x"], row["y"], row["z"]) == (-1, -1, -1)
        for name in (
            "name",
            "place",
            "state",
            "joint",
            "weight",
            "rfid",
            "note",
            *(() if unknown else ("x", "y", "z")),
        ):
            assert found[name] == row[name], (row["name"], name)
    assert compared >= len(rows) - 1


def test_a_dump_is_kept_in_a_store_and_found_again(store: SqlStore, bsen: TmsDump) -> None:
    store.put_things(bsen.things)
    store.write(bsen.samples)
    assert {thing.id: thing for thing in store.things()} == {
        thing.id: thing for thing in bsen.things
    }
    assert len(store.latest()) == len(bsen.samples)


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        ("not json", "row 2: skipped: is no JSON"),
        ("[1]", "row 2: skipped: is no JSON object"),
        ('{"id": 1}', "row 2: skipped: has no name, x, y, z, rr, rp, ry"),
        (line(id=8001), "row 2: skipped: id is 8001: no thing"),
        (line(id=6018, x="here"), "row 2: skipped: x is 'here'; allowed: a number"),
        (line(id=6018, x=float("nan")), "row 2: skipped: x is nan; allowed: a finite number"),
        (line(id=6018, place=1.5), "row 2: skipped: place is 1.5; allowed: a whole number"),
        (line(id=6018, time="yesterday"), "row 2: skipped: time is 'yesterday'; allowed"),
        (line(id=6018, name=7), "row 2: skipped: name is 7; allowed: a text"),
        (line(x=1.0), "row 2: skipped: bed is in the catalogue twice"),
    ],
)
def test_a_bad_row_is_named_and_skipped_and_nothing_else_is_lost(bad: str, words: str) -> None:
    dump = parse_tms([line(), bad, "", line(id=6001, name="wardrobe")])
    assert dump.skipped == 1
    assert len(dump.remarks) == 1 and dump.remarks[0].startswith(words)
    assert {"bed", "wardrobe"} <= {thing.id for thing in dump.things}


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (
            {"etcdata": "smartpal5_2;1,2"},
            "row 1: etcdata is ignored: the pose of 'smartpal5_2' is '1,2'; allowed: x,y,yaw",
        ),
        ({"etcdata": "a;1,2,3;b"}, "row 1: etcdata is ignored: 'a;1,2,3;b' is not made of pairs"),
        (
            {"place": 6017},
            "row 1: place 6017 is ignored: bed is in bed: a thing cannot be inside itself",
        ),
        ({"place": 20001}, "row 1: place is 20001, which is no thing: it is ignored"),
    ],
)
def test_a_bad_part_of_a_row_is_named_and_the_rest_is_kept(
    changes: dict[str, Any], words: str
) -> None:
    dump = parse_tms([line(**changes)])
    assert dump.skipped == 0
    assert len(dump.remarks) == 1 and dump.remarks[0].startswith(words)
    assert WorldModel(dump.things).find("bed").position == (8.0, 2.3, 0.0)


def test_two_things_of_one_name_stay_two() -> None:
    dump = parse_tms([line(), line(id=6018)])
    assert [thing.id for thing in dump.things][:2] == ["bed", "bed-6018"]


def test_several_approach_poses_are_read() -> None:
    views = viewpoints_of(
        "smartpal5_2;10.3,3.7,-1.57;wheelchair;9.8,1.55,1.57;double;10.4,1.8,1.57"
    )
    assert [(view.robot, view.position[:2], view.yaw) for view in views] == [
        ("smartpal5_2", (10.3, 3.7), -1.57),
        ("wheelchair", (9.8, 1.55), 1.57),
        ("double", (10.4, 1.8), 1.57),
    ]


def test_numbers_of_extended_json_are_read() -> None:
    dump = parse_tms([line(id={"$numberLong": "6017"}, x={"$numberDouble": "8.5"})])
    assert WorldModel(dump.things).find("bed").position == (8.5, 2.3, 0.0)


def test_a_thing_of_ours_gets_a_free_number_of_its_kind() -> None:
    things = [
        Thing("cup", "Cup", facts=(("tms_id", 7001.0),)),
        Thing("mug", "Mug"),
        Thing("door", "Door", ThingKind.PLACE),
    ]
    samples = [
        Observation("mug", "laser-1", 1e9, 1e9, (1.0, 2.0, 3.0)),
        Observation("ghost", "vicon", 1e9, 1e9),
    ]
    rows = [json.loads(text) for text in tms_lines(things, samples)]
    assert [(row["id"], row["sensor"]) for row in rows] == [
        (7001, 0),
        (7002, 0),
        (5001, 0),
        (7002, 3900),
    ]


def test_an_absent_dump_is_refused_in_words(tmp_path: Path) -> None:
    with pytest.raises(StoreError, match="cannot be read"):
        read_tms(tmp_path / "none.json")


words = st.text("abcdefg_0123456789", min_size=1, max_size=8)
metres = st.floats(-50.0, 50.0).filter(lambda value: value not in (0.0, -1.0))
angles = st.floats(-1.5, 1.5)


@st.composite
def dumps(draw: st.DrawFn) -> tuple[list[Thing], list[Observation]]:
    names = draw(st.lists(words, min_size=1, max_size=6, unique=True))
    things: list[Thing] = []
    for number, name in enumerate(names):
        band, kind = draw(st.sampled_from(sorted(KIND_BY_THOUSANDS.items())))
        placed = draw(st.booleans())
        facts = draw(st.sets(st.sampled_from(("rfid", "note"))))
        things.append(
            Thing(
                id=slug(name),
                name=name,
                kind=kind,
                aliases=tuple(draw(st.lists(words, max_size=2, unique=True))),
                position=draw(st.tuples(metres, metres, metres)) if placed else None,
                orientation=(
                    quaternion_from_euler(*draw(st.tuples(angles, angles, angles)))
                    if placed
                    else None
                ),
                inside=draw(st.sampled_from(["", *(thing.id for thing in things)])),
                viewpoints=tuple(
                    NamedPose(f"for {r}", (1.5, draw(metres), 0.0), draw(angles), robot=r)
                    for r in ("kxp",)
                ),
                facts=(
                    ("tms_id", 1000.0 * band + number),
                    *((f"tms_{fact}", "x") for fact in ("rfid", "note") if fact in facts),
                ),
            )
        )
    samples = [
        Observation(
            thing=draw(st.sampled_from(things)).id,
            source=draw(st.sampled_from(("vicon", "irs", "tms-3007"))),
            captured_at=(at := draw(st.integers(0, 2_000_000_000_000_000)) / 1e6),
            received_at=at,
            position=(point := draw(st.none() | st.tuples(metres, metres, metres))),
            orientation=(
                None
                if point is None
                else quaternion_from_euler(*draw(st.tuples(angles, angles, angles)))
            ),
            valid=draw(st.booleans()),
        )
        for _ in range(draw(st.integers(0, 4)))
    ]
    return things, samples


@given(dumps())
def test_what_is_written_is_read_again(told: tuple[list[Thing], list[Observation]]) -> None:
    things, samples = told
    again = parse_tms(tms_lines(things, samples))
    assert again.remarks == ()
    for one, other in zip((*things, *samples), (*again.things, *again.samples), strict=True):
        assert_alike(one, other)


def assert_alike(one: Any, other: Any) -> None:
    assert replace(one, orientation=None) == replace(other, orientation=None)
    assert other.orientation == (
        None if one.orientation is None else pytest.approx(one.orientation, abs=1e-7)
    ) or (pytest.approx(tuple(-part for part in one.orientation), abs=1e-7) == other.orientation)
