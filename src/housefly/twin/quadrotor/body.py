"""The AR.Drone 2.0 as a MuJoCo body: mass, hull, looks, cameras and reflective markers.

Mass: Douthwaite, ARdrone.m. Inertia and arm: paparazzi, simple_ardrone2.xml. Cameras: the
calibrations shipped with AutonomyLab/ardrone_autonomy. The body frame is forward, left, up with its
origin in the centre of mass.
"""

from __future__ import annotations

from itertools import pairwise
from math import atan, degrees, radians, tan

from housefly.config.airframe import Airframe, airframe_named
from housefly.config.capabilities import OnboardCamera
from housefly.config.drone import DroneConfig
from housefly.geometry import Vec2, Vec3, quaternion_from_euler
from housefly.twin.drone_mechanics import USUAL, Mechanics, mechanics_of

_AIRFRAME = airframe_named("ardrone")
DRONE_MASS = _AIRFRAME.body.mass
"""With indoor hull [kg]."""
INERTIA = USUAL.inertia
"""Principal moments [kg m^2]: a flat body with all mass at the motors' radius, an upper bound."""
MOTOR_ARM = USUAL.rotor_arm
"""Distance of each motor from the x and y axes [m]."""
_ROTOR_RADIUS = 0.1
STANDING_HEIGHT = _AIRFRAME.body.standing_height
"""Height of the origin above the floor when the drone stands on its belly [m]."""

BODY = "drone"
DRONE_MARKERS: tuple[Vec3, ...] = (
    (0.16, 0.02, 0.05),
    (0.05, 0.20, 0.04),
    (-0.17, 0.11, 0.04),
    (-0.10, -0.18, 0.04),
    (0.12, -0.15, 0.045),
    (-0.02, 0.0, 0.07),
)
"""Reflective markers on the hull [m]; all distances between them differ, so the pose is unique."""

_FRONT = _AIRFRAME.capabilities.camera
assert _FRONT is not None
FRONT_FIELD_OF_VIEW = _FRONT.field_of_view
_BOTTOM_FIELD_OF_VIEW = radians(49.0)
"""Horizontal field of view [rad]; pixels are square and the lenses have no distortion."""
PICTURE_SIZE = (_FRONT.width, _FRONT.height)
"""Width and height of both cameras' pictures [px]."""

VISUAL_GROUP = 2
HULL_GROUP = 3
"""MuJoCo geom groups; only the visual one is drawn (groups from 3 on are hidden by default)."""

_FOAM_RADIUS = 0.03
_CORNER_CUT = 0.12
_PLATE_HEIGHT = 0.02
_BELLY: Vec2 = (0.12, 0.05)
_DARK = "0.12 0.12 0.13 1"
_FOAM = "0.18 0.18 0.20 1"
_ORANGE = "0.95 0.45 0.10 1"
_BLADE = "0.75 0.78 0.82 0.35"


def drone_body(config: DroneConfig, home: Vec2, home_yaw: float, body: str = BODY) -> str:
    """Return the MJCF element of a drone standing on its pad.

    Args:
        config: gives the outer size of the hull [m].
        home: where it stands, world xy [m].
        home_yaw: where it faces [rad].
        body: its name in the model; the names of its parts begin with it.
    """
    orientation = quaternion_from_euler(0.0, 0.0, home_yaw)
    mechanics = mechanics_of(config.airframe)
    parts = [
        "<freejoint/>",
        f'<inertial pos="0 0 0" mass="{mechanics.mass}"'
        f' diaginertia="{_numbers(*mechanics.inertia)}"/>',
        *_hull(config, mechanics.standing_height, body),
        *(_looks() if config.airframe is _AIRFRAME else _plain_looks(config, mechanics)),
        *_cameras(config.airframe, body),
        *(
            f'<site name="{body}_marker_{n}" pos="{_numbers(*at)}" size="0.007" rgba="0.9 0.9 0.9'
            ' 1"/>'
            for n, at in enumerate(drone_markers(config.airframe))
        ),
    ]
    start = _numbers(home[0], home[1], mechanics.standing_height)
    return (
        f'<body name="{body}" pos="{start}" quat="{_numbers(*orientation)}">'
        + "".join(parts)
        + "</body>"
    )


def drone_markers(airframe: Airframe) -> tuple[Vec3, ...]:
    """Return where the reflective markers of a model sit [m]: as on an AR.Drone, for its size."""
    scale = airframe.body.hull_length / _AIRFRAME.body.hull_length
    return tuple((scale * x, scale * y, scale * z) for x, y, z in DRONE_MARKERS)


def _hull(config: DroneConfig, standing_height: float, body: str) -> list[str]:
    """Approximate the foam ring by eight capsules round a plate, and the belly by a box."""
    length, width = config.hull_length, config.hull_width
    half_height = min(config.airframe.body.hull_height / 2, standing_height)
    foam = min(_FOAM_RADIUS, length / 4, width / 4, half_height)
    x, y = length / 2 - foam, width / 2 - foam
    cut = min(_CORNER_CUT, 0.8 * x, 0.8 * y)
    corners = [
        (x, y - cut), (x - cut, y), (cut - x, y), (-x, y - cut),
        (-x, cut - y), (cut - x, -y), (x - cut, -y), (x, cut - y),
    ]  # fmt: skip
    plate_height = min(_PLATE_HEIGHT, half_height)
    solid = (
        f'group="{HULL_GROUP}" mass="0" friction="0.6 0.005 0.0001" solref="0.02 1" rgba="{_FOAM}"'
    )
    ring = [
        f'<geom name="{body}_hull_{n}" type="capsule" size="{foam}"'
        f' fromto="{_numbers(*a, 0.0, *b, 0.0)}" {solid}/>'
        for n, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1], strict=True))
    ]
    plate = (
        f'<geom name="{body}_plate" type="box" size="{_numbers(0.75 * x, 0.75 * y, plate_height)}"'
        f" {solid}/>"
    )
    belly = (
        f'<geom name="{body}_belly" type="box"'
        f' size="{_numbers(min(_BELLY[0], x), min(_BELLY[1], y), standing_height)}" {solid}/>'
    )
    return [*ring, plate, belly]


