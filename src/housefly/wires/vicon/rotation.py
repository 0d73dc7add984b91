"""Rotation matrices as Vicon sends them: nine numbers row by row, segment to world."""

from __future__ import annotations

from math import isfinite, sqrt

from housefly.errors import WireError
from housefly.geometry import Quaternion, normalized
from housefly.wires.vicon.frame import RotationMatrix

_ROTATION_TOLERANCE = 1e-3
"""How far a matrix may be from orthonormal, per element of R R^T - 1 and of the determinant."""


def matrix_from_quaternion(q: Quaternion) -> RotationMatrix:
    """Return the rotation matrix of a unit quaternion (w, x, y, z)."""
    w, x, y, z = q
    return (
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
    )  # fmt: skip


def quaternion_from_matrix(m: RotationMatrix) -> Quaternion:
    """Return the unit quaternion (w >= 0) of a rotation matrix (Shepperd 1978).

    Raises:
        WireError: a value is not finite, or the matrix is not a rotation.
    """
    if not all(isfinite(value) for value in m) or not _is_rotation(m):
        raise WireError("Vicon sent a matrix that is not a rotation")
    a, b, c, d, e, f, g, h, i = m
    squares = (1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i)
    largest = max(range(4), key=squares.__getitem__)
    four = 2 * sqrt(squares[largest])
    w, x, y, z = (
        (four / 4, (h - f) / four, (c - g) / four, (d - b) / four),
        ((h - f) / four, four / 4, (b + d) / four, (c + g) / four),
        ((c - g) / four, (b + d) / four, four / 4, (f + h) / four),
        ((d - b) / four, (c + g) / four, (f + h) / four, four / 4),
    )[largest]
    return normalized((w, x, y, z) if w >= 0 else (-w, -x, -y, -z))


def _is_rotation(m: RotationMatrix) -> bool:
    rows = (m[0:3], m[3:6], m[6:9])
    for i, row in enumerate(rows):
        for j in range(i, 3):
            dot = sum(p * q for p, q in zip(row, rows[j], strict=True))
            if abs(dot - (i == j)) > _ROTATION_TOLERANCE:
                return False
    a, b, c, d, e, f, g, h, k = m
    return (
        abs(a * (e * k - f * h) - b * (d * k - f * g) + c * (d * h - e * g) - 1)
        <= 3 * _ROTATION_TOLERANCE
    )
