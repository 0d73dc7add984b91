"""The world model: who said what, the fused view, containment, questions."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import ThingError
from housefly.hub.things.thing import Thing, ThingKind
from housefly.hub.things.words import age_words, seen_words, where_words
from housefly.hub.things.world_model import WorldModel
from housefly.messages import Observation

KITCHEN = Thing("kitchen", "Kitchen", ThingKind.SPACE, position=(5.0, 5.0, 0.0))
CABINET = Thing(
    "cabinet", "the cabinet", ThingKind.FURNITURE, ("cupboard",), (2.0, 1.0, 0.9), inside="kitchen"
)
CUP = Thing("cup", "the red cup", aliases=("mug",), inside="cabinet")
TABLE = Thing("table", "Table", ThingKind.FURNITURE, position=(8.0, 3.0, 0.0), inside="kitchen")
HOUSE = (KITCHEN, CABINET, CUP, TABLE)
LEVELS = ("ground", "box", "bag", "purse", "coin")
"""Each may only be in an earlier one, so that no order of samples closes a ring on its way."""


def see(thing: str, source: str, at: float, **rest: object) -> Observation:
    return replace(Observation(thing, source, at, at), **rest)  # type: ignore[arg-type]


@st.composite
def samples(draw: st.DrawFn) -> Observation:
    level = draw(st.integers(1, len(LEVELS) - 1))
    at = draw(st.sampled_from((0.0, 0.1, 0.3, 1.0, 5.0)))
    size = draw(st.sampled_from((0.01, 0.04, 1.0)))
    return Observation(
        thing=LEVELS[level],
        source=draw(st.sampled_from(("vicon", "laser", "cabinet"))),
        captured_at=at,
        received_at=at + draw(st.sampled_from((0.0, 0.05))),
        position=draw(st.none() | st.tuples(*(st.integers(-5, 5).map(float),) * 3)),
        covariance=draw(st.none() | st.just((size, 0.0, 0.0, size, 0.0, size))),
        inside=draw(st.sampled_from(("", *LEVELS[:level]))),
        valid=draw(st.booleans()),
    )


@given(st.lists(samples(), max_size=12), st.randoms())
def test_the_fused_view_does_not_depend_on_the_order_of_arrival(
    heard: list[Observation], random: object
) -> None:
    shuffled = list(heard)
    random.shuffle(shuffled)  # type: ignore[attr-defined]
    one, other = WorldModel(), WorldModel()
    for world, order in ((one, heard), (other, shuffled)):
        for sample in order:
            world.observe(sample)
    for thing in {sample.thing for sample in heard}:
        assert one.where(thing) == other.where(thing)
        assert one.latest_observations(thing) == other.latest_observations(thing)


@given(
    st.lists(
        st.tuples(st.sampled_from("abcd"), st.sampled_from("abcd"), st.sampled_from(("s", "t"))),
        max_size=20,
    )
)
def test_nothing_is_ever_inside_itself(claims: list[tuple[str, str, str]]) -> None:
    world = WorldModel()
    for at, (thing, inside, source) in enumerate(claims):
        before = world.where(thing) if thing in {known.id for known in world.things} else None
        try:
            world.observe(see(thing, source, float(at), inside=inside))
        except ThingError as error:
            assert f"{source} says that" in str(error)
            assert "a thing cannot be inside itself" in str(error)
            assert before is None or world.where(thing) == before
        for known in world.things:
            assert known.id not in world.chain(known.id)


def test_every_order_of_three_sources_gives_the_weighted_mean() -> None:
    size = (0.01, 0.0, 0.0, 0.01, 0.0, 0.01)
    said = [
        see("cup", source, 10.0, position=(x, 0.0, 0.0), covariance=size)
        for source, x in (("a", 1.0), ("b", 2.0), ("c", 3.0))
    ]
    for order in permutations(said):
        world = WorldModel(HOUSE)
        for sample in order:
            world.observe(sample)
        found = world.where("cup")
        assert found.position == pytest.approx((2.0, 0.0, 0.0))
        assert found.covariance == pytest.approx((0.01 / 3, 0.0, 0.0, 0.01 / 3, 0.0, 0.01 / 3))
        assert found.sources == ("a", "b", "c")


def test_an_old_source_does_not_drag_the_newest_one() -> None:
    size = (0.01, 0.0, 0.0, 0.01, 0.0, 0.01)
    world = WorldModel(HOUSE)
    world.observe(see("cup", "old", 9.0, position=(0.0, 0.0, 0.0), covariance=size))
    world.observe(see("cup", "new", 10.0, position=(1.0, 0.0, 0.0), covariance=size))
    assert world.where("cup").position == (1.0, 0.0, 0.0) or world.where(
        "cup"
    ).position == pytest.approx((1.0, 0.0, 0.0))
    assert world.where("cup").sources == ("new",)


def test_an_occluded_sample_says_nothing_but_is_remembered() -> None:
    world = WorldModel(HOUSE)
    world.observe(see("cup", "vicon", 1.0, position=(1.0, 2.0, 3.0)))
    world.observe(see("cup", "vicon", 2.0, position=(0.0, 0.0, 0.0), valid=False))
    assert world.where("cup").position == (1.0, 2.0, 3.0)
    assert world.where("cup").age(now=4.0) == 3.0
    assert [sample.valid for sample in world.latest_observations("cup")] == [False]


def test_a_thing_in_a_cabinet_is_where_the_cabinet_is() -> None:
    world = WorldModel(HOUSE)
    assert world.where("cup").position == CABINET.position
    assert world.where("cup").by_container == "cabinet"
    assert world.chain("cup") == ("cabinet", "kitchen")
    assert world.contents("kitchen") == ("cabinet", "cup", "table")
    world.observe(see("cabinet", "vicon", 1.0, position=(2.2, 1.0, 0.9)))
    assert world.where("cup").position == (2.2, 1.0, 0.9)


def test_what_was_put_away_after_it_was_seen_is_where_it_was_put() -> None:
    world = WorldModel(HOUSE)
    world.observe(see("cup", "vicon", 1.0, position=(8.0, 3.0, 0.7)))
    world.observe(see("cup", "cabinet", 5.0, inside="cabinet"))
    assert world.where("cup").position == CABINET.position
    world.observe(see("cup", "vicon", 9.0, position=(7.0, 3.0, 0.7)))
    assert world.where("cup").position == (7.0, 3.0, 0.7)


def test_a_room_does_not_hide_the_position_of_what_is_in_it() -> None:
    world = WorldModel(HOUSE)
    world.observe(see("cup", "vicon", 1.0, position=(8.0, 3.0, 0.7)))
    world.observe(see("cup", "floor", 5.0, inside="kitchen"))
    assert world.where("cup").position == (8.0, 3.0, 0.7)
    assert world.chain("cup") == ("kitchen",)


def test_a_thing_seen_elsewhere_has_left_its_container_of_the_catalogue() -> None:
    world = WorldModel(HOUSE)
    world.observe(see("cabinet", "vicon", 1.0, position=(2.3, 1.0, 0.9)))
    assert world.chain("cabinet") == ("kitchen",)
    world.observe(see("cabinet", "vicon", 2.0, position=(4.0, 1.0, 0.9)))
    assert world.chain("cabinet") == ()


def test_a_ring_in_the_catalogue_is_refused_and_changes_nothing() -> None:
    world = WorldModel(HOUSE)
    with pytest.raises(
        ThingError,
        match="kitchen is in cup is in cabinet is in kitchen: a thing cannot be inside itself",
    ):
        world.add_thing(replace(KITCHEN, inside="cup"))
    assert world.chain("cup") == ("cabinet", "kitchen")
    with pytest.raises(ThingError, match="loop is in loop"):
        world.add_thing(Thing("loop", "loop", inside="loop"))
    assert "loop" not in {thing.id for thing in world.things}


@pytest.mark.parametrize(
    "words", ["cup", "CUP", "the red cup", "  The  RED cup", "mug", "the r", "mu"]
)
def test_a_thing_is_found_by_id_name_alias_or_beginning(words: str) -> None:
    assert WorldModel(HOUSE).find(words).id == "cup"


@pytest.mark.parametrize(
    ("words", "answer"),
    [
        ("tabel", "nothing is called 'tabel': did you mean 'table'?"),
        ("zebra", "nothing is called 'zebra'"),
        ("the", "'the' could be 'cabinet' or 'cup': say which"),
        ("", "nothing is called ''"),
    ],
)
def test_a_wrong_name_is_answered_with_what_could_be_meant(words: str, answer: str) -> None:
    with pytest.raises(ThingError) as refused:
        WorldModel(HOUSE).find(words)
    assert str(refused.value) == answer


def test_a_kind_narrows_the_search() -> None:
    assert WorldModel(HOUSE).find("the", ThingKind.FURNITURE).id == "cabinet"
    with pytest.raises(ThingError, match="nothing is called"):
        WorldModel(HOUSE).find("cup", ThingKind.ROBOT)
    assert [thing.id for thing in WorldModel(HOUSE).of_kind(ThingKind.FURNITURE)] == [
        "cabinet",
        "table",
    ]


def test_a_replaced_thing_is_no_longer_found_by_its_old_name() -> None:
    world = WorldModel(HOUSE)
    world.add_thing(replace(CUP, name="the blue cup", aliases=()))
    assert world.find("the blue cup").id == "cup"
    with pytest.raises(ThingError):
        world.find("mug")


def test_near_lists_the_closest_first() -> None:
    world = WorldModel(HOUSE)
    assert [near.thing for near in world.near((2.0, 1.0, 0.9), 1.0)] == ["cabinet", "cup"]
    assert [near.thing for near in world.near("cabinet", 7.0)] == ["cup", "kitchen", "table"]
    assert [near.thing for near in world.near("cabinet", 7.0, ThingKind.FURNITURE)] == ["table"]
    world.add_thing(Thing("ghost", "ghost"))
    with pytest.raises(ThingError, match="nobody knows where ghost is"):
        world.near("ghost", 1.0)


def test_an_unknown_thing_and_container_become_objects() -> None:
    world = WorldModel()
    world.observe(see("tag-17", "reader", 1.0, inside="drawer"))
    assert world.thing("tag-17").kind is ThingKind.OBJECT
    assert world.contents("drawer") == ("tag-17",)


@pytest.mark.parametrize(
    ("age", "words"),
    [
        (0.5, "now"),
        (12.9, "12 s ago"),
        (119.0, "119 s ago"),
        (180.0, "3 min ago"),
        (7200.0, "2 h ago"),
        (200_000.0, "2 days ago"),
    ],
)
def test_an_age_is_said_in_words(age: float, words: str) -> None:
    assert age_words(age) == words


def test_where_a_thing_is_is_said_in_words() -> None:
    world = WorldModel(HOUSE)
    assert seen_words(world.where("table"), 0.0) == "never seen by a sensor"
    world.observe(see("cup", "floor", 10.0, position=(8.0, 3.0, 0.7), inside="kitchen"))
    assert (
        where_words(world, "mug", 190.0)
        == "the red cup: in Kitchen, at (8.00, 3.00, 0.70) m, last seen 3 min ago by floor"
    )
    assert seen_words(world.where("cup"), 10.5) == "seen now by floor"
