"""A flight has the same bits on every x86-64 processor that has AVX2 and FMA.

numpy, its BLAS and its sorts choose code by processor: last digits differ, or the order of equals.
``benchmarks/processors.py`` finds which functions do; none of them may decide a flight.
"""

from __future__ import annotations

import ast
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import processor_flights
import pytest

import housefly

PACKAGE = Path(housefly.__file__).parent
FREE = {
    "lab/safety_case": "counts what was flown",
    "hub": "remembers; it flies nothing, and its answers are no part of a flight's inputs",
    "lab/campaigns/plots.py": "draws",
    "lab/frames": "judges recordings",
    "lab/identification": "fits recordings",
    "lab/reproduction": "judges and draws what was flown",
    "lab/tuning": "advises on gains, which a person writes into a site file",
    "lab/experiments/intervals.py": "statistics of what was flown",
    "record": "judges and draws what was flown",
    "room/draft": "makes a room file; it is the file that is flown",
    "evidence": "blanks pictures",
    "tracking/live_check.py": "tells a person how far a body that rests is scattered",
    "web": "draws",
}
"""What decides no flight."""
EXACT = {
    *("abs", "absolute", "add", "subtract", "multiply", "divide", "negative", "square", "sqrt"),
    *("floor", "ceil", "rint", "trunc", "remainder", "mod", "fmod", "divmod", "floor_divide"),
    *("maximum", "minimum", "fmax", "fmin", "sign", "copysign", "clip", "isfinite", "isnan"),
    *("isinf", "logical_and", "logical_or", "logical_not", "logical_xor", "greater", "less"),
    *("equal", "not_equal", "greater_equal", "less_equal", "bitwise_and", "bitwise_or", "invert"),
}
"""Functions by element that IEEE 754 rounds in one way, or that round nothing."""
ALLOWED = {"hypot": "one call of libm, whose hypot has one kernel"}
"""Functions by element that are not exact, and why they are the same all the same."""
FOREIGN = {"scipy.special": "ndtr and ndtri: plain C that calls libm (campaigns/draws.py)"}
"""Parts of other libraries that compute, and why they are the same."""
REFUSED = {
    "BLAS": ("dot", "vdot", "inner", "matmul", "tensordot", "convolve", "correlate", "linalg"),
    "a function of another one": ("angle", "sinc", "polyfit", "fft", "polynomial", "corrcoef"),
    "unstable": ("argpartition", "partition"),
}
"""Functions that are built on what differs. Sums, ``einsum`` and ``interp`` are not: they are
compiled once for every processor.
"""
USE = "use math, or elementwise, norm or einsum (housefly.numeric)"


def deciding_files() -> list[Path]:
    """Every source that has a part in what is flown and computes with arrays."""
    free = tuple(PACKAGE / name for name in FREE)
    return [
        path
        for path in sorted(PACKAGE.rglob("*.py"))
        if not any(path == each or each in path.parents for each in free)
        and any(word in path.read_text(encoding="utf-8") for word in ("numpy", "numeric", "scipy"))
    ]


def objections(source: str) -> Iterator[tuple[int, str]]:
    """Yield the line and the reason of each call that another processor may answer otherwise."""
    tree = ast.parse(source)
    compiled = {
        inner
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef) and any(map(_compiles, node.decorator_list))
        for inner in ast.walk(node)
    }
    by_rows = {call.func.value for call in ast.walk(tree) if _is_norm_of_rows(call)}
    for node in ast.walk(tree):
        match node:
            case ast.BinOp(op=ast.MatMult()) | ast.AugAssign(op=ast.MatMult()):
                yield node.lineno, "@ is BLAS"
            case ast.Attribute(value=ast.Name(id="np"), attr=name) if node not in by_rows:
                if why := _why_not(name):
                    yield node.lineno, f"np.{name}: {why}"
            case ast.Call(func=ast.Attribute(attr="dot")):
                yield node.lineno, ".dot() is BLAS"
            case ast.Call(func=ast.Attribute(attr="argsort" | "argpartition" as name)):
                kind = {word.arg: ast.unparse(word.value) for word in node.keywords}.get("kind")
                if kind != "'stable'":
                    yield node.lineno, f"{name} without kind='stable' leaves the order of equals"
            case ast.BinOp(op=ast.Pow(), left=left, right=power) if node not in compiled:
                if not _is_exact_power(left, power):
                    yield node.lineno, "** is np.power for arrays: use math.pow or a product"
            case ast.Import() | ast.ImportFrom():
                yield from _foreign(node)


