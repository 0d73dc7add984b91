"""The control laws as compiled scalar functions (paper V-B, V-C).

Convention (re-derived, because the paper's signs and names contradict each other): theta is pitch
and accelerates forward, phi is roll and accelerates right, e = reference - estimate, and all gains
are positive. For any heading psi

    x'' = g (cos psi tan theta + sin psi tan phi / cos theta)
    y'' = g (sin psi tan theta - cos psi tan phi / cos theta)

whose exact inverse is ``tilt``; at psi = 0 and psi = pi it is the paper's eqs. (20)-(21).
"""

from __future__ import annotations

from math import atan, cos, sin, sqrt, tan

from housefly.geometry import GRAVITY
from housefly.numeric import clipped, compiled, wrapped


@compiled
def demand(
    error: float, error_rate: float, feed_forward: float, alpha: float, beta: float
) -> float:
    """Return the wanted acceleration [m/s^2] of an axis: beta e + alpha e' + feed-forward.

    Args:
        error: reference minus estimate [m].
        error_rate: its derivative [m/s].
        feed_forward: acceleration of the reference, plus whatever holds the drone back [m/s^2].
        alpha: damping [1/s], positive.
        beta: stiffness [1/s^2], positive.
    """
    return beta * error + alpha * error_rate + feed_forward


@compiled
def tilt(ax: float, ay: float, psi: float, gain: float) -> tuple[float, float]:
    """Return pitch and roll [rad] that accelerate by (ax, ay) [m/s^2] in the world at psi [rad].

    Eqs. (20)-(21) for any heading, divided by the inner loop's static gain c / lambda of eqs.
    (22)-(23).
    """
    c, s = cos(psi), sin(psi)
    forward, left = (c * ax + s * ay) / GRAVITY, (c * ay - s * ax) / GRAVITY
    # cos(atan(t)) = 1 / sqrt(1 + t^2), four times as fast
    theta, phi = atan(forward), -atan(left / sqrt(1.0 + forward * forward))
    return theta / gain, phi / gain


@compiled
def paper_tilt(ax: float, ay: float, facing: float, gain: float) -> tuple[float, float]:
    """Return theta and phi [rad] by eqs. (20)-(21) as printed, with the signs of (8)-(9).

    Args:
        ax: wanted world acceleration along x [m/s^2].
        ay: the same along y.
        facing: +1 for psi = 0, -1 for psi = pi.
        gain: c / lambda.
    """
    theta = atan(facing * ax / GRAVITY)
    phi = -atan(cos(theta) * facing * ay / GRAVITY)
    return theta / gain, phi / gain


@compiled
def saturated_jointly(theta: float, phi: float, bound: float) -> tuple[float, float]:
    """Return the pair scaled to a length of at most ``bound`` [rad].

    The push keeps its direction to 0.8 deg up to 4 m/s^2: angles are scaled, not accelerations.
    """
    length = sqrt(theta * theta + phi * phi)
    if length <= bound:
        return theta, phi
    return theta * bound / length, phi * bound / length


@compiled
def clipped_per_axis(theta: float, phi: float, bound: float) -> tuple[float, float]:
    """Return the pair with each angle clipped by itself, as the paper does; this bends the path."""
    return clipped(theta, bound), clipped(phi, bound)


@compiled
def acceleration(theta: float, phi: float, psi: float) -> tuple[float, float]:
    """Return the world acceleration [m/s^2] at an attitude [rad], eqs. (8)-(9), height held."""
    c, s, lean = cos(psi), sin(psi), tan(theta)
    # 1 / cos(theta) = sqrt(1 + tan^2) for any tilt that is flown, and a tangent costs no more than
    # a sine
    forward, left = GRAVITY * lean, -GRAVITY * tan(phi) * sqrt(1.0 + lean * lean)
    return c * forward - s * left, s * forward + c * left


@compiled
def climb_rate(reference: float, height: float, gain: float, ahead: float, bound: float) -> float:
    """Return the climb rate [m/s] of the altitude law, u_z = K2 (z_ref - z), clipped.

    ``ahead`` is the climb rate of the reference itself [m/s].
    """
    return clipped(gain * (reference - height) + ahead, bound)


@compiled
def compensated_climb_rate(
    wanted: float, climb: float, lift: float, gain: float, pole: float
) -> float:
    """Return the climb rate [m/s] to command to a drone that answers slowly and is pushed.

    v_w + k (v_w - v) - d / p with k = 4 K2 / p - 1: the rate then follows with a pole of 4 K2, both
    poles of the height lie at -2 K2, and a steady push leaves no error. A drone that answers
    faster than that needs no k.

    Args:
        wanted: climb rate v_w that the altitude law wants [m/s].
        climb: climb rate v [m/s].
        lift: steady vertical push d [m/s^2].
        gain: K2 [1/s].
        pole: p [1/s].
    """
    lead = max(4.0 * gain / pole - 1.0, 0.0)
    return wanted + lead * (wanted - climb) - lift / pole


@compiled
def yaw_rate(reference: float, psi: float, gain: float, ahead: float, bound: float) -> float:
    """Return the yaw rate [rad/s] of the yaw law, u_psi = K1 wrap(psi_ref - psi), clipped.

    ``ahead`` is the yaw rate of the reference itself [rad/s].
    """
    return clipped(gain * wrapped(reference - psi) + ahead, bound)
