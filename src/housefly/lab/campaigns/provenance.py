"""What the results of a campaign depend on: drones, paths, and the code that flies them."""

from __future__ import annotations

import hashlib
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm

from housefly.lab.campaigns.plan import Plan
from housefly.lab.experiments.cases import CASE, cases

_PACKAGES = ("housefly", "numba", "numpy")
"""Packages whose versions must be the same on every machine."""
_FLIGHT_CODE = (
    "pilot/behavior",
    "pilot/control",
    "pilot/estimation",
    "pilot/planning/trajectory",
    "pilot/safety",
    "pilot/step.py",
    "lab/experiments",
    "geometry.py",
    "numeric.py",
)
"""The code that flies. Code that plans or configures shows in the paths and columns themselves."""


@cache
def versions() -> dict[str, str]:
    """Return the versions that the numbers depend on; ``code`` is a hash of the flying code."""
    root = Path(__file__).parents[2]
    mark = hashlib.sha256()
    for file in sorted(
        file
        for part in _FLIGHT_CODE
        for file in root.glob(part if part.endswith(".py") else f"{part}/**/*.py")
    ):
        mark.update(file.relative_to(root).as_posix().encode() + file.read_bytes())
    return {package: metadata.version(package) for package in _PACKAGES} | {
        "code": mark.hexdigest()[:16]
    }


def processor() -> str:
    """Return the kind of processor: those of one kind fly the same bits (same-bits.md)."""
    features = llvm.get_host_cpu_features()
    if features.get("avx2") and features.get("fma"):
        return "x86-64 with AVX2 and FMA"
    return str(llvm.get_host_cpu_name())


def describe_plan(plan: Plan) -> dict[str, Any]:
    """Return everything that the numbers depend on as plain values, without names and plots."""
    modes = {group.site.mode: group.site for group in plan.groups}
    missions = {group.name: group.mission for group in plan.groups}
    return {
        "spec": plan.spec.model_dump(
            mode="json", exclude={"name", "site", "plot"}, exclude_none=True
        ),
        "drone": {
            mode: {name: cases(site)[name][0].item() for name in CASE.names or ()}
            for mode, site in modes.items()
        },
        "way": {
            name: [list(point) for point in mission.waypoints] for name, mission in missions.items()
        },
        "trajectory": {
            name: mission.digest
            for name, mission in missions.items()
            if mission.trajectory is not None
        },
        "height": {name: mission.height for name, mission in missions.items()},
        "yaw": {name: mission.yaw for name, mission in missions.items()},
        "chunk": max(chunk.drones for chunk in plan.chunks),
        "made_by": versions(),
    }
