"""What is kept is found again: one suite over SQLite and a real PostgreSQL server."""

from __future__ import annotations

import itertools
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.errors import StoreError
from housefly.hub.store.open import open_store
from housefly.hub.store.rows import (
    event_from_row,
    row_of_event,
    row_of_sample,
    row_of_thing,
    row_of_viewpoint,
    sample_from_row,
    thing_from_row,
)
from housefly.hub.store.schema import MIGRATIONS, version_of
from housefly.hub.store.sql_store import SqlStore
from housefly.hub.store.store import RejectedRowError
from housefly.hub.things.thing import NamedPose, Thing, ThingKind
from housefly.messages import Observation, RoomEvent

HOUR = 3600.0
CABINET = Thing(
    "cabinet",
    "the cabinet",
    ThingKind.FURNITURE,
    ("cupboard", "Schrank"),
    (2.0, 1.0, 0.9),
    (1.0, 0.0, 0.0, 0.0),
    "kitchen",
)
KITCHEN = Thing(
    "kitchen",
    "Kitchen",
    ThingKind.SPACE,
    position=(5.0, 5.0, 0.0),
    facts=(("floor", 1.0), ("tiled", True)),
)
CUP = Thing(
    "cup",
    "茶碗 cup",
    viewpoints=(
        NamedPose("front", (1.0, 2.0, 3.0), 0.5, 0.1, "ardrone"),
        NamedPose("top", (0.0, 0.0, 2.0), 0.0),
    ),
)


def seen(
    at: float, x: float, thing: str = "cup", source: str = "vicon", **rest: object
) -> Observation:
    return replace(Observation(thing, source, at, at + 0.01, (x, 0.0, 0.5)), **rest)  # type: ignore[arg-type]


def walk(start: float, count: int, rate: float = 100.0, **rest: object) -> list[Observation]:
    return [seen(start + k / rate, 0.01 * k, **rest) for k in range(count)]


names = st.text(st.characters(blacklist_categories=("Cs",), blacklist_characters="\0"), max_size=8)
numbers = st.floats(allow_nan=False, allow_infinity=False)
facts = st.dictionaries(names, st.one_of(names, numbers, st.booleans()), max_size=3).map(
    lambda known: tuple(known.items())
)
points = st.tuples(numbers, numbers, numbers)
quaternions = st.tuples(numbers, numbers, numbers, numbers)
observations = st.builds(
    Observation, names, names, numbers, numbers, st.none() | points, st.none() | quaternions,
    st.none() | st.tuples(*(numbers,) * 6), names, st.booleans(), facts,
)  # fmt: skip
events = st.builds(RoomEvent, names, names, numbers, names, names, numbers, facts)
views = st.lists(st.builds(NamedPose, names, points, numbers, numbers, names), max_size=2).map(
    tuple
)
things = st.builds(
    Thing, names, names, st.sampled_from(ThingKind), st.lists(names, max_size=2).map(tuple),
    st.none() | points, st.none() | quaternions, names, views, facts,
)  # fmt: skip


@given(observations, events, things)
def test_every_value_comes_back_from_its_row(
    sample: Observation, event: RoomEvent, thing: Thing
) -> None:
    assert (
        sample_from_row(
            (
                sample.thing,
                sample.source,
                sample.captured_at,
                int(sample.valid),
                *row_of_sample(sample),
            )
        )
        == sample
    )
    assert event_from_row(row_of_event(event)) == event
    assert (
        thing_from_row(
            row_of_thing(thing),
            thing.aliases,
            [row_of_viewpoint(view) for view in thing.viewpoints],
        )
        == thing
    )


@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.lists(observations, max_size=5),
    st.lists(things, max_size=3, unique_by=lambda thing: thing.id),
)
def test_every_value_comes_back_from_the_database(
    store: SqlStore, samples: list[Observation], known: list[Thing]
) -> None:
    store.put_things(known)
    store.write(samples)
    kept = {thing.id: thing for thing in store.things()}
    assert all(kept[thing.id] == thing for thing in known)
    for sample in samples:
        assert any(
            found.thing == sample.thing and found.source == sample.source
            for found in store.latest()
        )


def test_the_catalogue_is_kept_and_replaced(store: SqlStore) -> None:
    store.put_things([CABINET, KITCHEN, CUP])
    assert store.things() == (CABINET, CUP, KITCHEN)
    assert store.things("cup") == (CUP,)
    assert store.things("nobody") == ()
    blue = replace(CUP, name="the blue cup", aliases=("mug",), viewpoints=())
    store.put_things([blue])
    assert store.things("cup") == (blue,)


def test_a_thing_is_found_where_it_was_nearest_at_or_before(store: SqlStore) -> None:
    store.write([*walk(1000.0, 100), seen(1000.4, 7.0, source="laser")])
    vicon = {sample.source: sample for sample in store.latest_at(1000.507)}["vicon"]
    assert (vicon.captured_at, vicon.position) == (1000.5, (0.5, 0.0, 0.5))
    assert [sample.source for sample in store.latest_at(1000.5)] == ["laser", "vicon"]
    assert store.latest_at(999.0) == ()
    assert store.latest_at(1000.5, "nobody") == ()


