"""The visitor at the door as a MuJoCo body: a person in a coat with a bag, tracked by six markers.

Own frame: origin on the floor between the feet, x to where the person faces, y left, z up. Metres.
"""

from __future__ import annotations

from math import cos, sin

from housefly.geometry import Vec2

_NAME = "visitor"

_SKIN, _HAIR, _COAT, _TROUSERS = (
    "0.93 0.74 0.62 1",
    "0.20 0.13 0.10 1",
    "0.75 0.23 0.20 1",
    "0.18 0.21 0.30 1",
)
_SHOE, _SCARF, _BAG, _DARK, _WHITE = (
    "0.14 0.12 0.12 1",
    "0.93 0.80 0.45 1",
    "0.55 0.38 0.22 1",
    "0.10 0.09 0.10 1",
    "0.97 0.97 0.96 1",
)
_SLEEVE, _LIPS = "0.70 0.20 0.18 1", "0.72 0.32 0.30 1"

# Kind, numbers as MuJoCo takes them (fromto for capsules, pos and half sizes for the rest), colour.
_CAPSULES: tuple[tuple[str, str, str], ...] = (
    ("0 0.09 0.12 0 0.10 0.82", "0.072", _TROUSERS),
    ("0 -0.09 0.12 0 -0.10 0.82", "0.072", _TROUSERS),
    ("-0.03 0.09 0.045 0.13 0.11 0.045", "0.045", _SHOE),
    ("-0.03 -0.09 0.045 0.13 -0.11 0.045", "0.045", _SHOE),
    ("0 -0.10 1.36 0 0.10 1.36", "0.092", _COAT),
    ("0 0.205 1.38 0.01 0.265 1.12", "0.056", _SLEEVE),
    ("0.01 0.265 1.12 0.07 0.275 0.90", "0.048", _SLEEVE),
    ("0 -0.205 1.38 0.02 -0.330 1.17", "0.056", _SLEEVE),
    ("0.02 -0.330 1.17 0.10 -0.395 1.38", "0.046", _SLEEVE),
    ("0.10 -0.395 1.38 0.11 -0.400 1.42", "0.026", _SKIN),
    ("0.125 -0.372 1.46 0.125 -0.352 1.56", "0.010", _SKIN),
    ("0.125 -0.395 1.47 0.125 -0.385 1.58", "0.010", _SKIN),
    ("0.125 -0.417 1.47 0.125 -0.418 1.57", "0.010", _SKIN),
    ("0.125 -0.437 1.46 0.125 -0.450 1.54", "0.009", _SKIN),
    ("0.125 -0.375 1.44 0.130 -0.335 1.49", "0.011", _SKIN),
    ("0.005 -0.085 0.80 0.005 0.085 0.80", "0.118", _COAT),
    ("0.003 -0.080 0.95 0.003 0.080 0.95", "0.112", _COAT),
    ("0 0 1.42 0.005 0 1.53", "0.055", _SKIN),
    ("0.12 0.075 1.30 -0.12 0.19 0.96", "0.012", _BAG),
)
_ELLIPSOIDS: tuple[tuple[str, str, str], ...] = (
    ("0.0 0 1.20", "0.125 0.205 0.27", _COAT),
    ("0.0 0 0.92", "0.132 0.192 0.25", _COAT),
    ("0 0 1.445", "0.095 0.105 0.050", _SCARF),
    ("0.075 0.045 1.33", "0.040 0.040 0.115", _SCARF),
    ("0.01 0 1.625", "0.098 0.080 0.120", _SKIN),
    ("-0.022 0 1.665", "0.105 0.092 0.105", _HAIR),
    ("-0.065 0 1.575", "0.055 0.088 0.120", _HAIR),
    ("0.090 0.030 1.640", "0.016 0.016 0.011", _WHITE),
    ("0.090 -0.030 1.640", "0.016 0.016 0.011", _WHITE),
    ("0.103 0.030 1.640", "0.005 0.008 0.009", _DARK),
    ("0.103 -0.030 1.640", "0.005 0.008 0.009", _DARK),
    ("0.110 0 1.612", "0.014 0.012 0.020", _SKIN),
    ("0.099 0 1.572", "0.008 0.024 0.006", _LIPS),
    ("0.010 0.083 1.622", "0.018 0.010 0.026", _SKIN),
    ("0.010 -0.083 1.622", "0.018 0.010 0.026", _SKIN),
    ("0.097 0.030 1.664", "0.010 0.018 0.004", _HAIR),
    ("0.097 -0.030 1.664", "0.010 0.018 0.004", _HAIR),
    ("0.095 0.278 0.835", "0.040 0.032 0.058", _SKIN),
    ("0.120 -0.402 1.445", "0.018 0.046 0.050", _SKIN),
)
_BOXES: tuple[tuple[str, str, str], ...] = (
    ("0.124 0 1.14", "0.004 0.010 0.20", _DARK),
    ("0.130 0 0.90", "0.005 0.009 0.16", _DARK),
    ("0.112 0.075 1.02", "0.030 0.045 0.006", _DARK),
    ("0.112 -0.085 1.02", "0.030 0.045 0.006", _DARK),
    ("-0.02 0.33 0.70", "0.15 0.055 0.115", _BAG),
    ("-0.02 0.388 0.735", "0.13 0.006 0.060", "0.63 0.45 0.27 1"),
)
_MARKERS = (
    (0.0, 0.0, 1.778),
    (0.03, 0.205, 1.475),
    (0.03, -0.205, 1.475),
    (-0.13, 0.0, 1.40),
    (0.14, 0.05, 1.16),
    (0.14, -0.09, 0.95),
)


def visitor_body(feet: Vec2, yaw: float) -> str:
    """Return the MJCF of the visitor: mocap body "visitor", sites "visitor_marker_0" to "_5".

    Args:
        feet: where the visitor stands [m].
        yaw: where the visitor faces [rad].
    """
    lines = [
        f'<body name="{_NAME}" mocap="true" pos="{feet[0]} {feet[1]} 0"'
        f' quat="{cos(yaw / 2):.9g} 0 0 {sin(yaw / 2):.9g}">'
    ]
    shapes = (
        *(
            f'type="capsule" fromto="{line}" size="{radius}" rgba="{rgba}"'
            for line, radius, rgba in _CAPSULES
        ),
        *(
            f'type="ellipsoid" pos="{at}" size="{size}" rgba="{rgba}"'
            for at, size, rgba in _ELLIPSOIDS
        ),
        *(f'type="box" pos="{at}" size="{size}" rgba="{rgba}"' for at, size, rgba in _BOXES),
    )
    lines += [
        f'  <geom name="{_NAME} {n}" {shape} material="cloth"/>' for n, shape in enumerate(shapes)
    ]
    lines += [
        f'  <site name="{_NAME}_marker_{n}" pos="{x} {y} {z}" size="0.007" rgba="0.9 0.9 0.9 1"'
        ' group="4"/>'
        for n, (x, y, z) in enumerate(_MARKERS)
    ]
    return "\n".join([*lines, "</body>"])
