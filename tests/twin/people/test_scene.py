"""Scenes: what holds at any time, the same for the same file, and no impossible scripts."""

from __future__ import annotations

from itertools import pairwise
from math import cos, hypot, sin
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import ConfigError
from housefly.room.files import load_room
from housefly.room.model import Solid
from housefly.twin.people import Act, Posture, Scene, SceneState, load_scene, scene_from_tree

BSEN = load_scene("bsen")
CUPBOARD = {"kind": "cabinet", "id": "cabinet", "position": [5.0, 5.0, 0.5]}
CUP = {"name": "cup", "tag": "t1", "inside": "cabinet"}


def scene(*steps: dict[str, Any], **keys: Any) -> Scene:
    person = {"name": "ann", "start": [0.0, 0.0], "steps": list(steps)}
    return scene_from_tree(
        {"name": "test", "people": [person], "things": [CUP], "devices": [CUPBOARD], **keys}
    )


GO = {"do": "go", "to": [4.0, 0.0], "speed": 1.0}
TAKE, PUT = {"do": "take", "thing": "cup"}, {"do": "put", "thing": "cup", "into": "cabinet"}


@given(st.floats(0.0, 500.0))
def test_the_shipped_scene_is_the_same_whenever_it_is_asked(time: float) -> None:
    assert load_scene("bsen").at(time) == BSEN.at(time)


@given(st.floats(0.0, 300.0), st.floats(0.0, 0.5))
def test_nobody_walks_faster_than_people_do(time: float, step: float) -> None:
    for before, after in zip(BSEN.at(time).people, BSEN.at(time + step).people, strict=True):
        if {before.posture, after.posture} <= {Posture.WALKING, Posture.STANDING}:
            moved = hypot(
                after.position[0] - before.position[0], after.position[1] - before.position[1]
            )
            assert moved <= 1.0 * step + 1e-6


@given(st.floats(0.0, 300.0))
def test_every_thing_is_somewhere_inside_something_or_in_one_hand(time: float) -> None:
    state = BSEN.at(time)
    names = {person.name: person for person in state.people}
    for thing in state.things.values():
        assert not (thing.inside and thing.held_by)
        if thing.held_by:
            x, y = names[thing.held_by].position
            assert hypot(thing.position[0] - x, thing.position[1] - y) < 0.5


@given(st.lists(st.floats(0.0, 400.0), min_size=2, max_size=6))
def test_what_happened_between_two_times_is_told_once_however_the_time_is_cut(
    times: list[float],
) -> None:
    cuts = sorted(times)
    parts = [act for since, until in pairwise(cuts) for act in BSEN.between(since, until)]
    assert tuple(parts) == BSEN.between(cuts[0], cuts[-1])


def test_the_shipped_scene_takes_about_two_minutes_and_ends_as_it_began() -> None:
    assert 100.0 < BSEN.length < 140.0
    begin, end = BSEN.at(0.0), BSEN.at(BSEN.length - 0.01)
    assert begin.things == end.things
    assert end.open == frozenset() and end.on == frozenset()
    for first, last in zip(begin.people, end.people, strict=True):
        if first.present and first.posture is not Posture.LYING:
            assert last.present
    assert BSEN.at(BSEN.length + 30.0).people == BSEN.at(30.0).people


def test_the_shipped_scene_tells_the_story() -> None:
    told = [(act.act, act.what, act.where) for act in BSEN.between(-1.0, BSEN.length)]
    story = [
        (Act.TAKE, "cup", "cabinet"),
        (Act.OPEN, "refrigerator", ""),
        (Act.PUT, "cup", "cabinet"),
        (Act.PRESS, "doorbell", ""),
        (Act.OPEN, "entrance-door", ""),
    ]
    assert [row for row in told if row in story and row] == story
    assert {person.posture for t in range(110) for person in BSEN.at(float(t)).people} == set(
        Posture
    )


def test_nobody_of_the_shipped_scene_walks_through_furniture() -> None:
    obstacles = [
        s
        for s in load_room("bsen").solids
        if s.collides and s.position[2] - s.size[2] / 2 < 1.6 and s.size[2] > 0.05
    ]
    for step in range(round(BSEN.length / 0.05)):
        for person in BSEN.at(step * 0.05).people:
            if person.posture in (Posture.WALKING, Posture.STANDING):
                hit = [solid.name for solid in obstacles if within(solid, person.position, 0.12)]
                assert not hit, (step * 0.05, person)


def within(solid: Solid, at: tuple[float, float], margin: float) -> bool:
    x, y = at[0] - solid.position[0], at[1] - solid.position[1]
    along, across = x * cos(solid.yaw) + y * sin(solid.yaw), y * cos(solid.yaw) - x * sin(solid.yaw)
    return abs(along) < solid.size[0] / 2 + margin and abs(across) < solid.size[1] / 2 + margin


def where(state: SceneState) -> tuple[float, float]:
    return state.people[0].position