def _looks() -> list[str]:
    """Draw four rotors in foam arcs, a dark body and an orange tail.

    The front camera's view stays free.
    """
    shapes = [
        _shape("ellipsoid", (-0.02, 0.0, 0.01), (0.15, 0.055, 0.045), _DARK),
        _shape("box", (-0.13, 0.0, 0.02), (0.05, 0.035, 0.03), _ORANGE),
        _rod((0.1, 0.0, 0.0), (0.18, 0.0, 0.0), 0.022, _DARK),
    ]
    for sx in (1, -1):
        for sy in (1, -1):
            centre = (sx * MOTOR_ARM, sy * MOTOR_ARM, 0.03)
            shapes.append(_shape("cylinder", centre, (_ROTOR_RADIUS, 0.002), _BLADE))
            shapes.append(_shape("cylinder", (centre[0], centre[1], 0.012), (0.014, 0.02), _DARK))
            shapes.append(_rod((0.0, 0.0, 0.0), (centre[0], centre[1], 0.0), 0.008, _DARK))
            shapes.extend(_foam_arc(sx, sy))
    return shapes


def _plain_looks(config: DroneConfig, mechanics: Mechanics) -> list[str]:
    """Draw a board and four rotors on arms, as large as the drone is."""
    arm, thin = mechanics.rotor_arm, 0.1 * config.hull_height
    radius = max(0.25 * (config.hull_length + config.hull_width) - arm, 0.3 * arm)
    board = (0.6 * arm, 0.4 * arm, 2.0 * thin)
    shapes = [_shape("box", (0.0, 0.0, 0.0), board, _DARK)]
    for sx in (1, -1):
        for sy in (1, -1):
            colour = _ORANGE if sx < 0 else _BLADE
            end = (sx * arm, sy * arm, 2.0 * thin)
            shapes.append(_rod((0.0, 0.0, 0.0), end, thin, _DARK))
            shapes.append(_shape("cylinder", end, (radius, 0.2 * thin), colour))
    return shapes


def _foam_arc(sx: int, sy: int) -> list[str]:
    """Return the quarter of the foam ring that shields one rotor from outside."""
    radius, thickness = _ROTOR_RADIUS + 0.004, 0.012
    points = [
        (sx * (MOTOR_ARM + radius * dx), sy * (MOTOR_ARM + radius * dy))
        for dx, dy in ((-0.5, 0.87), (0.0, 1.0), (0.5, 0.87), (0.87, 0.5), (1.0, 0.0), (0.87, -0.5))
    ]
    return [_rod((*a, 0.02), (*b, 0.02), thickness, _FOAM) for a, b in pairwise(points)]


_VISUAL = f'contype="0" conaffinity="0" mass="0" group="{VISUAL_GROUP}"'


def _shape(kind: str, at: Vec3, size: tuple[float, ...], colour: str) -> str:
    return (
        f'<geom type="{kind}" pos="{_numbers(*at)}" size="{_numbers(*size)}" rgba="{colour}"'
        f" {_VISUAL}/>"
    )


def _rod(start: Vec3, end: Vec3, radius: float, colour: str) -> str:
    return (
        f'<geom type="capsule" size="{radius}" fromto="{_numbers(*start, *end)}" rgba="{colour}"'
        f" {_VISUAL}/>"
    )


def camera_name(camera: str, body: str = BODY) -> str:
    """Return what one of a drone's cameras is called in the model."""
    return camera if body == BODY else f"{body} {camera}"


def camera_of(airframe: Airframe) -> OnboardCamera:
    """Return the front camera of a model; one that has none is given an AR.Drone's."""
    assert _FRONT is not None
    return airframe.capabilities.camera or _FRONT


def _cameras(airframe: Airframe, body: str) -> list[str]:
    front, bottom = camera_name("front", body), camera_name("bottom", body)
    camera, below = camera_of(airframe), airframe.body.standing_height
    return [
        (
            f'<camera name="{front}" pos="{camera.ahead} 0 0" xyaxes="0 -1 0 0 0 1"'
            f' fovy="{_vertical_degrees(camera, camera.field_of_view):.6g}"/>'
        ),
        (
            f'<camera name="{bottom}" pos="0 0 -{below}" xyaxes="0 -1 0 1 0 0"'
            f' fovy="{_vertical_degrees(camera, _BOTTOM_FIELD_OF_VIEW):.6g}"/>'
        ),
    ]


def _vertical_degrees(camera: OnboardCamera, horizontal: float) -> float:
    return degrees(2 * atan(tan(horizontal / 2) * camera.height / camera.width))


def _numbers(*values: float) -> str:
    return " ".join(f"{value:.9g}" for value in values)
