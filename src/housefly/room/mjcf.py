"""A room as MuJoCo's MJCF: the solids of the grid, with materials, lights and the visitor.

No other file is needed: all textures are made by MuJoCo's own builders.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin
from xml.sax.saxutils import quoteattr

from housefly.room.model import BUILDING_PARTS, Room, Shape, Solid
from housefly.room.visitor import visitor_body

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
            visitor_body(room.visitor, room.visitor_yaw) if room.visitor else "",
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