def test_a_walk_takes_its_time_and_ends_at_its_goal() -> None:
    walk = scene(GO)
    assert where(walk.at(1.0)) == (1.0, 0.0)
    assert walk.at(1.0).people[0].posture is Posture.WALKING
    assert where(walk.at(99.0)) == (4.0, 0.0)
    assert walk.at(99.0).people[0].posture is Posture.STANDING


def test_a_cup_is_carried_and_put_away() -> None:
    errand = scene(TAKE, GO, PUT)
    assert errand.at(0.0).things["cup"].inside == "cabinet"
    assert errand.at(2.4).things["cup"].held_by == "ann"
    assert errand.at(2.4).things["cup"].position == (2.35, 0.0, 1.0)
    assert [thing.name for thing in errand.at(9.0).inside("cabinet")] == ["cup"]
    assert [(act.act, act.where) for act in errand.between(-1.0, 9.0)] == [
        (Act.TAKE, "cabinet"),
        (Act.PUT, "cabinet"),
    ]


def test_sitting_and_lying_end_where_one_stood() -> None:
    rest = scene(
        {"do": "sit", "at": [1, 1], "seconds": 5},
        {"do": "lie", "at": [2, 2], "height": 0.5, "seconds": 5},
    )
    sitting, lying, after = (rest.at(t).people[0] for t in (2.0, 7.0, 11.0))
    assert (sitting.posture, sitting.position, sitting.support) == (
        Posture.SITTING,
        (1.0, 1.0),
        0.44,
    )
    assert (lying.posture, lying.position, lying.support) == (Posture.LYING, (2.0, 2.0), 0.5)
    assert (after.posture, after.position) == (Posture.STANDING, (0.0, 0.0))


def test_who_comes_is_there_and_who_goes_is_not() -> None:
    wait = {"do": "wait", "seconds": 2}
    steps = [wait, {"do": "appear", "at": [1, 1]}, wait, {"do": "vanish"}]
    tree = {"name": "t", "people": [{"name": "bob", "steps": steps}]}
    coming = scene_from_tree(tree)
    assert [coming.at(t).people[0].present for t in (1.0, 3.0, 5.0)] == [False, True, False]


def test_another_seed_is_another_afternoon_and_no_variation_none() -> None:
    def goal_at(seed: int, variation: float) -> float:
        return where(scene(GO, seed=seed, variation=variation).at(2.0))[0]

    assert goal_at(1, 0.2) != goal_at(2, 0.2)
    assert goal_at(1, 0.0) == goal_at(2, 0.0) == 2.0


@pytest.mark.parametrize(
    ("steps", "words"),
    [
        ((TAKE, TAKE), "people.ann: at 0.8 s takes 'cup', which ann carries"),
        ((PUT,), "puts down 'cup' without carrying it"),
        ((TAKE, {"do": "put", "thing": "cup"}), "puts 'cup' nowhere; give into or at"),
        (
            (TAKE, {"do": "put", "thing": "cup", "into": "box"}),
            "puts 'cup' into 'box'; known devices: cabinet",
        ),
        (({"do": "take", "thing": "hat"},), "wants 'hat'; known things: cup"),
        (({"do": "press", "what": "bell"},), "handles 'bell'; known devices: cabinet"),
        (({"do": "fly"},), "people.0.steps.0"),
        (({"do": "go", "to": [1, 2], "speed": 9},), "allowed: a number from 0.05 to 3 m/s"),
        (({"do": "go", "to": [1, 2], "sped": 1},), "is not a known key"),
    ],
)
def test_the_impossible_is_refused_by_name(steps: tuple[dict[str, Any], ...], words: str) -> None:
    with pytest.raises(ConfigError) as raised:
        scene(*steps)
    assert words in str(raised.value)


def test_a_scene_that_cannot_be_read_is_told_where_it_was_looked_for(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="cannot be read"):
        load_scene("nowhere.toml", tmp_path)
    (tmp_path / "bad.toml").write_text("name = ")
    with pytest.raises(ConfigError, match="cannot be parsed"):
        load_scene("bad.toml", tmp_path)
    (tmp_path / "good.toml").write_text('name = "empty"')
    assert load_scene("good.toml", tmp_path).at(3.0).people == ()


def test_two_of_one_name_are_refused() -> None:
    with pytest.raises(ConfigError, match="two of the same name among cup, cup"):
        scene(things=[CUP, CUP])


@pytest.mark.parametrize("seconds", [1e-300, 1e-9, 0.9])
def test_a_round_that_is_over_at_once_is_refused(seconds: float) -> None:
    tree = {
        "name": "a",
        "loop": True,
        "pause": 0.0,
        "people": [{"name": "kim", "start": [1, 2], "steps": [{"do": "wait", "seconds": seconds}]}],
    }
    with pytest.raises(ConfigError, match=r"one round takes .* s; allowed: 1 s or longer"):
        scene_from_tree(tree)
    assert scene_from_tree({**tree, "loop": False}).length == seconds
    assert scene_from_tree({**tree, "pause": 1.0}).length == seconds + 1.0
