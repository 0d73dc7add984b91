"""Shapes that lie far away from all others, by which a plan seems larger than it is."""

from __future__ import annotations

import numpy as np

from housefly.numeric import FloatArray
from housefly.room.draft.imports.drawing import PlanShape
from housefly.room.reach import Mask

_FEW, _SHORT = 0.25, 0.5
"""What is far away is a stray with at most these shares of all straight parts and their length."""
_LONE = 20.0
"""A single straight line that makes the plan so many times as long is a stray."""
_ROUNDS_MAX = 20


def without_strays(shapes: list[PlanShape]) -> tuple[list[PlanShape], list[PlanShape]]:
    """Return the shapes of a plan, and those that lie farther away from it than it is long."""
    boxes = np.array([_box(shape) for shape in shapes]).reshape(-1, 4)
    parts = np.array([max(1, len(shape.points) - 1) for shape in shapes], dtype=np.float64)
    lengths = np.array([_length(shape) for shape in shapes])
    kept: Mask = np.ones(len(shapes), dtype=np.bool_)
    for _ in range(_ROUNDS_MAX):
        far = _beyond_a_gap(boxes, parts, lengths, kept)
        if not far.any():
            far = _lone(boxes, parts, kept)
        if not far.any():
            break
        kept &= ~far
    return (
        [shape for shape, stays in zip(shapes, kept, strict=True) if stays],
        [shape for shape, stays in zip(shapes, kept, strict=True) if not stays],
    )


def _box(shape: PlanShape) -> tuple[float, float, float, float]:
    xs, ys = zip(*shape.points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _length(shape: PlanShape) -> float:
    points = np.array(shape.points)
    return float(np.hypot(*np.diff(points, axis=0).T).sum()) if len(points) > 1 else 0.0


def _extent(boxes: FloatArray) -> float:
    """Return the longer side of what encloses some boxes."""
    if boxes.shape[0] == 0:
        return 0.0
    return float((boxes[:, 2:].max(axis=0) - boxes[:, :2].min(axis=0)).max())


def _beyond_a_gap(boxes: FloatArray, parts: FloatArray, lengths: FloatArray, kept: Mask) -> Mask:
    """Return which few shapes an empty strip parts from the rest that is wider than the rest."""
    nothing: Mask = np.zeros(kept.shape, dtype=np.bool_)
    here = np.flatnonzero(kept)
    for axis in (0, 1):
        order = here[np.argsort(boxes[here, axis], kind="stable")]
        reach = np.maximum.accumulate(boxes[order, axis + 2])
        gaps = boxes[order[1:], axis] - reach[:-1]
        for at in np.argsort(-gaps, kind="stable")[:3]:
            left, right = order[: at + 1], order[at + 1 :]
            few, many = (left, right) if parts[left].sum() < parts[right].sum() else (right, left)
            is_few = (
                parts[few].sum() <= _FEW * parts[here].sum()
                and lengths[few].sum() <= _SHORT * lengths[here].sum()
            )
            if is_few and gaps[at] > _extent(boxes[many]) > 0.0:
                far = nothing.copy()
                far[few] = True
                return far
    return nothing


def _lone(boxes: FloatArray, parts: FloatArray, kept: Mask) -> Mask:
    """Return the one straight line, if any, without which the plan is far shorter."""
    far: Mask = np.zeros(kept.shape, dtype=np.bool_)
    here = np.flatnonzero(kept)
    if here.size < 2:
        return far
    longest = here[int((boxes[here, 2:] - boxes[here, :2]).max(axis=1).argmax())]
    rest = here[here != longest]
    if (
        parts[longest] == 1.0
        and parts[rest].sum() > 2.0
        and _extent(boxes[here]) > _LONE * _extent(boxes[rest]) > 0.0
    ):
        far[longest] = True
    return far