def test_asking_for_the_past_reads_only_what_it_needs(tmp_path: Path) -> None:
    store = open_store(tmp_path / "house.db")
    store.write(walk(1000.0, 20_000))
    steps = itertools.count()
    store._database._connection.set_progress_handler(lambda: next(steps) * 0, 100)  # type: ignore[attr-defined]
    store.latest_at(1100.0)
    store.latest_at(1100.0, "cup")
    assert next(steps) < 100, "at most 10 000 steps of SQLite's machine, half a step a row"
    store.close()


def test_an_invalid_sample_does_not_hide_the_last_valid_one(store: SqlStore) -> None:
    store.write([seen(1.0, 5.0), seen(2.0, 0.0, valid=False), seen(3.0, float("nan"))])
    assert [(sample.valid, sample.captured_at) for sample in store.latest("cup")] == [
        (True, 1.0),
        (False, 3.0),
    ]
    assert [sample.position for sample in store.latest_at(9.0)] == [(5.0, 0.0, 0.5)]


def test_a_thing_that_stands_still_is_written_once(store: SqlStore) -> None:
    store.write(walk(0.0, 50))
    for start in range(10, 20):
        store.write([seen(start + k / 10, 0.5 + 0.001 * (k % 2)) for k in range(10)])
    path = store.trajectory("cup", 0.0, 100.0)
    assert len(path) == 52, "fifty while it went, the begin and the end of standing still"
    assert path[-1] == pytest.approx((19.9, 0.5, 0.0, 0.5))
    assert store.latest("cup")[0].captured_at == pytest.approx(19.9)
    assert store.latest_at(15.0)[0].captured_at == 15.0, "it was seen there all the time"
    assert store.latest_at(50.0)[0].captured_at == pytest.approx(19.9)
    assert store.trajectory("cup", 12.0, 15.0)[:, 0].tolist() == [12.0]


@pytest.mark.parametrize(
    "change",
    [
        {"inside": "box"},
        {"valid": False},
        {"facts": (("open", True),)},
        {"orientation": (1.0, 0, 0, 0)},
    ],
)
def test_any_change_of_a_standing_thing_is_written(
    store: SqlStore, change: dict[str, object]
) -> None:
    store.write([seen(1.0, 5.0), seen(2.0, 5.0, **change), seen(3.0, 5.0)])
    assert [store.latest_at(at)[0].captured_at for at in (1.5, 3.0)] == [1.0, 3.0]
    if change != {"valid": False}:
        assert len(store.trajectory("cup", 0.0, 9.0)) == 3


def test_after_a_long_silence_a_standing_thing_is_not_said_to_have_been_seen_meanwhile(
    store: SqlStore,
) -> None:
    store.write([seen(1.0, 5.0), seen(2.0, 5.0)])
    store.write([seen(1000.0, 5.0)])
    assert [store.latest_at(at)[0].captured_at for at in (1.5, 500.0, 1001.0)] == [1.5, 2.0, 1000.0]


def test_a_slow_drift_is_not_taken_for_standing_still(store: SqlStore) -> None:
    store.write([seen(float(k), 0.001 * k) for k in range(100)])
    path = store.trajectory("cup", 0.0, 100.0)
    assert len(path) > 30
    assert np.abs(path[:, 1] - 0.001 * path[:, 0]).max() <= 0.002 + 1e-9


def test_a_trajectory_is_by_time_by_source_and_decimated(store: SqlStore) -> None:
    store.write([*walk(0.0, 1000), *walk(0.005, 1000, source="laser")])
    both = store.trajectory("cup", 2.0, 4.0)
    assert len(both) == pytest.approx(400, abs=2)
    assert (np.diff(both[:, 0]) >= 0).all()
    assert len(store.trajectory("cup", 2.0, 4.0, source="vicon")) == 201
    thin = store.trajectory("cup", 2.0, 4.0, source="vicon", every=0.5)
    assert 4 <= len(thin) <= 6
    assert np.interp(thin[:, 0], both[:, 0], both[:, 1]) == pytest.approx(thin[:, 1], abs=0.011)
    assert store.trajectory("nobody", 0.0, 9.0).shape == (0, 4)


def test_events_are_found_by_thing_kind_cause_and_time(store: SqlStore) -> None:
    bell = RoomEvent("bell pressed", "door", 100.0, "bell", "person-1", 0.9, (("rings", 2.0),))
    opened = RoomEvent("door opened", "door", 110.0, "switch", "person-2")
    taken = RoomEvent("object taken", "cup", 120.0, "tags")
    store.write([], [taken, opened, bell])
    store.write([], [bell])
    assert store.events(0.0, 1000.0) == (bell, opened, taken)
    assert {event.cause for event in store.events(0.0, 115.0, thing="door")} == {
        "person-1",
        "person-2",
    }
    assert store.events(0.0, 1000.0, kind="bell pressed") == (bell,)
    assert store.events(0.0, 1000.0, cause="person-2", thing="door") == (opened,)
    assert store.events(101.0, 109.0) == ()


