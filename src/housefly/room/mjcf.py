"""A room as MuJoCo's MJCF: the solids of the grid, with materials, lights and the visitor.

No other file is needed: all textures are made by MuJoCo's own builders.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin
from xml.sax.saxutils import quoteattr

from housefly.geometry import Vec2
from housefly.room.model import BUILDING_PARTS, Room, Shape, Solid

# Flat maps: MuJoCo lays them on a geom's local x and y, so that its sides carry them as stripes
# along z (grain, wallpaper).
_TEXTURES = {
    "wood": 'builtin="flat" rgb1="1 1 1" mark="random" markrgb="0.84 0.80 0.76" random="0.25"',
    "fabric": (
        'builtin="checker" rgb1="1 1 1" rgb2="0.93 0.93 0.93" mark="random" markrgb="0.86 0.86'
        ' 0.86" random="0.15"'
    ),
    "rug": (
        'builtin="checker" rgb1="1 1 1" rgb2="0.88 0.86 0.84" mark="random" markrgb="0.78 0.74'
        ' 0.70" random="0.25"'
    ),
    "wall": 'builtin="flat" rgb1="1 1 1" mark="random" markrgb="0.98 0.98 0.975" random="0.3"',
    "tiles": 'builtin="flat" rgb1="1 1 1" mark="edge" markrgb="0.78 0.80 0.82"',
    "leaves": (
        'builtin="checker" rgb1="1 1 1" rgb2="0.72 0.80 0.70" mark="random" markrgb="0.55 0.70'
        ' 0.50" random="0.30"'
    ),
    "floor": (
        'builtin="checker" rgb1="0.74 0.57 0.40" rgb2="0.68 0.51 0.35" mark="random" markrgb="0.62'
        ' 0.46 0.31" random="0.05"'
    ),
}
_MATERIALS = {
    "wood": 'texture="wood" texuniform="true" texrepeat="1.2 1.2" specular="0.2" shininess="0.3"',
    "fabric": 'texture="fabric" texuniform="true" texrepeat="3 3" specular="0.02" shininess="0.02"',
    "rug": 'texture="rug" texuniform="true" texrepeat="4 4" specular="0" shininess="0"',
    "wall": 'texture="wall" texuniform="true" texrepeat="0.5 0.5" specular="0.02" shininess="0.1"',
    "tiles": 'texture="tiles" texuniform="true" texrepeat="7 7" specular="0.3" shininess="0.6"',
    "leaves": 'texture="leaves" texuniform="true" texrepeat="3 3" specular="0" shininess="0"',
    "floor": 'texture="floor" texuniform="true" texrepeat="1.1 4.4" specular="0.1" shininess="0.4"',
    "daylight": 'emission="0.5" specular="0.3" shininess="0.9"',
    "screen": 'emission="0.3" specular="0.6" shininess="0.9"',
    "ceiling": 'emission="0.42" specular="0" shininess="0"',
    "lamp": 'emission="1" specular="0" shininess="0"',
    "shade": 'specular="0" shininess="0"',
    "plain": 'specular="0.12" shininess="0.2"',
    "cloth": 'specular="0.05" shininess="0.1"',
}
_VISUAL = (
    '<visual><headlight ambient="0.58 0.58 0.58" diffuse="0.16 0.16 0.16" specular="0.05 0.05'
    ' 0.05"/><map znear="0.005" zfar="12" haze="0"/><quality shadowsize="2048"'
    ' offsamples="0"/><global offwidth="1920" offheight="1080"/></visual>'
)
# Two lights without shadows from opposite sides give every side of a box a brightness of its own.
_LIGHTS = (("daylight", "-0.62 0.30 -0.72", 0.30), ("fill", "0.50 -0.62 -0.60", 0.22))
_LAMP_SPACING = 3.0
"""Distance between ceiling lamps along x [m]."""
_SHADE_BELOW, _SHADE_MARGIN, _SHADE = 0.32, 0.05, 0.10
"""Solids lower than this [m] darken the floor around them, this far [m] and by this share."""

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


def room_to_mjcf(room: Room, *, bodies: str = "", assets: str = "", options: str = "") -> str:
    """Return the MJCF text of a room.

    Geoms carry the names of the solids; solids that do not collide get no contacts. The visitor, if
    the room has a place for one, is the mocap body "visitor". Ceiling, lamps and painted shadows
    are in geom group 1, so that a view from above can hide them.

    Args:
        room: what to model.
        bodies: MJCF to add to the world body (the drone).
        assets: MJCF to add to the assets.
        options: MJCF to add at the top level.
    """
    return "\n".join(
        (
            f"<mujoco model={quoteattr(room.name)}>",
            '<compiler angle="radian" autolimits="true"/>',
            '<statistic extent="8" meansize="0.1"/>',
            _VISUAL,
            options,
            "<asset>",
            *_assets(),
            assets,
            "</asset>",
            "<worldbody>",
            *_surroundings(room),
            *_shades(room.solids),
            *(geom(solid) for solid in room.solids),
            _visitor_body(room.visitor, room.visitor_yaw) if room.visitor else "",
            bodies,
            "</worldbody>",
            "</mujoco>",
            "",
        )
    )


def _assets() -> Iterator[str]:
    yield (
        '<texture type="skybox" builtin="gradient" rgb1="0.80 0.88 0.95" rgb2="0.93 0.94 0.95"'
        ' width="64" height="384"/>'
    )
    for name, attributes in _TEXTURES.items():
        yield f'<texture name="{name}" type="2d" width="128" height="128" {attributes}/>'
    for name, attributes in _MATERIALS.items():
        yield f'<material name="{name}" {attributes}/>'


def _surroundings(room: Room) -> Iterator[str]:
    x_min, y_min, x_max, y_max = room.bounds
    x, y = (x_min + x_max) / 2, (y_min + y_max) / 2
    length, width = (x_max - x_min) / 2, (y_max - y_min) / 2
    yield (
        f'<geom name="floor" type="plane" pos="{x:.9g} {y:.9g} 0" size="{length:.9g} {width:.9g} 1"'
        ' material="floor"/>'
    )
    yield (
        f'<geom name="ceiling" type="plane" pos="{x:.9g} {y:.9g} {room.height:.9g}"'
        f' size="{length:.9g} {width:.9g} 1" quat="0 1 0 0" rgba="0.95 0.95 0.94 1"'
        ' material="ceiling" contype="0" conaffinity="0" group="1"/>'
    )
    for name, direction, strength in _LIGHTS:
        yield (
            f'<light name="{name}" directional="true" castshadow="false" pos="{x:.9g} {y:.9g}'
            f' {room.height:.9g}" dir="{direction}" ambient="0 0 0" diffuse="{strength} {strength}'
            f' {strength}" specular="0.05 0.05 0.05"/>'
        )
    for n in range(count := max(1, round(2 * length / _LAMP_SPACING))):
        at = x_min + (n + 0.5) * 2 * length / count
        yield (
            f'<geom name="lamp {n}" type="cylinder" pos="{at:.9g} {y:.9g} {room.height - 0.03:.9g}"'
            ' size="0.2 0.025" rgba="1 0.98 0.92 1" material="lamp" contype="0" conaffinity="0"'
            ' group="1"/>'
        )


def _shades(solids: tuple[Solid, ...]) -> Iterator[str]:
    """Yield dark translucent patches on the floor under low things: cheap shadows."""
    for solid in solids:
        low = solid.position[2] - solid.size[2] / 2
        if (
            solid.collides
            and low < _SHADE_BELOW
            and solid.size[2] > 0.02
            and solid.thing not in BUILDING_PARTS
        ):
            x, y, _ = solid.position
            a, b = solid.size[0] / 2 + _SHADE_MARGIN, solid.size[1] / 2 + _SHADE_MARGIN
            size = f"{a:.9g} {b:.9g} 0.001" if solid.shape is Shape.BOX else f"{a:.9g} 0.001"
            yield (
                f'<geom type="{solid.shape.value}" pos="{x:.9g} {y:.9g} 0.002"'
                f' size="{size}"{_turn(solid.yaw)} rgba="0.1 0.06 0.03 {_SHADE}" material="shade"'
                ' contype="0" conaffinity="0" group="1"/>'
            )


def _turn(yaw: float) -> str:
    return f' quat="{cos(yaw / 2):.9g} 0 0 {sin(yaw / 2):.9g}"' if yaw else ""


def geom(solid: Solid) -> str:
    """Return the MJCF of a solid."""
    x, y, z = solid.position
    a, b, c = (extent / 2 for extent in solid.size)
    size = f"{a:.9g} {b:.9g} {c:.9g}" if solid.shape is Shape.BOX else f"{a:.9g} {c:.9g}"
    colour = " ".join(f"{part:.4g}" for part in solid.colour)
    material = solid.texture if solid.texture in _MATERIALS else "plain"
    contact = "" if solid.collides else ' contype="0" conaffinity="0"'
    return (
        f'<geom name={quoteattr(solid.name)} type="{solid.shape.value}" pos="{x:.9g} {y:.9g}'
        f' {z:.9g}" size="{size}"{_turn(solid.yaw)} rgba="{colour}"'
        f' material="{material}"{contact}/>'
    )


def _visitor_body(feet: Vec2, yaw: float) -> str:
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
