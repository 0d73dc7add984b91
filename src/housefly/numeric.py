"""How the numeric steps are compiled, and the scalar helpers that all of them share.

Compiled functions take and return plain floats and tuples, so the live pilot and a campaign over thousands of drones call the
same code. They are cached on disk and release the interpreter lock. No ``fastmath``: the same inputs must give the same bits.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any, TypeVar, cast

import numpy as np
from numba import njit

Function = TypeVar("Function", bound=Callable[..., Any])


def compiled(function: Function) -> Function:
    """Compile a numeric function on its first call and keep its type; ``function.py_func`` is the plain one."""
    return cast(Function, njit(cache=True, nogil=True)(function))


@compiled
def wrapped(angle: float) -> float:
    """Return the same angle [rad] in (-pi, pi]."""
    return float(angle - 2.0 * pi * np.ceil((angle - pi) / (2.0 * pi)))


@compiled
def clipped(value: float, bound: float) -> float:
    """Return the value limited to -bound .. bound."""
    return min(max(value, -bound), bound)
