"""Distributions of drawn columns.

Each drone takes one uniform number per column, so drone k is the same however many fly.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable
from math import exp, inf, isfinite, log
from typing import Annotated, Self

import numpy as np
from pydantic import Field, model_validator

from housefly.config.section import Section
from housefly.errors import ConfigError, MissingPartError
from housefly.lab.experiments.cases import Parameter
from housefly.numeric import FloatArray, elementwise

try:
    from scipy.special import ndtr, ndtri
except ImportError as error:
    raise MissingPartError("scipy (distributions)", "pip install 'housefly[lab]'") from error

ColumnValue = Annotated[float, Field(strict=True)] | str
"""A number, or a word that stands for one; never true or false."""


class Draw(Section):
    """One distribution; exactly one key. All are cut off at the column's own range.

    Attributes:
        uniform: from, to.
        loguniform: from, to; equally likely in every octave.
        normal: mean, one sigma.
        choice: values or words, equally likely.
    """

    uniform: tuple[float, float] | None = Field(default=None, description="from, to")
    loguniform: tuple[float, float] | None = Field(
        default=None, description="from, to; equally likely in every octave"
    )
    normal: tuple[float, float] | None = Field(default=None, description="mean, one sigma")
    choice: tuple[ColumnValue, ...] | None = Field(
        default=None, min_length=1, description="values, equally likely"
    )

    @model_validator(mode="after")
    def _one(self) -> Self:
        if len(self.model_fields_set) != 1:
            raise ValueError(f"give exactly one of {', '.join(type(self).model_fields)}")
        return self

    @property
    def kind(self) -> str:
        """Which distribution it is."""
        return next(iter(self.model_fields_set))

    @property
    def numbers(self) -> tuple[float, ...]:
        """Its numbers, after words have been replaced by numbers."""
        return tuple(float(number) for number in getattr(self, self.kind))

    def check(self, key: str, column: Parameter) -> None:
        """Raise ConfigError when the distribution does not fit the column."""
        unit = "" if column.unit == "1" else f" {column.unit}"
        bounds = f"{column.low:g} to {column.high:g}{unit}"
        if self.kind == "normal":
            mean, sigma = self.numbers
            if not column.low <= mean <= column.high or not 0.0 < sigma < inf:
                raise ConfigError(
                    key,
                    f"normal is [{mean:g}, {sigma:g}]; allowed: a mean from {bounds} and a positive"
                    " sigma",
                )
            return
        low, high = self.numbers
        if not all(
            column.low <= number <= column.high and isfinite(number) for number in (low, high)
        ):
            raise ConfigError(
                key,
                f"{self.kind} is [{low:g}, {high:g}]; allowed: two finite numbers from {bounds}",
            )
        if not low < high:
            raise ConfigError(
                key, f"{self.kind} is [{low:g}, {high:g}]; the first must be below the second"
            )
        if self.kind == "loguniform" and low <= 0.0:
            raise ConfigError(key, f"loguniform is [{low:g}, {high:g}]; both must be positive")

    def at(self, shares: FloatArray, column: Parameter) -> FloatArray:
        """Return the quantiles at these shares, clipped to the column's range."""
        return _QUANTILES[self.kind](shares, self.numbers, column)


def shares_of(name: str, first: int, count: int) -> FloatArray:
    """Return uniform numbers in [0, 1) for drones ``first`` to ``first + count`` of one column."""
    stream = np.random.PCG64(zlib.crc32(name.encode()))
    stream.advance(first)
    return np.random.Generator(stream).random(count)


def _uniform(shares: FloatArray, numbers: tuple[float, ...], column: Parameter) -> FloatArray:
    low, high = numbers
    return low + (high - low) * shares


def _loguniform(shares: FloatArray, numbers: tuple[float, ...], column: Parameter) -> FloatArray:
    low, high = numbers
    return np.clip(elementwise(exp, log(low) + (log(high) - log(low)) * shares), low, high)


def _normal(shares: FloatArray, numbers: tuple[float, ...], column: Parameter) -> FloatArray:
    mean, sigma = numbers
    low, high = ndtr((column.low - mean) / sigma), ndtr((column.high - mean) / sigma)
    drawn: FloatArray = mean + sigma * ndtri(low + (high - low) * shares)
    return np.clip(drawn, column.low, column.high)


def _choice(shares: FloatArray, numbers: tuple[float, ...], column: Parameter) -> FloatArray:
    chosen: FloatArray = np.asarray(numbers, dtype=float)[(shares * len(numbers)).astype(int)]
    return chosen


_QUANTILES: dict[str, Callable[[FloatArray, tuple[float, ...], Parameter], FloatArray]] = {
    "uniform": _uniform,
    "loguniform": _loguniform,
    "normal": _normal,
    "choice": _choice,
}
