"""What the numbers of a campaign depend on: drones, ways, and the code that flies them."""

from __future__ import annotations

import hashlib
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm  # type: ignore[import-untyped]

from housefly.lab.campaigns.plan import MODES, Plan
from housefly.lab.experiments.cases import CASE, cases

PACKAGES = ("housefly", "numba", "numpy")
"""What must be the same everywhere, or the numbers would not be."""
FLYING = (
    "pilot/behavior",
    "pilot/control",
    "pilot/estimation",
    "pilot/safety",
    "lab/experiments",
    "geometry.py",
    "numeric.py",
)
"""The code that flies; what plans and configures shows in the ways and columns themselves."""


@cache
def versions() -> dict[str, str]:
    """Return the versions of everything that the numbers depend on; ``code`` marks the source text
    of the code that flies.
    """
    root = Path(__file__).parents[2]
    mark = hashlib.sha256()
    for file in sorted(
        file
        for part in FLYING
        for file in root.glob(part if part.endswith(".py") else f"{part}/**/*.py")
    ):
        mark.update(file.relative_to(root).as_posix().encode() + file.read_bytes())
    return {package: metadata.version(package) for package in PACKAGES} | {
        "code": mark.hexdigest()[:16]
    }


def processor() -> str:
    """Return the type of processor that compiled code is made for."""
    return str(llvm.get_host_cpu_name())


def describe(plan: Plan) -> dict[str, Any]:
    """Return everything that the numbers depend on, as plain values; what is only drawn or said
    stays out.
    """
    legs = {MODES[int(cases(leg.site)["mode"][0])]: leg for leg in plan.legs}
    return {
        "spec": plan.spec.model_dump(
            mode="json", exclude={"name", "site", "plot"}, exclude_none=True
        ),
        "drone": {
            mode: {name: cases(leg.site)[name][0].item() for name in CASE.names or ()}
            for mode, leg in legs.items()
        },
        "way": {
            mode: [list(point) for point in leg.mission.waypoints] for mode, leg in legs.items()
        },
        "height": {mode: leg.mission.height for mode, leg in legs.items()},
        "yaw": {mode: leg.mission.yaw for mode, leg in legs.items()},
        "chunk": max(chunk.drones for chunk in plan.chunks),
        "made_by": versions(),
    }
