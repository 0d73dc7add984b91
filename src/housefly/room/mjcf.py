"""A room as MuJoCo's model text: the same solids that the grid is computed from, with materials, lights and the visitor.

No file besides the text is needed: all textures are made by MuJoCo's own builders.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin
from xml.sax.saxutils import quoteattr

from housefly.room.model import Room, Shape, Solid
from housefly.room.visitor import visitor_body

# Attributes of <texture> (cube maps: MuJoCo lays them on every face), and of the <material> of the same name.
TEXTURES = {
    "wood": 'builtin="gradient" rgb1="1 1 1" rgb2="0.82 0.79 0.76" mark="random" markrgb="0.72 0.68 0.64" random="0.06"',
    "fabric": 'builtin="checker" rgb1="1 1 1" rgb2="0.90 0.90 0.90" mark="random" markrgb="0.80 0.80 0.80" random="0.15"',
    "rug": 'builtin="checker" rgb1="1 1 1" rgb2="0.84 0.82 0.80" mark="random" markrgb="0.70 0.66 0.62" random="0.20"',
    "wall": 'builtin="flat" rgb1="1 1 1" mark="random" markrgb="0.94 0.94 0.93" random="0.04"',
    "tiles": 'builtin="flat" rgb1="1 1 1" mark="edge" markrgb="0.70 0.72 0.74"',
    "leaves": 'builtin="checker" rgb1="1 1 1" rgb2="0.72 0.80 0.70" mark="random" markrgb="0.55 0.70 0.50" random="0.30"',
    "painting": 'builtin="gradient" rgb1="0.30 0.52 0.66" rgb2="0.95 0.78 0.52" mark="cross" markrgb="0.86 0.42 0.30"',
}
MATERIALS = {
    "wood": 'texture="wood" texuniform="true" texrepeat="2 2" specular="0.25" shininess="0.3"',
    "fabric": 'texture="fabric" texuniform="true" texrepeat="3 3" specular="0.02" shininess="0.02"',
    "rug": 'texture="rug" texuniform="true" texrepeat="3 3" specular="0" shininess="0"',
    "wall": 'texture="wall" texuniform="true" texrepeat="1 1" specular="0.05" shininess="0.1"',
    "tiles": 'texture="tiles" texuniform="true" texrepeat="6 6" specular="0.4" shininess="0.6"',
    "leaves": 'texture="leaves" texuniform="true" texrepeat="3 3" specular="0" shininess="0"',
    "painting": 'texture="painting" specular="0.1" shininess="0.1"',
    "daylight": 'emission="0.75" specular="0.6" shininess="0.9"',
    "screen": 'emission="0.35" specular="0.8" shininess="0.9"',
    "plain": 'specular="0.15" shininess="0.2"',
    "cloth": 'specular="0.05" shininess="0.1"',
}
FLOOR = (
    '<texture name="floor" type="2d" builtin="checker" width="256" height="256" rgb1="0.70 0.52 0.35" rgb2="0.63 0.46 0.30" '
    'mark="random" markrgb="0.55 0.40 0.26" random="0.03"/>\n'
    '<material name="floor" texture="floor" texuniform="true" texrepeat="0.8 3.2" specular="0.2" shininess="0.4" reflectance="0"/>'
)
VISUAL = (
    '<visual><headlight ambient="0.34 0.34 0.35" diffuse="0.22 0.22 0.22" specular="0.05 0.05 0.05"/>'
    '<map znear="0.005" zfar="12" haze="0"/><quality shadowsize="2048" offsamples="0"/>'
    '<global offwidth="1920" offheight="1080"/></visual>'
)
LAMP_SPACING = 5.0
"""Longest distance between two ceiling lamps along x [m]; the renderer takes eight lights at most."""


def room_to_mjcf(room: Room, *, bodies: str = "", assets: str = "", options: str = "") -> str:
    """Return the MJCF text of a room; raises nothing, imports nothing.

    Geoms carry the names of the solids; solids that do not collide get no contacts. The visitor, if the room has a place for one,
    is the mocap body "visitor". The ceiling, the lamps and the light are in geom group 1, so that a view from above can hide them.

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
            VISUAL,
            options,
            "<asset>",
            *_assets(),
            assets,
            "</asset>",
            "<worldbody>",
            *_surroundings(room),
            *(_geom(solid) for solid in room.solids),
            visitor_body(room.visitor, room.visitor_yaw) if room.visitor else "",
            bodies,
            "</worldbody>",
            "</mujoco>",
            "",
        )
    )


def _assets() -> Iterator[str]:
    yield '<texture type="skybox" builtin="gradient" rgb1="0.80 0.88 0.95" rgb2="0.93 0.94 0.95" width="64" height="384"/>'
    for name, attributes in TEXTURES.items():
        yield f'<texture name="{name}" type="cube" width="128" height="128" {attributes}/>'
    for name, attributes in MATERIALS.items():
        yield f'<material name="{name}" {attributes}/>'
    yield FLOOR


def _surroundings(room: Room) -> Iterator[str]:
    x_min, y_min, x_max, y_max = room.bounds
    x, y = (x_min + x_max) / 2, (y_min + y_max) / 2
    length, width = (x_max - x_min) / 2, (y_max - y_min) / 2
    yield f'<geom name="floor" type="plane" pos="{x:.6g} {y:.6g} 0" size="{length:.6g} {width:.6g} 1" material="floor"/>'
    yield (
        f'<geom name="ceiling" type="plane" pos="{x:.6g} {y:.6g} {room.height:.6g}" size="{length:.6g} {width:.6g} 1" '
        'quat="0 1 0 0" rgba="0.95 0.95 0.94 1" contype="0" conaffinity="0" group="1"/>'
    )
    yield (
        f'<light name="daylight" directional="true" castshadow="false" pos="{x_max:.6g} {y:.6g} {room.height:.6g}" '
        'dir="-0.75 0.25 -0.6" ambient="0 0 0" diffuse="0.34 0.34 0.36" specular="0.05 0.05 0.05"/>'
    )
    count = min(4, max(1, round(2 * length / LAMP_SPACING)))
    for n in range(count):
        at = x_min + (n + 0.5) * 2 * length / count
        yield (
            f'<light name="lamp {n}" castshadow="false" pos="{at:.6g} {y:.6g} {room.height - 0.1:.6g}" dir="0 0 -1" cutoff="88" '
            'exponent="1" attenuation="1 0 0.03" ambient="0.05 0.05 0.05" diffuse="0.36 0.35 0.33" specular="0.08 0.08 0.08"/>'
        )


def _geom(solid: Solid) -> str:
    x, y, z = solid.position
    a, b, c = (extent / 2 for extent in solid.size)
    size = f"{a:.6g} {b:.6g} {c:.6g}" if solid.shape is Shape.BOX else f"{a:.6g} {c:.6g}"
    turn = f' quat="{cos(solid.yaw / 2):.9g} 0 0 {sin(solid.yaw / 2):.9g}"' if solid.yaw else ""
    colour = " ".join(f"{part:.4g}" for part in solid.colour)
    material = solid.texture if solid.texture in MATERIALS else "plain"
    contact = "" if solid.collides else ' contype="0" conaffinity="0"'
    return (
        f'<geom name={quoteattr(solid.name)} type="{solid.shape.value}" pos="{x:.6g} {y:.6g} {z:.6g}" size="{size}"{turn} '
        f'rgba="{colour}" material="{material}"{contact}/>'
    )