def test_writing_the_same_again_changes_nothing(store: SqlStore) -> None:
    store.write(walk(0.0, 50))
    before = store.trajectory("cup", 0.0, 9.0)
    store.write(walk(0.0, 50))
    assert (store.trajectory("cup", 0.0, 9.0) == before).all()


def test_a_late_sample_lands_in_its_place_and_is_not_the_latest(store: SqlStore) -> None:
    store.write([seen(10.0, 1.0), seen(20.0, 2.0)])
    store.write([seen(15.0, 1.5)])
    assert store.latest("cup")[0].captured_at == 20.0
    assert store.trajectory("cup", 0.0, 99.0)[:, 1].tolist() == [1.0, 1.5, 2.0]


def test_a_row_that_cannot_be_kept_is_refused_and_nothing_of_its_batch_stays(
    store: SqlStore,
) -> None:
    with pytest.raises(RejectedRowError, match="the database cannot hold it"):
        store.write([seen(1.0, 5.0), seen(float("nan"), 5.0, thing="\ud800")])
    assert store.latest() == ()
    store.write([seen(1.0, 5.0)])
    assert len(store.latest()) == 1


def test_old_samples_are_thinned_then_removed_and_events_stay(address: str) -> None:
    day = 24 * HOUR
    store = open_store(address, keep_days=1.0)
    store.write(walk(1000.0, 3000), [RoomEvent("bell pressed", "door", 1000.0, "bell")])
    store.write([seen(1000.0, 3.0, "box"), seen(1500.0, 3.0, "box")])
    assert not store.prune(1500.0), "nothing is an hour old"
    steps = 0
    while store.prune(1000.0 + 2 * HOUR):
        steps += 1
    path = store.trajectory("cup", 0.0, 2000.0)
    assert steps >= 2 and 300 <= len(path) <= 301
    assert np.diff(path[:, 0]).min() > 0.05
    assert path[-1, 0] == 1000.0 + 29.99, "the last word of a source stays"
    assert len(store.trajectory("box", 0.0, 2000.0)) == 2
    while store.prune(1000.0 + 2 * day):
        pass
    assert store.trajectory("cup", 0.0, 2000.0).shape == (0, 4)
    assert len(store.latest("cup")) == 1
    assert len(store.events(0.0, 2000.0)) == 1
    store.close()


def test_one_step_of_tidying_is_short(address: str) -> None:
    store = open_store(address, keep_days=1.0)
    store.write(walk(0.0, 20_000))
    steps = 0
    while store.prune(2 * HOUR):
        steps += 1
    assert steps >= 4, "at most 5000 rows in one transaction"
    assert len(store.trajectory("cup", 0.0, 1000.0)) == pytest.approx(2000, abs=2)
    store.close()


def test_an_older_database_is_brought_up_to_date(address: str) -> None:
    old = SqlStore(open_store(address)._database, steps=MIGRATIONS)
    old._database.query("DROP TABLE viewpoint")
    old._database.query("DROP TABLE tidied")
    old._database.query("DELETE FROM schema WHERE version > 1")
    old.write([seen(1.0, 5.0)])
    old.close()
    new = open_store(address)
    assert version_of(new._database) == len(MIGRATIONS)
    new.put_things([CUP])
    assert new.things() == (CUP,)
    assert new.latest("cup")[0].position == (5.0, 0.0, 0.5)
    new.close()


def test_a_migration_that_fails_changes_nothing(address: str) -> None:
    open_store(address).close()
    broken = (*MIGRATIONS, ("CREATE TABLE half (a INTEGER)", "CREATE TABLE thing (again INTEGER)"))
    with pytest.raises(StoreError):
        SqlStore(open_store(address)._database, steps=broken)
    store = open_store(address)
    assert version_of(store._database) == len(MIGRATIONS)
    with pytest.raises(StoreError):
        store._database.query("SELECT * FROM half")
    store.close()


def test_a_newer_database_is_refused_in_words(address: str) -> None:
    store = open_store(address)
    store._database.query("INSERT INTO schema (version) VALUES (99)")
    store.close()
    with pytest.raises(
        StoreError,
        match=(
            f"is of version 99, this program knows versions up to {len(MIGRATIONS)};"
            " install the newer"
        ),
    ):
        open_store(address)


def test_events_go_after_their_days_and_stay_for_good_without(address: str) -> None:
    for days, left in ((0.0, [10.0, 1e6]), (1.0, [1e6])):
        store = open_store(address, keep_events_days=days)
        store.write((), [RoomEvent("bell pressed", "bell", at, "bell") for at in (10.0, 1e6)])
        store.prune(1e6 + 100.0)
        assert [one.at for one in store.events(0.0, 2e6)] == left
        store.close()
