"""Words: what they say in English, and what is left of them on the wire, in JSON and in pickles."""

from __future__ import annotations

import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import TypeAdapter, ValidationError

from housefly.bus.codec import from_cdr, to_cdr
from housefly.bus.interfaces import definition, recorded_store, ros_name
from housefly.messages import Event, EventCode, Severity
from housefly.messages.words import (
    UNSAID,
    Number,
    Words,
    figure,
    flat,
    from_tree,
    joined,
    literal,
    percentage,
    said,
    tree,
    unflattened,
)

LOW = Words("battery {p}% is below {q}%", p=percentage(0.124), q=percentage(0.2))
LANDING = Words("{why}: landing", why=LOW)
NAMES = st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
NUMBERS = st.floats(-1e6, 1e6).map(lambda value: figure(value, ".1f"))


def sentences(values: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.one_of(
        values.map(lambda one: Words("{who} is {what} %", who=one, what=UNSAID)),
        st.tuples(values, values).map(lambda two: Words("{d} {m}", m=two[0], d=two[1])),
        st.just(Words("moving aside")),
    )


WORDS = st.recursive(NAMES | NUMBERS, sentences, max_leaves=6).map(
    lambda one: one if isinstance(one, Words) else Words("{one}", one=one)
)


def shape(words: str) -> object:
    """Return all that words are made of, kinds included."""
    if isinstance(words, Words) and words.template:
        return words.template, [shape(one) for one in words.values]
    return isinstance(words, Number), str(words)


def test_words_are_their_english_sentence() -> None:
    assert LANDING == "battery 12% is below 20%: landing" == str(LANDING)
    assert figure(0.3) == "0.3" and figure(2.0, "+.2f") == "+2.00" and percentage(0.5) == "50"
    assert joined("; ", ["a", "b", "c"]) == "a; b; c" and joined(", ", []) == UNSAID == ""
    assert said(Severity.INFO) == "info"


@pytest.mark.parametrize("values", [{}, {"who": "a"}, {"why": "a", "who": "b"}])
def test_a_value_that_is_missing_or_too_much_is_refused(values: dict[str, str]) -> None:
    with pytest.raises(TypeError, match="landing"):
        Words("{why}: landing", **values)


def test_a_name_may_not_stand_twice_so_that_words_cannot_grow_without_end() -> None:
    with pytest.raises(ValueError, match="twice"):
        Words("{a}{a}", a="x")
    with pytest.raises(ValueError, match="twice"):
        unflattened(["%{a}{a}", "=x"])


def test_words_do_not_change() -> None:
    with pytest.raises(AttributeError):
        LANDING.template = "other"


@given(WORDS)
def test_nothing_is_lost_on_the_wire_in_json_and_in_a_pickle(words: Words) -> None:
    for again in (
        unflattened(flat(words)),
        from_tree(tree(words)),
        pickle.loads(pickle.dumps(words)),
    ):
        assert again == words
        assert shape(again) == shape(words) or not words


def test_words_on_the_wire_are_marked_by_their_first_letter() -> None:
    assert flat(LANDING) == ["%{why}: landing", "%battery {p}% is below {q}%", "#12", "#20"]
    assert flat(literal("a note")) == ["=a note"] and flat(UNSAID) == []
    assert tree(LANDING) == [
        "{why}: landing",
        ["battery {p}% is below {q}%", {"n": "12"}, {"n": "20"}],
    ]


@pytest.mark.parametrize(
    "parts",
    [
        ["x"],
        [""],
        ["%"],
        ["%{why}: landing"],
        ["%landing", "=too much"],
        [f"%{{a{n}}}" for n in range(30)] + ["=deep"],
    ],
)
def test_what_is_no_words_is_refused(parts: list[str]) -> None:
    with pytest.raises(ValueError, match="words"):
        unflattened(parts)


@pytest.mark.parametrize("bad", [3, [], ["{a}"], ["{a}", {"m": "1"}], [["a"]], {"n": 1}, {}])
def test_json_that_is_no_words_is_refused(bad: object) -> None:
    with pytest.raises(ValidationError):
        TypeAdapter(Words).validate_python(bad)


def test_an_event_keeps_its_words_over_the_wire() -> None:
    event = Event(1.0, Severity.WARNING, EventCode.BATTERY_LOW, LANDING)
    read = from_cdr(Event, to_cdr(event))
    assert read == event and shape(read.text) == shape(LANDING)


def test_words_of_an_older_version_are_read_as_they_are() -> None:
    name = ros_name("Event")
    text = definition(name).replace("housefly_msgs/Words text", "string text")
    older = recorded_store(name, text)
    told = older.types[name](1.0, 0, "going_on", "the way is free")
    read = from_cdr(Event, bytes(older.serialize_cdr(told, name)), older)
    assert read.text == "the way is free" and read.text.template == ""


def test_a_number_is_a_number_and_a_name_that_looks_like_one_is_none() -> None:
    words = Words("{d} m from {place}", d=figure(1.5, ".1f"), place="1.5")
    assert [type(one) for one in unflattened(flat(words)).values] == [Number, str]
