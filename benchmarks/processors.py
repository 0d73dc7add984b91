"""Which functions give other bits on an older processor, and what it costs to do without them.

Older processors are imitated: numpy, its linear algebra (OpenBLAS) and libm are told to leave newer
instructions alone. ``--flights`` flies the services of ``make test`` on each, compiled anew.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import subprocess
import sys
import timeit
from collections.abc import Callable, Iterable
from pathlib import Path

import numpy as np
import numpy._core._multiarray_umath as umath  # type: ignore[import-not-found]

from housefly.numeric import elementwise, norm

FLIGHTS = Path(__file__).parents[1] / "tests" / "support" / "processor_flights.py"
LIBM = "GLIBC_TUNABLES"
OLDER = {
    "numpy without AVX-512": {"NPY_DISABLE_CPU_FEATURES": "AVX512_ICL X86_V4"},
    "numpy without AVX2": {"NPY_DISABLE_CPU_FEATURES": "AVX512_ICL X86_V4 X86_V3"},
    "OpenBLAS for AVX-512": {"OPENBLAS_CORETYPE": "SkylakeX"},
    "OpenBLAS for AVX2": {"OPENBLAS_CORETYPE": "Haswell"},
    "OpenBLAS of 2008": {"OPENBLAS_CORETYPE": "Nehalem"},
    "libm without AVX-512": {LIBM: "glibc.cpu.hwcaps=-AVX512F,-AVX512VL"},
    "libm without AVX2 and FMA": {LIBM: "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA,-FMA4"},
}
COMPILERS = {
    "compiled for x86-64 of 2003": {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""},
    "compiled for Haswell": {"NUMBA_CPU_NAME": "haswell", "NUMBA_CPU_FEATURES": "+avx2,+fma"},
}
OF_ONE = ("sin", "cos", "tan", "arctan", "exp", "log", "log10", "cbrt", "sqrt", "rint", "cumsum")
OF_MATH = ("sin", "cos", "tan", "atan", "exp", "exp2", "log", "cbrt", "sqrt")
Numbers = np.ndarray


def answers() -> dict[str, Numbers]:
    """Return what each function makes of the same numbers."""
    random = np.random.Generator(np.random.PCG64(1))
    x, y, rows = random.uniform(0.01, 5, 9999), random.uniform(-5, 5, 9999), random.random((999, 3))
    matrix, wide = random.random((3, 3)), random.random((99, 57))
    found = {f"np.{name}": getattr(np, name)(x) for name in OF_ONE}
    found |= {f"math.{name}": elementwise(getattr(math, name), x) for name in OF_MATH}
    return found | {
        "math.atan2": elementwise(math.atan2, y, x),
        "math.pow": elementwise(math.pow, x, y),
        "math.hypot": elementwise(math.hypot, x, y),
        "np.arctan2": np.arctan2(y, x),
        "np.hypot": np.hypot(x, y),
        "np.power": np.power(x, y),
        "array ** 2": y**2,
        "array ** 3": y**3,
        "sum": wide.sum(axis=1),
        "mean, std": np.stack([wide.mean(axis=1), wide.std(axis=1)]),
        "np.interp": np.interp(x, np.sort(y), x),
        "np.percentile": np.percentile(wide, (5, 50, 99.9), axis=1),
        "np.einsum": np.einsum("nk,km->nm", rows, matrix),
        "np.linalg.norm, axis": np.linalg.norm(wide, axis=1),
        "np.linalg.norm": np.array([np.linalg.norm(row) for row in rows]),
        "norm": np.array([norm(row) for row in rows]),
        "vector @ vector": np.array([row @ row for row in rows]),
        "rows @ matrix": rows @ matrix,
        "np.linalg.solve": np.linalg.solve(matrix, rows.T),
        "np.convolve": np.convolve(x[:200], y[:50]),
        "argsort of equals": np.argsort(np.rint(y)),
        "argsort of equals, stable": np.argsort(np.rint(y), kind="stable"),
        "np.sort": np.sort(y),
        "standard_normal": random.standard_normal(9999),
    }


def asked(environment: dict[str, str], *command: str) -> dict[str, str]:
    """Return what a process under an environment prints."""
    done = subprocess.run(
        [sys.executable, *command], env=os.environ | environment, stdout=subprocess.PIPE, check=True
    )
    told: dict[str, str] = json.loads(done.stdout)
    return told


def imitated() -> dict[str, dict[str, str]]:
    """Return the processors that this one can stand for."""
    return {
        name: environment
        for name, environment in OLDER.items()
        if umath.__cpu_features__["AVX512F"] or name != "OpenBLAS for AVX-512"
    }


def other(here: dict[str, str], there: dict[str, str]) -> list[str]:
    return [name for name, value in here.items() if there[name] != value]


def functions() -> None:
    """Print which functions differ."""
    here = asked({}, __file__, "--answers")
    print(f"| other bits of {len(here)} functions | on |\n|---|---|")
    for name, environment in imitated().items():
        differ = other(here, asked(environment, __file__, "--answers"))
        print(f"| {', '.join(f'`{each}`' for each in differ) or 'none'} | {name} |")


def flights() -> None:
    """Print which flights differ."""
    here = asked({}, str(FLIGHTS))
    print("\n| recordings, services, campaign, search | on |\n|---|---|")
    for name, environment in (imitated() | COMPILERS).items():
        there = asked(environment, str(FLIGHTS))
        differ = [part for part in ("replays", "flights") if here[part] != there[part]]
        print(f"| {', '.join(differ) + ' differ' if differ else 'the same'} | {name} |", flush=True)


def speed() -> None:
    """Print what doing without costs."""
    random = np.random.Generator(np.random.PCG64(1))
    x, y = random.uniform(0.01, 5, 400), random.uniform(-5, 5, 400)
    rows, vector, axes = random.random((19_200, 3)), random.random(3), random.random((3, 3))
    columns = np.ascontiguousarray(rows.T)
    compared: Iterable[tuple[str, Callable[[], object], Callable[[], object]]] = (
        (
            "headings of 30 legs",
            lambda: elementwise(math.atan2, y[:30], x[:30]),
            lambda: np.arctan2(y[:30], x[:30]),
        ),
        (
            "cube roots of 400 places",
            lambda: elementwise(math.cbrt, x),
            lambda: np.cbrt(x),
        ),
        ("length of a vector", lambda: norm(vector), lambda: float(np.linalg.norm(vector))),
        (
            "points of a depth image (160 x 120)",
            lambda: np.einsum("km,kn->mn", axes, columns).T,
            lambda: rows @ axes,
        ),
    )
    print("\n| | ours | numpy's own | ratio |\n|---|---|---|---|")
    for name, ours, own in compared:
        mine, theirs = microseconds(ours), microseconds(own)
        print(f"| {name} | {mine:.1f} us | {theirs:.1f} us | {mine / theirs:.2f} |")


def microseconds(call: Callable[[], object]) -> float:
    return 1e6 * min(timeit.repeat(call, number=200, repeat=9)) / 200


def main() -> None:
    """Print the section."""
    if "--answers" in sys.argv:
        bits = {name: value.tobytes() for name, value in answers().items()}
        print(json.dumps({name: hashlib.sha256(each).hexdigest() for name, each in bits.items()}))
        return
    print("### The same on every processor\n")
    functions()
    if "--flights" in sys.argv:
        flights()
    speed()


if __name__ == "__main__":
    main()
