"""Motive's own axes have y up; ours have z up."""

from __future__ import annotations

from housefly.geometry import Quaternion, Vec3


def z_up_position(position: Vec3) -> Vec3:
    """Return a y-up position with z up: x stays, as when Motive streams z up."""
    x, y, z = position
    return x, -z, y


def z_up_orientation(orientation: Quaternion) -> Quaternion:
    """Return a y-up orientation (w, x, y, z) with z up, for the world's axes and the body's."""
    w, x, y, z = orientation
    return w, x, -z, y


def y_up_position(position: Vec3) -> Vec3:
    """Return a z-up position with y up."""
    x, y, z = position
    return x, z, -y


def y_up_orientation(orientation: Quaternion) -> Quaternion:
    """Return a z-up orientation (w, x, y, z) with y up."""
    w, x, y, z = orientation
    return w, x, z, -y
