"""A search in B-sen: from what the memory says to looks, and to what they leave."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.errors import LinkError, TaskError, ThingError
from housefly.geometry import heading_to
from housefly.hub.api.answers import AlternativePlace, WhereAnswer
from housefly.hub.api.questions import Question
from housefly.sites.loaded_site import load_site
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.camera_views import shown_from
from housefly.tasks.vantage.named_search import search_for
from housefly.tasks.vantage.search_places import belief_of
from housefly.tasks.vantage.thing_search import ThingSearch
from housefly.tasks.vantage.viewing_room import ViewingRoom

TABLE = (12.85, 2.2, 0.47)
"""A place on the sofa table [m]."""


@cache
def viewing() -> ViewingRoom:
    loaded = load_site("bsen")
    return ViewingRoom(loaded.site, loaded.room, loaded.grid)


def cup(**changes: object) -> WhereAnswer:
    facts: dict[str, object] = {
        "thing": "cup", "name": "the cup", "kind": "object", "words": "", "position": TABLE,
        "yaw": None, "std": 0.1, "inside": (), "by_container": "", "seen_at": 0.0, "age": 60.0,
        "sources": (), "said": (),
    }  # fmt: skip
    return WhereAnswer(**(facts | changes))  # type: ignore[arg-type]


shares = st.lists(st.floats(0.0, 1.0), min_size=1, max_size=4).map(
    lambda found: [one / max(1.0, sum(found)) for one in found]
)


@settings(max_examples=30)
@given(shares, st.floats(0.0, 1e7), st.floats(0.5, 14.0), st.floats(0.5, 6.0))
def test_whatever_the_memory_says_is_a_belief(
    said: list[float], age: float, x: float, y: float
) -> None:
    others = tuple(AlternativePlace("there", "bed", (x, y, 0.5), share) for share in said[1:])
    belief = belief_of(cup(confidence=said[0], age=age, alternatives=others), viewing())
    assert np.all(belief.probability >= 0.0)
    assert 0.8 < belief.probability.sum() <= 1.0 + 1e-9
    assert belief.of_places().sum() == pytest.approx(belief.probability.sum())


def test_what_was_seen_lately_is_there_and_what_was_not_is_anywhere() -> None:
    def near(age: float | None) -> float:
        answer = None if age is None else cup(age=age)
        belief = belief_of(answer, viewing())
        away = np.linalg.norm(belief.points[:, :2] - np.array(TABLE[:2]), axis=1)
        return float(belief.probability[away < 1.2].sum())

    assert near(10.0) > 0.8 > near(86_400.0) > near(10 * 86_400.0) > near(None)


def test_what_somebody_carries_is_with_them() -> None:
    anna = SeenPerson("anna", (8.6, 3.6, 0.0), (0.0, 0.0), 0.1)
    belief = belief_of(cup(inside=("anna",)), viewing(), (anna,))
    best = int(np.argmax(belief.probability))
    assert belief.points[best].tolist() == [8.6, 3.6, 1.0]
    assert belief.places[belief.place[best]] == "with anna"


def test_the_first_look_is_where_the_memory_has_it_and_shows_it() -> None:
    search = ThingSearch(viewing(), belief_of(cup(), viewing()))
    first, *_ = looks = search.looks()
    heading = heading_to(first.view.position, first.view.look_at[:2])
    place = np.array([first.view.position])
    assert shown_from(viewing(), place, np.array([heading]), np.array([TABLE]))[0, 0]
    assert first.chance > 0.4 and "the sofa table" in first.places
    assert first.chance == max(look.chance for look in looks)


def test_each_look_in_vain_leaves_less_until_no_flight_is_worth_it() -> None:
    search = ThingSearch(viewing(), belief_of(None, viewing()))
    flown, covered, rows = 0, [0.0], set[int]()
    while looks := search.looks(least=0.005):
        before = 1.0 - search.belief.probability.sum()
        search.was_shown(looks[0], nothing=flown % 2 == 0)
        flown += 1
        assert looks[0].row not in rows, "a second picture would show the same"
        rows.add(looks[0].row)
        summary = search.summary()
        assert 1.0 - search.belief.probability.sum() > before
        assert summary.covered >= covered[-1] >= 0.0 and summary.answered <= summary.covered
        covered.append(summary.covered)
        assert flown < 60
    assert flown > 5 and covered[-1] > 0.5
    assert set(summary.looked).isdisjoint(place for place, _ in summary.left)


def test_looks_fit_the_time_and_a_place_left_out_is_not_proposed_again() -> None:
    search = ThingSearch(viewing(), belief_of(cup(), viewing()))
    assert search.looks(budget=5.0) == ()
    first = search.looks()[0]
    search.leave_out(first)
    assert first.view.position not in [look.view.position for look in search.looks()]
    assert search.summary().covered == 0.0


def test_what_is_in_a_closed_box_is_told_not_to_have_been_looked_at() -> None:
    inside = cup(inside=("refrigerator",), position=(7.18, 5.8, 0.8))
    search = ThingSearch(viewing(), belief_of(inside, viewing()))
    for _ in range(3):
        for look in search.looks()[:1]:
            search.was_shown(look, nothing=True)
    left = dict(search.summary().left)
    assert left["in or on the refrigerator"] > 0.7


@pytest.mark.parametrize(
    ("kind", "words"), [("person", "come, follow"), ("furniture", "look at it")]
)
def test_what_does_not_get_lost_is_not_searched_for(kind: str, words: str) -> None:
    with pytest.raises(TaskError, match=words) as refused:
        search_for("that", viewing(), lambda question: cup(kind=kind))
    assert refused.value.code == "bad_parameter"


@pytest.mark.parametrize("error", [ThingError("no such thing"), LinkError("no memory")])
def test_what_nobody_remembers_is_looked_for_everywhere(error: Exception) -> None:
    def nobody(question: Question) -> WhereAnswer:
        raise error

    search = search_for("keys", viewing(), nobody)
    assert len(search.looks()) > 3
