"""What the paper claims in sections II to IV: sensors, platform, map and planner."""

from __future__ import annotations

import numpy as np

from housefly.lab.experiments.intervals import share
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.ruling import Claim, Ruling, percent, percents, untestable
from housefly.lab.reproduction.tracking_judges import judge_immediate, judge_low_rate

_LONGER_FACTOR = 1.02
"""A path this much longer than another is longer, not rounded."""
_SAFE_SHARE = 0.95
"""A distance is safe when this share of flights keeps it."""
_IMMEDIATE_FACTOR = 1.5
"""A command controls the speed when speed lags at most this many times as much as the angle."""


def _speeds(evidence: Evidence) -> Ruling:
    """Rule on "u_x and u_y control the horizontal speeds": does speed follow as the angle does?"""
    angle, speed = evidence.equations.angle_rise, evidence.equations.speed_rise
    text = (
        f"Under a steady command the angle has reached 63 % of its last value after {angle:.2f} s,"
        f" the speed after {speed:.2f} s."
    )
    verdict = Verdict.HOLDS if speed <= _IMMEDIATE_FACTOR * angle else Verdict.FAILS
    return Ruling(
        verdict,
        text
        + (
            ""
            if verdict is Verdict.HOLDS
            else " They are shares of angles, as the paper says later."
        ),
    )


def _plane(evidence: Evidence) -> Ruling:
    """Rule on "only the xy plane is considered": are cells free at every height?"""
    at_height, everywhere = evidence.maps.free, evidence.maps.free_at_every_height
    lost = 1.0 - everywhere / at_height
    text = (
        f"{percent(lost)} of the {at_height} cells that are free at the flight height are blocked"
        " at another height."
    )
    if everywhere == at_height:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(Verdict.CONDITION, "As long as the drone keeps its height. " + text)


def _labels(evidence: Evidence) -> Ruling:
    """Rule on the labels 1 to 255."""
    nx, ny = evidence.maps.cells
    text = f"{nx} x {ny} cells are {nx * ny}."
    return Ruling(Verdict.HOLDS if nx * ny == _PRINTED_LABELS else Verdict.FAILS, text)


_PRINTED_LABELS = 255


def _resolution(evidence: Evidence) -> Ruling:
    """Rule on "0.5 m suits the hull": does a hull in the middle of a cell stay inside it?"""
    maps = evidence.maps
    text = (
        f"The hull is {maps.hull[0]:.3f} m long and {2.0 * maps.half_diagonal:.3f} m across its"
        f" diagonal; a cell has {maps.resolution:.1f} m. The ways to all places pass obstacles at"
        f" {maps.bare_clearance:+.2f} m from the hull when nothing is drawn by hand."
    )
    if 2.0 * maps.half_diagonal <= maps.resolution:
        return Ruling(Verdict.HOLDS, text)
    if max(maps.hull) <= maps.resolution:
        return Ruling(Verdict.CONDITION, "As long as the hull is not turned in its cell. " + text)
    return Ruling(Verdict.FAILS, text)


def _virtual_obstacles(evidence: Evidence) -> Ruling:
    """Rule on "virtual obstacles insure a safe distance" by how far mode paper strays."""
    maps = evidence.maps
    strayed = evidence.trials["as printed"]["max_error"]
    kept = share(strayed < maps.clearance)
    text = (
        f"{maps.drawn} rectangles drawn by hand raise the gap between hull and obstacles from"
        f" {maps.bare_clearance:+.2f} to {maps.clearance:+.2f} m. The drone strays by"
        f" {np.median(strayed):.2f} m at worst (median flight): {percents(kept)} of the flights"
        " keep the gap."
    )
    if maps.clearance <= max(0.0, maps.bare_clearance):
        return Ruling(Verdict.FAILS, text)
    if kept.value >= _SAFE_SHARE:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(Verdict.CONDITION, "As long as the drone keeps to its way. " + text)


def _shortest(evidence: Evidence) -> Ruling:
    """Rule on "Dijkstra's algorithm finds a shortest path" against scipy, for all pairs."""
    maps = evidence.maps
    text = f"{maps.wrong} of {maps.pairs} distances between free cells differ from scipy's."
    return Ruling(Verdict.HOLDS if maps.wrong == 0 else Verdict.FAILS, text)


def _four_moves(evidence: Evidence) -> Ruling:
    """Rule on four movements as the way to a shortest path: against the same way straightened."""
    detour = evidence.maps.detour
    text = (
        f"By four movements the ways to the room's places are {percent(detour - 1.0)} longer than"
        " straightened at any angle."
    )
    if detour < _LONGER_FACTOR:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(Verdict.CONDITION, "Shortest among the paths of four movements only. " + text)


ROOM_CLAIMS: tuple[Claim, ...] = (
    Claim(
        "accurate tracking",
        "II-A",
        "Vicon finds people, robots and objects accurately",
        untestable(
            "Needs the cameras of the room; our tracking is simulated with a noise that we chose."
        ),
        ("2", "3"),
    ),
    Claim(
        "immediate answer",
        "II-A",
        "the database sends a robot what it asks for immediately",
        judge_immediate,
        ("4",),
    ),
    Claim(
        "others are faster",
        "II-A",
        "other groups fly by 100 to 375 frames per second",
        untestable("A statement about other laboratories."),
    ),
    Claim(
        "bandwidth",
        "II-A",
        "the shared network leaves motion capture 10 to 100 frames per second",
        untestable(
            "A property of the authors' network; we take the range as given and fly all of it."
        ),
    ),
    Claim(
        "low frame rate",
        "II-A",
        "10 to 100 frames per second cause unstable behaviors in some cases",
        judge_low_rate,
        ("13",),
    ),
    Claim(
        "speed commands",
        "III",
        "the commands u_x and u_y control the horizontal speeds",
        _speeds,
        ("11",),
    ),
    Claim(
        "bottom camera",
        "III",
        "the bottom camera is used to estimate the altitude",
        untestable(
            "The drone's firmware is closed; by its maker's description ultrasound gives the"
            " height."
        ),
        ("5",),
    ),
    Claim("plane", "IV-A", "considering only the xy plane simplifies planning", _plane, ("6", "7")),
    Claim(
        "resolution",
        "IV-A",
        "0.5 m is a resolution that suits the hull and the room",
        _resolution,
        ("7",),
    ),
    Claim(
        "virtual obstacles",
        "IV-A",
        "virtual obstacles insure a safe distance",
        _virtual_obstacles,
        ("7",),
    ),
    Claim("labels", "IV-B", "the cells of the 25 x 9 map are labeled 1 to 255", _labels, ("7",)),
    Claim(
        "shortest path",
        "IV-B",
        "Dijkstra's algorithm finds a shortest path",
        _shortest,
        ("7", "16"),
    ),
    Claim(
        "four movements",
        "IV-B",
        "four elementary movements are enough for the shortest path",
        _four_moves,
        ("7", "16"),
    ),
)
