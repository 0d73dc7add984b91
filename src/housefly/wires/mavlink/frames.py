"""The one place where MAVLink's axes are converted to ours and back.

Ours: the world's z is up, and on a ground station's map its x is drawn as east and its y as north,
as the console draws them; a body is forward, left, up. MAVLink's: north, east, down, and forward,
right, down. Each way back is the same function.
"""

from __future__ import annotations

from math import pi, sqrt

from housefly.geometry import Quaternion, Vec3, wrap_angle

_HALF = sqrt(0.5)


def across_world(vector: Vec3) -> Vec3:
    """Return a vector of our world in north, east, down; and back."""
    x, y, z = vector
    return y, x, -z


def across_body(vector: Vec3) -> Vec3:
    """Return a vector of a forward, left, up body in forward, right, down; and back."""
    x, y, z = vector
    return x, -y, -z


def across_orientation(orientation: Quaternion) -> Quaternion:
    """Return what turns FLU into our world as what turns FRD into NED (w, x, y, z); and back."""
    w, x, y, z = orientation
    return _HALF * (w + z), _HALF * (x + y), _HALF * (x - y), _HALF * (w - z)


def across_heading(heading: float) -> float:
    """Return a heading, counter-clockwise from x, as clockwise from north [rad]; and back."""
    return wrap_angle(0.5 * pi - heading)


def across_attitude(attitude: Vec3) -> Vec3:
    """Return roll, pitch and heading of a FLU body in our world as of FRD in NED [rad]; and back.

    Our pitch is positive nose down, MAVLink's nose up; right side down is a positive roll in both.
    """
    roll, pitch, heading = attitude
    return roll, -pitch, across_heading(heading)
