"""Pydantic's problems as words: its own text, by a template."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import pytest
from pydantic import ConfigDict, Field, TypeAdapter, ValidationError
from pydantic.dataclasses import dataclass

from housefly.config.pydantic_words import words_of


@dataclass(config=ConfigDict(extra="forbid"))
class _Known:
    known: int = 0


CASES: tuple[tuple[Any, Any], ...] = (
    (Annotated[float, Field(le=1000.0)], 2000.0),
    (Annotated[float, Field(le=6.3)], 7),
    (Annotated[float, Field(ge=-0.01)], -1),
    (Annotated[int, Field(lt=65536)], 65536),
    (Annotated[float, Field(gt=0.0)], 0.0),
    (Annotated[float, Field(allow_inf_nan=False)], float("nan")),
    (float, []),
    (float, "high"),
    (int, []),
    (int, "high"),
    (int, 1.5),
    (bool, []),
    (str, 5),
    (tuple[int, ...], 5),
    (Literal["y", "z"], "x"),
    (Annotated[str, Field(min_length=1)], ""),
    (Annotated[str, Field(min_length=2)], ""),
    (Annotated[str, Field(max_length=60)], "a" * 61),
    (Annotated[str, Field(pattern="^[a-z]$")], "A"),
    (Annotated[tuple[int, ...], Field(max_length=2)], (1, 2, 3)),
    (_Known, {"unknown": 1}),
)


@pytest.mark.parametrize(("kind", "value"), CASES, ids=str)
def test_what_pydantic_says_is_said_by_a_template(kind: Any, value: Any) -> None:
    with pytest.raises(ValidationError) as caught:
        TypeAdapter(kind).validate_python(value)
    problem = caught.value.errors()[0]
    words, text = words_of(problem), problem["msg"]
    assert words == text[0].lower() + text[1:]
    assert words.template


def test_what_has_no_template_is_said_as_pydantic_says_it() -> None:
    words = words_of({"type": "json_invalid", "msg": "Invalid JSON: EOF"})
    assert (words, words.template) == ("invalid JSON: EOF", "")
