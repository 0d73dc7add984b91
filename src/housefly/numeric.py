"""How the numeric steps are compiled, and the scalar helpers that all of them share.

Compiled functions take and return plain floats and tuples, so the live pilot and a campaign over thousands of drones call the
same code. They are cached on disk and release the interpreter lock. No ``fastmath``: the same inputs must give the same bits.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from hashlib import sha256
from math import pi
from pathlib import Path
from typing import Any, TypeVar, cast

import numpy as np
from numba import config, njit

Function = TypeVar("Function", bound=Callable[..., Any])

HERE = Path(__file__).parent
FOLDERS = ("estimation", "behavior", "control", "safety", "experiments")
"""Where compiled functions live, and the files beside this one."""


def _version() -> str:
    """Return a name for the present state of every source that holds compiled functions."""
    sources = [HERE / "numeric.py", HERE / "geometry.py", *(file for name in FOLDERS for file in (HERE / name).glob("*.py"))]
    stamps = ((str(file), file.stat().st_mtime_ns, file.stat().st_size) for file in sorted(sources))
    return sha256(repr(tuple(stamps)).encode()).hexdigest()[:16]


# The compiler's own cache looks at a function's own file only, so a caller would keep the old code of what it calls.
if not config.CACHE_DIR and os.access(HERE / "__pycache__", os.W_OK):
    config.CACHE_DIR = str(HERE / "__pycache__" / f"compiled-{_version()}")


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
