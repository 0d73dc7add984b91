"""From names to viewpoints: places keep their own, things and people get one computed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from housefly.errors import LinkError, TaskError, ThingError
from housefly.geometry import Vec3, distance
from housefly.hub.api.answers import WhereAnswer
from housefly.hub.api.questions import Question, WhereQuestion
from housefly.messages import Obstacle
from housefly.sites.loaded_site import load_site
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.named_subject import round_names, viewpoint_of
from housefly.tasks.vantage.subject import SubjectKind, person_subject
from housefly.tasks.vantage.viewing_room import ViewingRoom

LOADED = load_site("bsen")
VIEWING = ViewingRoom(LOADED.site, LOADED.room, LOADED.grid)
ANNA = SeenPerson("anna", (8.6, 3.6, 0.0), (0.0, 0.0), 0.1)


def nobody(question: Question) -> Any:
    raise LinkError("nobody remembers")


class Memory:
    """Knows where some things are: position [m] and what contains them."""

    def __init__(self, **things: tuple[Vec3 | None, tuple[str, ...]]) -> None:
        self.things = things

    def __call__(self, question: Question) -> Any:
        if not isinstance(question, WhereQuestion):
            raise LinkError("not known here")
        if question.thing not in self.things:
            raise ThingError(f"nothing is called {question.thing!r}")
        position, inside = self.things[question.thing]
        name = f"the {question.thing}"
        return WhereAnswer(
            question.thing, name, "object", "", position, None, None, inside, "", 1.0, 1.0, (), ()
        )


@pytest.mark.parametrize("name", ["entrance", "Entrance", "place-entrance"])
def test_a_named_place_keeps_its_own_viewpoint(name: str) -> None:
    view, place = viewpoint_of(name, VIEWING, nobody), LOADED.room.place("entrance")
    assert (view.position, view.look_at) == (place.viewpoint, place.look_at)


def test_a_place_whose_viewpoint_is_taken_gets_another_that_shows_the_same() -> None:
    place = LOADED.room.place("tv")
    chair = Obstacle("chair", place.viewpoint, 0.3, top=1.5)
    view = viewpoint_of("tv", VIEWING, nobody, obstacles=(chair,))
    assert view.look_at == place.look_at
    assert distance(view.position, place.viewpoint) > 0.6


def test_a_person_who_is_seen_is_looked_at_where_they_are() -> None:
    view = viewpoint_of("anna", VIEWING, nobody, (ANNA,))
    assert view.look_at[:2] == ANNA.position[:2] and view.look_at[2] > 1.2
    assert 1.3 < distance(view.position, ANNA.position[:2]) < 4.0


def test_what_somebody_carries_is_looked_at_at_their_hands() -> None:
    memory = Memory(cup=((1.0, 1.0, 1.0), ("anna",)))
    view = viewpoint_of("cup", VIEWING, memory, (ANNA,))
    assert view.look_at[:2] == ANNA.position[:2]


def test_a_small_thing_is_looked_at_where_the_memory_has_it() -> None:
    view = viewpoint_of("cup", VIEWING, Memory(cup=((12.85, 2.2, 0.47), ())))
    assert view.look_at == (12.85, 2.2, 0.47)


def test_without_a_memory_the_room_model_still_knows_its_furniture() -> None:
    view = viewpoint_of("refrigerator", VIEWING, nobody)
    assert distance(view.look_at[:2], (7.18, 5.8)) < 0.2


@pytest.mark.parametrize(("name", "code"), [("elephant", "unknown_thing"), ("keys", "no_view")])
def test_what_is_unknown_or_lost_is_refused_in_one_sentence(name: str, code: str) -> None:
    with pytest.raises(TaskError) as refused:
        viewpoint_of(name, VIEWING, Memory(keys=(None, ())))
    assert refused.value.code == code and name in str(refused.value)


def test_who_lies_in_bed_is_looked_at_above_the_mattress() -> None:
    lying = person_subject("anna", (10.35, 2.7, 0.0), LOADED.room, "lying")
    standing = person_subject("anna", (8.0, 3.6, 0.0), LOADED.room)
    assert lying.kind is SubjectKind.PERSON and 0.5 < lying.look_at[2] < 0.9
    assert 1.2 < standing.look_at[2] < 1.7
    assert any("bed" in name for name in lying.own)


def test_the_round_over_the_floor_has_numbers_that_can_be_asked_for() -> None:
    views = [viewpoint_of(f"floor {n}", VIEWING, nobody) for n in (1, 2)]
    assert [view.subject for view in views] == ["floor 1", "floor 2"]
    with pytest.raises(TaskError) as refused:
        viewpoint_of("floor 99", VIEWING, nobody)
    assert refused.value.code == "unknown_place"


def test_a_round_looks_at_named_places_or_else_at_the_whole_floor() -> None:
    assert set(round_names(VIEWING)) == {each.name for each in LOADED.room.places} - {"home"}
    bare = replace(LOADED.room, places=(LOADED.room.place("home"),))
    viewing = ViewingRoom(LOADED.site, bare, LOADED.grid)
    names = round_names(viewing)
    assert names == tuple(f"floor {n}" for n in range(1, len(names) + 1)) and len(names) > 3
    assert viewpoint_of(names[-1], viewing, nobody).subject == names[-1]
    no_places = ViewingRoom(LOADED.site, replace(bare, places=()), LOADED.grid)
    assert len(round_names(no_places)) == len(names)
