"""The lines of a Tello: what is told is read as it was, and nothing else is read."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.tello.answers import (
    AnswerKind,
    decode_tello_answer,
    encode_tello_answer,
    refusal,
    value,
)
from housefly.wires.tello.lines import (
    Direction,
    Go,
    Question,
    SetSpeed,
    Step,
    Sticks,
    Word,
    decode_line,
    encode_line,
)

stick = st.integers(-100, 100)
offset = st.integers(-500, 500)
straight = st.sampled_from([one for one in Direction if not one.turns])
around = st.sampled_from([one for one in Direction if one.turns])
lines = st.one_of(
    st.sampled_from(Word),
    st.sampled_from(Question),
    st.builds(Sticks, stick, stick, stick, stick),
    st.builds(Step, straight, st.integers(20, 500)),
    st.builds(Step, around, st.integers(1, 360)),
    st.builds(Go, st.integers(20, 500), offset, offset, st.integers(10, 100)),
    st.builds(SetSpeed, st.integers(10, 100)),
)


@given(lines)
def test_what_is_told_is_read_as_it_was(line):
    assert decode_line(encode_line(line)) == line
    assert decode_line(encode_line(line) + b"\r\n") == line


@given(st.one_of(st.binary(max_size=80), st.text(max_size=40).map(str.encode)))
def test_any_bytes_are_a_line_or_a_wire_error(data):
    try:
        line = decode_line(data)
    except WireError:
        return
    assert decode_line(encode_line(line)) == line


@given(st.binary(max_size=300))
def test_any_bytes_are_an_answer_or_a_wire_error(data):
    try:
        answer = decode_tello_answer(data)
    except WireError:
        return
    assert decode_tello_answer(encode_tello_answer(answer)) == answer


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"rc 0 0 0", "rc with 3 numbers; allowed: 4"),
        (b"rc 0 0 0 101", "rc: 101; allowed: -100 to 100"),
        (b"rc 0 0 0 1.5", "rc: '1.5' is no whole number"),
        (b"rc 0 0 0 --5", "is no whole number"),
        (b"up 19", "up: 19; allowed: 20 to 500"),
        (b"cw 361", "cw: 361; allowed: 1 to 360"),
        (b"go 1 2 3 10", "allowed: one of them 20 cm or more"),
        (b"go 100 0 0 9", "go: 9; allowed: 10 to 100"),
        (b"takeoff now", "no command of a Tello"),
        (b"", "no command of a Tello"),
        (b"\xff\xfe", "not text"),
        (b"up " + b"1" * 300, "allowed: 256"),
    ],
)
def test_what_is_wrong_is_named_with_what_is_allowed(data, told):
    with pytest.raises(WireError) as error:
        decode_line(data)
    assert told in str(error.value)


@pytest.mark.parametrize(
    "line", [Sticks(up=101), Step(Direction.UP, 5), Go(0, 19, 0, 50), SetSpeed(101)]
)
def test_no_line_leaves_that_a_tello_refuses(line):
    with pytest.raises(WireError):
        encode_line(line)


@pytest.mark.parametrize(
    ("data", "kind", "text"),
    [
        (b"ok", AnswerKind.DONE, "ok"),
        (b"OK\r\n", AnswerKind.DONE, "ok"),
        (b"error", AnswerKind.REFUSED, "error"),
        (b"error Motor stop", AnswerKind.REFUSED, "error Motor stop"),
        (b"unknown command: foo", AnswerKind.REFUSED, "unknown command: foo"),
        (b"FALSE", AnswerKind.REFUSED, "FALSE"),
        (b"87\r\n", AnswerKind.VALUE, "87"),
    ],
)
def test_answers_are_told_apart(data, kind, text):
    answer = decode_tello_answer(data)
    assert (answer.kind, answer.text) == (kind, text)


def test_what_the_twin_answers_is_read_as_it_was():
    assert (
        decode_tello_answer(encode_tello_answer(refusal("Motor stop"))).text == "error Motor stop"
    )
    assert decode_tello_answer(encode_tello_answer(value("83~86C"))) == value("83~86C")
