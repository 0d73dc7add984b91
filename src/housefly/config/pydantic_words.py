"""Pydantic's own problems as words, for whom no declaration says more."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from housefly.messages.words import Number, Words, figure, literal

_Context = Mapping[str, Any]


def _bound(context: _Context, key: str) -> Number:
    return figure(context[key], ".15g")


def _too_long(context: _Context) -> Words:
    return Words(
        "{kind} should have at most {n} items after validation, not {m}",
        kind=str(context["field_type"]).lower(),
        n=figure(context["max_length"]),
        m=str(context["actual_length"]),
    )


_PROBLEMS: dict[str, Callable[[_Context], Words]] = {
    "less_than_equal": lambda c: Words(
        "input should be less than or equal to {n}", n=_bound(c, "le")
    ),
    "greater_than_equal": lambda c: Words(
        "input should be greater than or equal to {n}", n=_bound(c, "ge")
    ),
    "less_than": lambda c: Words("input should be less than {n}", n=_bound(c, "lt")),
    "greater_than": lambda c: Words("input should be greater than {n}", n=_bound(c, "gt")),
    "finite_number": lambda _: Words("input should be a finite number"),
    "float_type": lambda _: Words("input should be a valid number"),
    "float_parsing": lambda _: Words(
        "input should be a valid number, unable to parse string as a number"
    ),
    "int_type": lambda _: Words("input should be a valid integer"),
    "int_parsing": lambda _: Words(
        "input should be a valid integer, unable to parse string as an integer"
    ),
    "int_from_float": lambda _: Words(
        "input should be a valid integer, got a number with a fractional part"
    ),
    "bool_type": lambda _: Words("input should be a valid boolean"),
    "string_type": lambda _: Words("input should be a valid string"),
    "tuple_type": lambda _: Words("input should be a valid tuple"),
    "literal_error": lambda c: Words("input should be {names}", names=c["expected"]),
    "string_too_short": lambda c: (
        Words("string should have at least 1 character")
        if c["min_length"] == 1
        else Words("string should have at least {n} characters", n=figure(c["min_length"]))
    ),
    "string_too_long": lambda c: Words(
        "string should have at most {n} characters", n=figure(c["max_length"])
    ),
    "string_pattern_mismatch": lambda c: Words(
        "string should match pattern '{name}'", name=c["pattern"]
    ),
    "too_long": _too_long,
    "unexpected_keyword_argument": lambda _: Words("unexpected keyword argument"),
    "missing_argument": lambda _: Words("missing required argument"),
}
"""By the type of the problem; what is none of these stays as pydantic says it."""


def words_of(problem: Any) -> Words:
    """Return an item of ``ValidationError.errors()`` in pydantic's words, to follow a colon."""
    found = _PROBLEMS.get(problem["type"])
    if found is not None:
        return found(problem.get("ctx", {}))
    words: str = problem["msg"]
    return literal(f"{words[0].lower()}{words[1:]}")
