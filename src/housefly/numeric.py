"""How the numeric steps are compiled, and the scalar helpers that all of them share.

Compiled functions take and return plain floats and tuples, so the live pilot and a campaign over
thousands of drones call the same code. They are cached on disk and release the interpreter lock. No
``fastmath``: the same inputs must give the same bits, on every processor.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from functools import reduce
from math import pi, sqrt
from operator import add
from pathlib import Path
from typing import Any, Protocol, TypeVar, cast

import numpy as np
from numba.core import config
from numba.typed import List
from numpy.typing import NDArray

from housefly._compile_cache import CompileCache
from housefly._compile_cache import made_by as made_by
from housefly._compiled_function import CompiledFunction

Function = TypeVar("Function", bound=Callable[..., Any])
Value = TypeVar("Value")

FloatArray = NDArray[np.float64]
"""An array of double-precision numbers; its shape stands where it is used."""

HERE = Path(__file__).parent


def _cache_place() -> Path:
    """Return the folder of compiled code: the wanted one, the one beside us, or the user's."""
    if wanted := os.environ.get("NUMBA_CACHE_DIR"):
        return Path(wanted) / "housefly"
    if os.access(HERE, os.W_OK):
        return HERE / "__pycache__"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "housefly"


CACHE = _cache_place() / "compiled"
"""Where compiled code is kept: in NUMBA_CACHE_DIR, beside this file, or, where that cannot be
written to, in the user's cache.
"""
OPTIONS: dict[str, Any] = {
    "nogil": True,
    "forceinline": True,
    "error_model": "numpy",
    "_nrt": False,
}


def compiled(function: Function) -> Function:
    """Compile a numeric function that makes no array or list, and keep its type;
    ``function.py_func`` is the plain one.

    It is put into its callers whole. Without the counting of references, which such a function does
    not need, the loop over many drones is four times as fast; and a division by zero gives infinity
    or nan in place of an exception.
    """
    return cast(Function, _kept(function, OPTIONS))


def compiled_with_arrays(function: Function) -> Function:
    """Compile a numeric function that makes arrays or lists of its own, and keep its type."""
    return cast(Function, _kept(function, {"nogil": True}))


def _kept(function: Function, options: dict[str, Any]) -> Any:
    """Let the compiler look for machine code on disk; without a compiler it is a plain function."""
    if getattr(config, "DISABLE_JIT", 0):
        return function
    wanted = {"nopython": True, "boundscheck": None, **options}
    dispatcher: Any = CompiledFunction(py_func=function, targetoptions=wanted)
    dispatcher._cache = CompileCache(dispatcher, CACHE)
    return dispatcher


class CompiledBox(Protocol[Value]):
    """One value that stays with the compiled code, which reads and replaces number 0.

    A tuple of numbers that goes from Python to compiled code and back is taken apart and put
    together number by number: for the estimator's state that takes longer than all that is computed
    with it. A box is handed over as one pointer.
    """

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
def _unboxed(box: CompiledBox[Value]) -> Value:
    return box[0]


def boxed(value: Value) -> CompiledBox[Value]:
    """Return a box that holds a value."""
    return cast("CompiledBox[Value]", _boxed(value))


def unboxed(box: CompiledBox[Value]) -> Value:
    """Return the value in a box, put together for Python."""
    return _unboxed(box)


def elementwise(function: Callable[..., float], *arrays: FloatArray) -> FloatArray:
    """Return a function of ``math`` at each element of arrays of one shape; the same shape.

    numpy's own ``arctan2``, ``exp`` and their like take other code, with other last digits, on
    processors with AVX-512 than on those without (``benchmarks/processors.py``).
    """
    columns = (array.ravel().tolist() for array in arrays)
    values = np.fromiter(map(function, *columns), np.float64, arrays[0].size)
    return values.reshape(arrays[0].shape)


def running_sum(values: Iterable[float]) -> float:
    """Return the sum, added from the first to the last; from Python 3.12 on ``sum`` adds otherwise.

    There it carries what rounding loses, so the last digits would depend on the version.
    """
    return reduce(add, values, 0.0)


def norm(vector: FloatArray) -> float:
    """Return the length of a vector, shape (3,); numpy's own depends on the processor's BLAS."""
    x, y, z = vector.tolist()
    return sqrt(x * x + y * y + z * z)


@compiled
def wrapped(angle: float) -> float:
    """Return the same angle [rad] in (-pi, pi]."""
    if -pi < angle <= pi:
        return angle
    return float(angle - 2.0 * pi * np.ceil((angle - pi) / (2.0 * pi)))


@compiled
def clipped(value: float, bound: float) -> float:
    """Return the value limited to -bound .. bound."""
    return min(max(value, -bound), bound)
