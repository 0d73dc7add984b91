"""What the paper claims in sections II to IV: sensors, platform, map and planner."""

from __future__ import annotations

import numpy as np

from housefly.lab.experiments.intervals import mean, share
from housefly.lab.reproduction.evidence import Evidence
from housefly.lab.reproduction.exhibit import Verdict
from housefly.lab.reproduction.ruling import Claim, Ruling, percent, percents, untestable
from housefly.lab.reproduction.streams import LATENCIES, RATES, TYPICAL_LATENCY, TYPICAL_LOSS
from housefly.pilot.estimation.estimator import EstimatorKind

_SLOW, _FAST = RATES[0], RATES[-1]
_PROMPT, _LATE = LATENCIES[0], LATENCIES[-1]
_UNHARMED_SHARE = 0.8
"""An estimator that keeps this share of its edge is not limited by what was changed.

It is half of what separates the paper's range of rates, and far outside the intervals of the edges.
"""
_LONGER_FACTOR = 1.02
"""A path this much longer than another is longer, not rounded."""
_SAFE_SHARE = 0.95
"""A distance is safe when this share of flights keeps it."""
_IMMEDIATE_FACTOR = 1.5
"""A command controls the speed when speed lags at most this many times as much as the angle."""


def _edge(evidence: Evidence, estimator: int, rate: float, latency: float) -> float:
    return mean(evidence.edges.of(estimator, rate, latency)).value


def _low_rate(evidence: Evidence) -> Ruling:
    """Rule on "the low frame rate causes unstable behaviors" by edges at 100 and 10 Hz."""
    kept = {
        name: _edge(evidence, estimator, _SLOW, _PROMPT)
        / _edge(evidence, estimator, _FAST, _PROMPT)
        for estimator, name in _BY_WORDS.items()
    }
    late = {
        name: (
            _edge(evidence, estimator, _SLOW, TYPICAL_LATENCY)
            / _edge(evidence, estimator, _FAST, TYPICAL_LATENCY)
        )
        for estimator, name in _BY_WORDS.items()
    }
    plain, kalman = (
        late[_BY_WORDS[EstimatorKind.FINITE_DIFFERENCE]],
        late[_BY_WORDS[EstimatorKind.ON_ARRIVAL]],
    )
    delay = _edge(evidence, EstimatorKind.ON_ARRIVAL, _FAST, _LATE) / _edge(
        evidence, EstimatorKind.ON_ARRIVAL, _FAST, _PROMPT
    )
    stable = share(
        evidence.streams.where(
            mode="paper",
            mocap_rate_hz=_SLOW,
            mocap_latency=TYPICAL_LATENCY,
            mocap_dropout=TYPICAL_LOSS,
        )["stable"]
        == 1.0
    )
    text = (
        f"From {_FAST:.0f} to {_SLOW:.0f} frames/s the largest stable natural frequency keeps "
        + ", ".join(
            f"{percent(late[name])} ({percent(kept[name])} without latency) with {name}"
            for name in late
        )
        + f". {1000 * _LATE:.0f} ms of latency leave the paper's filter {percent(delay)} at"
        f" {_FAST:.0f} frames/s. With our gains {percents(stable)} of the paper's flights stay"
        f" stable at {_SLOW:.0f} frames/s."
    )
    if kalman < _UNHARMED_SHARE:
        return Ruling(Verdict.HOLDS, text)
    if plain < _UNHARMED_SHARE:
        return Ruling(
            Verdict.CONDITION,
            "Only where frames are held and differentiated, or fed again and again. " + text,
        )
    return Ruling(Verdict.FAILS, text)


_BY_WORDS = {
    EstimatorKind.FINITE_DIFFERENCE: "the held sample differentiated",
    EstimatorKind.HELD_SAMPLE: "a Kalman filter fed the held sample at every tick",
    EstimatorKind.ON_ARRIVAL: "a Kalman filter fed each frame once",
    EstimatorKind.DELAY_COMPENSATED: "the delay-compensated filter",
}


def _immediate(evidence: Evidence) -> Ruling:
    """Rule on "the database answers immediately" by what late answers cost the paper's filter."""
    prompt, middle, late = (
        _edge(evidence, EstimatorKind.ON_ARRIVAL, _FAST, latency) for latency in LATENCIES
    )
    text = (
        f"The largest stable natural frequency of the paper's filter is {prompt:.1f}, {middle:.1f}"
        f" and {late:.1f} rad/s when its frames are"
        f" {', '.join(f'{1000 * latency:.0f}' for latency in LATENCIES)} ms old."
    )
    if late >= _UNHARMED_SHARE * prompt:
        return Ruling(Verdict.HOLDS, text)
    return Ruling(
        Verdict.CONDITION,
        "Immediately must mean well below 50 ms for whoever flies by the answer. " + text,
    )


def _speeds(evidence: Evidence) -> Ruling:
    """Rule on "u_x and u_y control the horizontal speeds": does speed follow as the angle does?"""
    angle, speed = evidence.equations.angle_rise, evidence.equations.speed_rise
    text = (
        f"Under a steady command the angle rises within {angle:.2f} s, the speed within"
        f" {speed:.2f} s."
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
        _immediate,
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
        _low_rate,
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
