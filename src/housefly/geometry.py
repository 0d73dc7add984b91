"""Angles, quaternions and vectors as plain tuples.

Frames: world is x along the room's long wall, y left, z up; body is forward, left, up (REP-103).
Quaternions are (w, x, y, z) and rotate body vectors into the world. Angles are in radians.
"""

from __future__ import annotations

from math import asin, atan2, copysign, cos, hypot, pi, remainder, sin, sqrt

Vec2 = tuple[float, float]
Vec3 = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

IDENTITY: Quaternion = (1.0, 0.0, 0.0, 0.0)
GRAVITY = 9.80665
"""Standard gravity [m/s^2]."""


def wrap_angle(angle: float) -> float:
    """Return the same angle in (-pi, pi]."""
    wrapped = remainder(angle, 2.0 * pi)
    return pi if wrapped <= -pi else wrapped


def quaternion_from_euler(phi: float, theta: float, psi: float) -> Quaternion:
    """Return the rotation Rz(psi) Ry(theta) Rx(phi) of paper eq. (3), angles in radians."""
    cr, sr = cos(phi / 2), sin(phi / 2)
    cp, sp = cos(theta / 2), sin(theta / 2)
    cy, sy = cos(psi / 2), sin(psi / 2)
    return (
        cy * cp * cr + sy * sp * sr,
        cy * cp * sr - sy * sp * cr,
        cy * sp * cr + sy * cp * sr,
        sy * cp * cr - cy * sp * sr,
    )


def euler_from_quaternion(q: Quaternion) -> Vec3:
    """Return roll phi, pitch theta and yaw psi [rad] of a unit quaternion."""
    w, x, y, z = q
    phi = atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    sine = 2 * (w * y - z * x)
    theta = copysign(pi / 2, sine) if abs(sine) >= 1 else asin(sine)
    return phi, theta, yaw_of(q)


def yaw_of(q: Quaternion) -> float:
    """Return the heading psi [rad] of a quaternion."""
    w, x, y, z = q
    return atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def normalized(q: Quaternion) -> Quaternion:
    """Return the unit quaternion along q; raises ZeroDivisionError for the zero quaternion."""
    w, x, y, z = q
    norm = sqrt(w * w + x * x + y * y + z * z)
    return w / norm, x / norm, y / norm, z / norm


def quaternion_product(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the rotation that turns by b first and then by a."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def rotate(q: Quaternion, v: Vec3) -> Vec3:
    """Return the body vector v expressed in the world."""
    w, x, y, z = q
    vx, vy, vz = v
    tx, ty, tz = 2 * (y * vz - z * vy), 2 * (z * vx - x * vz), 2 * (x * vy - y * vx)
    return (
        vx + w * tx + y * tz - z * ty,
        vy + w * ty + z * tx - x * tz,
        vz + w * tz + x * ty - y * tx,
    )


def distance(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    """Return the Euclidean distance of two points of the same dimension."""
    return hypot(*(p - q for p, q in zip(a, b, strict=True)))


def heading_to(start: tuple[float, ...], target: tuple[float, ...]) -> float:
    """Return the yaw [rad] that looks from start to target in the xy plane."""
    return atan2(target[1] - start[1], target[0] - start[0])


def stopping_distance(speed: float, deceleration: float, latency: float) -> float:
    """Return the distance [m] travelled before standing still: v^2 / 2a + v * latency."""
    return speed * speed / (2.0 * deceleration) + speed * latency
