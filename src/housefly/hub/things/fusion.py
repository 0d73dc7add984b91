"""Inverse-variance fusion of several measured positions of one thing."""

from __future__ import annotations

from collections.abc import Sequence

from housefly.geometry import Vec3
from housefly.messages import Covariance

_Measured = tuple[Vec3, Covariance]


def inverse(matrix: Covariance) -> Covariance | None:
    """Return the inverse of a symmetric matrix (upper triangle); None unless positive definite."""
    xx, xy, xz, yy, yz, zz = matrix
    a, b, c = yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy
    determinant = xx * a + xy * b + xz * c
    if not (xx > 0.0 and xx * yy - xy * xy > 0.0 and 0.0 < determinant < float("inf")):
        return None
    d, e, f = xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy
    return (
        a / determinant,
        b / determinant,
        c / determinant,
        d / determinant,
        e / determinant,
        f / determinant,
    )


def inflated(matrix: Covariance, variance: float) -> Covariance:
    """Return the covariance with a variance [m^2] added to each axis."""
    xx, xy, xz, yy, yz, zz = matrix
    return xx + variance, xy, xz, yy + variance, yz, zz + variance


def fused_position(measured: Sequence[_Measured]) -> _Measured | None:
    """Return the best linear estimate and its covariance; None if no covariance is invertible.

    The estimate is (sum P_i^-1)^-1 sum P_i^-1 p_i.
    """
    total: list[float] = [0.0] * 6
    sum_x = sum_y = sum_z = 0.0
    for (x, y, z), covariance in measured:
        weight = inverse(covariance)
        if weight is None:
            continue
        total = [sum_ + part for sum_, part in zip(total, weight, strict=True)]
        wx, wy, wz = _times(weight, (x, y, z))
        sum_x, sum_y, sum_z = sum_x + wx, sum_y + wy, sum_z + wz
    joint = inverse((total[0], total[1], total[2], total[3], total[4], total[5]))
    return None if joint is None else (_times(joint, (sum_x, sum_y, sum_z)), joint)


def _times(matrix: Covariance, vector: Vec3) -> Vec3:
    xx, xy, xz, yy, yz, zz = matrix
    x, y, z = vector
    return xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z
