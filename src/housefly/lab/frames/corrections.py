"""What to do about a finding: lines of the site file where it can, words where it cannot."""

from __future__ import annotations

from math import cos, degrees, hypot, pi, radians, sin

from housefly.config.tracking import TrackingConfig
from housefly.geometry import Vec2, Vec3
from housefly.lab.frames.findings import FrameFault, FrameFinding
from housefly.numeric import wrapped

_RIGHT_ANGLE = radians(7.0)
"""An angle so near to a multiple of 90 degrees is one: no person lays a drone better [rad]."""
_UNITS = (
    (1000.0, "millimetres"),
    (100.0, "centimetres"),
    (39.37, "inches"),
    (3.281, "feet"),
    (0.001, "kilometres"),
)
_LATENCY_MAX = 0.5
"""Longest ``tracking.latency`` [s]."""


def snapped(angle: float) -> float:
    """Return an angle, or the multiple of 90 degrees that it must be [rad]."""
    right = round(angle / (pi / 2)) * pi / 2
    return right if right != 0.0 and abs(angle - right) < _RIGHT_ANGLE else angle


def corrected_keys(
    tracking: TrackingConfig, pad: Vec3, home: Vec2 | None, turn: float, nose: float, rise: float
) -> dict[str, float | str]:
    """Return the keys of [tracking] that take errors away.

    Args:
        tracking: as configured.
        pad: where the drone on its pad is seen [m].
        home: where the pad is on the map [m]; None leaves the origin.
        turn: of the frame against the map [rad]; 0 leaves it.
        nose: of the body against the drone [rad]; 0 leaves it.
        rise: of the drone above where it stands [m]; 0 leaves it.
    """
    keys: dict[str, float | str] = {}
    if turn != 0.0:
        keys["yaw"] = _rounded(tracking.yaw - turn)
    if home is not None:
        c, s = cos(turn), sin(turn)
        x, y = pad[0] - tracking.x, pad[1] - tracking.y
        keys["x"] = round(home[0] - (c * x + s * y), 3) + 0.0
        keys["y"] = round(home[1] - (c * y - s * x), 3) + 0.0
    if rise != 0.0:
        keys["z"] = round(tracking.z - rise, 3)
    if nose != 0.0:
        keys["body_yaw"] = _rounded(tracking.body_yaw - nose)
    return keys


def lines_words(keys: dict[str, float | str], *names: str) -> str:
    """Return keys of a site file as people write them."""
    lines = ", ".join(f"{name} = {keys[name]}" for name in names if name in keys)
    return f"in the site file: [tracking] {lines}"


def up_axis_finding(lift: Vec3, tracking: TrackingConfig) -> FrameFinding:
    """Return the finding of a lift that is not seen as one [m]."""
    x, y, z = lift
    if abs(z) > hypot(x, y):
        return FrameFinding(
            FrameFault.UP_AXIS,
            f"Lifted, it is seen to sink by {-z:.2f} m: the axis that should point up points down",
            "turn the tracking system's axes: z (or y, where y is up) must point up",
        )
    words = f"Lifted, it is seen to move level by {hypot(x, y):.2f} m: another axis points up"
    c, s = cos(tracking.yaw), sin(tracking.yaw)
    across, along = c * x + s * y, c * y - s * x
    wanted = "z" if tracking.y_up else "y"
    is_other_axis = (along < 0.0) is tracking.y_up and abs(along) > 2.0 * abs(across)
    if is_other_axis and tracking.kind != "vicon":
        return FrameFinding(
            FrameFault.UP_AXIS, words, f'in the site file: [tracking] up_axis = "{wanted}"'
        )
    return FrameFinding(
        FrameFault.UP_AXIS,
        words,
        "let the tracking system stream with z up (Vicon Tracker: z up; Motive: up axis z), and set"
        " its origin on the level floor",
    )


def mirrored_words(twice: float, headings_too: bool) -> tuple[str, str]:
    """Return what is mirrored, and the mend.

    Args:
        twice: twice the angle of the line on the map that is its own mirror image [rad].
        headings_too: whether headings are mirrored with the places.
    """
    named = {
        0: "y runs the wrong way",
        90: "x and y are exchanged",
        180: "x runs the wrong way",
        270: "x and y are exchanged, and both run the wrong way",
    }
    nearest = round(degrees(twice) / 90.0) * 90 % 360
    is_named = abs(wrapped(twice - radians(nearest))) < radians(20.0)
    line = f"about a line at {degrees(twice) / 2 % 180:.0f} deg on the map"
    how = named[nearest] if is_named else line
    if headings_too:
        return (
            f"Places and headings are mirrored: {how}",
            "no site file mends that: choose right-handed axes in the tracking system, or mirror"
            " the map, whichever does not show the room as it is",
        )
    return (
        f"Places are mirrored, headings are not: {how}",
        "no site file mends that: one axis has the wrong sign, or two are exchanged, in the"
        " tracking system's streaming settings or in what converts them",
    )


def scale_mend(scale: float) -> str:
    """Return the mend of ways that are seen so many times as long as they are."""
    for factor, name in _UNITS:
        if 0.8 < scale / factor < 1.25:
            return f"the tracking system streams {name}; let it stream metres"
    return (
        "calibrate the cameras with the wand whose length the tracking system is told, or measure"
        " the way again"
    )


def late_mend(lag: float, tracking: TrackingConfig, mended: dict[str, float | str]) -> str:
    """Return the mend of tracking that is late [s], and note the key where a site file mends it."""
    cause = "look for what delays it: smoothing, filters, Wi-Fi between it and this computer"
    latency = round(tracking.latency + lag, 2)
    if tracking.kind in ("vrpn", "bridge") and latency <= _LATENCY_MAX:
        mended["latency"] = latency
        return f"{cause}. If it must be so late, {lines_words(mended, 'latency')}"
    return f"{cause}. No site file mends that: this system stamps its own frames"


def _rounded(angle: float) -> float:
    """Return an angle in few digits that a site file takes [rad]."""
    return max(-3.1415, min(3.1415, round(wrapped(angle), 4)))
