"""Values that stay with the compiled code from one step to the next.

A tuple of numbers that goes from Python to compiled code and back is taken apart and put together
number by number: for the estimator's state that takes longer than all that is computed with it. A
box is handed over as one pointer.
"""

from __future__ import annotations

from typing import Protocol, TypeVar, cast

from numba.typed import List

from housefly.numeric import compiled_with_arrays

Value = TypeVar("Value")


class Box(Protocol[Value]):
    """One value; compiled code reads and replaces number 0."""

    def __getitem__(self, index: int) -> Value:
        """Return the value; for compiled code only."""
        ...

    def __setitem__(self, index: int, value: Value) -> None:
        """Replace the value; for compiled code only."""
        ...


@compiled_with_arrays
def _boxed(value: object) -> object:
    box = List()
    box.append(value)
    return box


@compiled_with_arrays
def _unboxed(box: Box[Value]) -> Value:
    return box[0]


def boxed(value: Value) -> Box[Value]:
    """Return a box that holds a value."""
    return cast("Box[Value]", _boxed(value))


def unboxed(box: Box[Value]) -> Value:
    """Return the value in a box, put together for Python."""
    return _unboxed(box)
