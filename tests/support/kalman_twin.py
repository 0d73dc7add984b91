"""What the tests of the two-state filters share: random states, and the filter with matrices."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from housefly.pilot.estimation.constant_velocity import ConstantVelocity

NOISE = 0.003
"""One sigma of a sighting [m]."""
small = st.floats(-0.05, 0.05)
states = st.builds(
    lambda x, v: ConstantVelocity(x, v, 1e-4, 1e-5, 1e-3),
    st.floats(-2.0, 2.0),
    st.floats(-0.5, 0.5),
)


def filtered(
    s: ConstantVelocity, noise: float, dt: float, seen: float, r: float
) -> tuple[np.ndarray, np.ndarray]:
    """One textbook step of the Kalman filter with matrices."""
    f, h = np.array([[1.0, dt], [0.0, 1.0]]), np.array([1.0, 0.0])
    q = noise**2 * np.array([[dt**3 / 3.0, dt**2 / 2.0], [dt**2 / 2.0, dt]])
    x, p = f @ [s.x, s.v], f @ np.array([[s.xx, s.xv], [s.xv, s.vv]]) @ f.T + q
    gain = p @ h / (h @ p @ h + r)
    return x + gain * np.angle(np.exp(1j * (seen - h @ x))), p - np.outer(gain, h @ p)
