"""What hub and tasks publish crosses the bus as typed values, in JSON."""

from __future__ import annotations

import contextlib
import warnings
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.codec import decoded, encoded
from housefly.bus.topics import Topic
from housefly.config.house_mode import HouseMode
from housefly.errors import WireError
from housefly.hub.api.answers import (
    EventAnswer,
    News,
    ObstacleAnswer,
    PlacedThing,
    SituationAnswer,
)
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.topics import TASK_NEWS_TOPIC

TOPICS = (ROOM_NEWS_TOPIC, TASK_NEWS_TOPIC)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
FACTS = st.dictionaries(st.text(), st.one_of(st.text(), NUMBERS, st.booleans()), max_size=3)
VECTORS = st.one_of(st.none(), st.tuples(NUMBERS, NUMBERS, NUMBERS))
MAYBE = st.one_of(st.none(), NUMBERS)


@given(
    st.builds(
        News,
        NUMBERS,
        st.tuples(st.builds(PlacedThing, position=VECTORS, yaw=MAYBE, age=MAYBE, distance=MAYBE)),
        st.tuples(st.builds(EventAnswer, at=NUMBERS, confidence=NUMBERS, facts=FACTS)),
        st.tuples(st.builds(SituationAnswer, since=NUMBERS, confidence=NUMBERS, facts=FACTS)),
        st.just((ObstacleAnswer("a", 1.0, 2.0, 0.5, 0.1, 0.2, 0.9, 0.0, "laser"),)),
    )
)
def test_news_of_the_room_come_as_they_were_published(news: News) -> None:
    assert repr(decoded(ROOM_NEWS_TOPIC, encoded(ROOM_NEWS_TOPIC, news))) == repr(news)


@pytest.mark.parametrize("mode", HouseMode)
def test_the_board_comes_as_it_was_published(mode: HouseMode) -> None:
    board = TaskBoard(1.5, mode, "in the air", True, (), (), ("no space",))
    assert decoded(TASK_NEWS_TOPIC, encoded(TASK_NEWS_TOPIC, board)) == board


def test_a_whole_number_among_the_facts_is_a_number() -> None:
    event = EventAnswer("said", "cup", 1.0, "tasks", "", 1.0, {"count": 3})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        data = encoded(ROOM_NEWS_TOPIC, News(1.0, (), (event,), (), ()))
    assert decoded(ROOM_NEWS_TOPIC, data).events[0].facts == {"count": 3.0}


@pytest.mark.parametrize("topic", TOPICS, ids=lambda topic: topic.key)
@given(st.binary(max_size=100))
def test_other_bytes_are_a_wire_error_and_nothing_else(topic: Topic[Any], data: bytes) -> None:
    with contextlib.suppress(WireError):
        decoded(topic, data)


def test_what_is_wrong_is_named() -> None:
    text = b'{"at": "noon", "things": [], "events": [], "situations": [], "obstacles": []}'
    with pytest.raises(WireError, match="not a News: at: "):
        decoded(ROOM_NEWS_TOPIC, text)
