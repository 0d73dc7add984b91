"""Whatever arrives is a checked command or an error in words."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.homeassistant.commands import (
    MAX_COMMAND,
    AnswerCommand,
    DroneCommand,
    DroneVerb,
    YesOrNo,
    answer_command,
    drone_command,
)

PLAIN = st.sampled_from([verb for verb in DroneVerb if verb is not DroneVerb.GO])
WORDS = st.text(
    st.characters(codec="ascii", categories=["L", "N"]), min_size=1, max_size=80
).filter(lambda word: word not in ("yes", "no"))


@given(st.binary(max_size=2 * MAX_COMMAND))
def test_any_bytes_are_a_command_or_an_error(payload: bytes) -> None:
    for read in (drone_command, answer_command):
        try:
            assert isinstance(read(payload), DroneCommand | AnswerCommand)
        except WireError as error:
            assert len(str(error)) < 300


@given(PLAIN, WORDS)
def test_only_go_has_a_place(verb: DroneVerb, place: str) -> None:
    assert drone_command(verb.value.encode()) == DroneCommand(verb)
    assert drone_command(f"go {place}".encode()) == DroneCommand(DroneVerb.GO, place)
    for wrong in (f"{verb.value} {place}", "go", f"{verb.value}\x00"):
        with pytest.raises(WireError):
            drone_command(wrong.encode())


@given(st.integers(1, 10**15 - 1), WORDS, WORDS)
def test_an_answer_names_the_question_that_it_means(task: int, question: str, choice: str) -> None:
    told = answer_command(f"{task}|{question}|{choice}".encode())
    assert told == AnswerCommand(choice, task, question)
    assert answer_command(f"{task}|{question}|yes".encode()).choice is YesOrNo.YES
    assert answer_command(b"no") == AnswerCommand(YesOrNo.NO)


@pytest.mark.parametrize(
    "payload",
    [
        *(b"maybe", b"12", b"12|confirm", b"0|confirm|yes", b"-1|confirm|yes", b"1.5|confirm|yes"),
        *(b"1||yes", b"1|confirm|", b"9999999999999999|a|b", b"1|a|b\x00", b"\xff"),
        b"1|a|" + b"b" * 81,
    ],
)
def test_what_is_no_answer_is_refused(payload: bytes) -> None:
    with pytest.raises(WireError):
        answer_command(payload)