def _compiles(decorator: ast.expr) -> bool:
    return isinstance(decorator, ast.Name) and decorator.id.startswith("compiled")


def _is_norm_of_rows(node: ast.AST) -> bool:
    """With an axis it is the root of a sum of squares; without one it is BLAS."""
    match node:
        case ast.Call(func=ast.Attribute(value=ast.Attribute(attr="linalg"), attr="norm")):
            return any(word.arg == "axis" for word in node.keywords)
    return False


def _why_not(name: str) -> str:
    found = getattr(np, name, None)
    if isinstance(found, np.ufunc) and name not in EXACT | ALLOWED.keys():
        return f"differs with AVX-512; {USE}"
    return next((f"{why}; {USE}" for why, names in REFUSED.items() if name in names), "")


def _is_exact_power(left: ast.expr, power: ast.expr) -> bool:
    """Squares and roots are exact for arrays, too; whole numbers are Python's own."""
    if isinstance(power, ast.Constant) and power.value in (2, 0.5):
        return True
    return isinstance(left, ast.Constant) and (
        isinstance(left.value, int) or isinstance(power, ast.Constant)
    )


def _foreign(node: ast.Import | ast.ImportFrom) -> Iterator[tuple[int, str]]:
    if isinstance(node, ast.Import):
        names = [alias.name for alias in node.names if alias.asname != "np"]
    else:
        names = [node.module or ""]
    for name in names:
        is_scipy = name.split(".")[0] == "scipy" and name not in FOREIGN
        if is_scipy or (name.startswith("numpy") and name != "numpy.typing"):
            yield node.lineno, f"{name} hides what is called"


def test_nothing_that_differs_by_processor_decides_a_flight() -> None:
    found = [
        f"{path.relative_to(PACKAGE)}:{line}: {why}"
        for path in deciding_files()
        for line, why in objections(path.read_text(encoding="utf-8"))
    ]
    assert found == []


def test_every_folder_that_is_left_out_is_there() -> None:
    assert [name for name in FREE if not (PACKAGE / name).exists()] == []


@pytest.mark.parametrize(
    "line",
    [
        "np.arctan2(y, x)",
        "each = np.cos",
        "a @ b",
        "a @= b",
        "a.dot(b)",
        "np.linalg.norm(a)",
        "np.linalg.solve(a, b)",
        "np.argsort(a)",
        "a.argsort(kind='quicksort')",
        "a**3",
        "a**b",
        "0.5**a",
        "from scipy.linalg import expm",
        "from numpy.linalg import norm",
        "import numpy.fft",
    ],
)
def test_the_check_refuses_what_differs(line: str) -> None:
    assert list(objections(line))


@pytest.mark.parametrize(
    "line",
    [
        "np.linalg.norm(a, axis=1)",
        "np.hypot(a, b)",
        "np.einsum('nk,k->n', a, b)",
        "a.sum()",
        "np.argsort(a, kind='stable')",
        "a**2 + b**0.5 + 2**c",
        "math.pow(a, b)",
        "import numpy as np",
        "@compiled\ndef cube(a):\n    return a**3",
    ],
)
def test_the_check_lets_pass_what_is_the_same(line: str) -> None:
    assert not list(objections(line))


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_an_older_processor_replays_and_flies_the_same_bits() -> None:
    """All of numpy's newer instructions off, and the linear algebra of 2008."""
    older = {
        "NPY_DISABLE_CPU_FEATURES": " ".join(processor_flights.enabled()),
        "OPENBLAS_CORETYPE": "Nehalem",
    }
    command = [sys.executable, processor_flights.__file__]
    with subprocess.Popen(command, env=os.environ | older, stdout=subprocess.PIPE) as process:
        here = processor_flights.flights()
        told = json.loads(process.communicate()[0])
    assert told["features"] == []
    assert told["replays"] == {"default": "", "paper": "", "troubles": ""}
    assert told["flights"] == here
    assert all(here[name].startswith("completed") for name in processor_flights.MODES)
