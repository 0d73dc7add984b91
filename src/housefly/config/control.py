"""The gains of the control laws, the thresholds of the acceptor and the noise of the filter."""

from __future__ import annotations

from housefly.config.section import Section, quantity


class ControlConfig(Section):
    """Gains of paper eqs. (20)-(21) in the consistent sign convention, and of the P laws."""

    alpha: float = quantity(
        3.6, 0.1, 20.0, "1/s", "damping gain: a = alpha * velocity error + beta * position error"
    )
    beta: float = quantity(3.24, 0.05, 50.0, "1/s^2", "stiffness gain")
    yaw_gain: float = quantity(1.5, 0.1, 10.0, "1/s", "K1: yaw rate per yaw error")
    height_gain: float = quantity(1.2, 0.1, 10.0, "1/s", "K2: climb rate per height error")
    feed_forward: float = quantity(
        1.0, 0.0, 1.0, "1", "share of the reference's velocity and acceleration that is led with"
    )
    epsilon_height: float = quantity(0.2, 0.01, 1.0, "m", "eps1 of the finite state acceptor")
    epsilon_yaw: float = quantity(
        0.35, 0.001, 1.5, "rad", "eps2; mode paper uses the printed 0.2 deg"
    )
    epsilon_position: float = quantity(
        0.15, 0.02, 1.0, "m", "eps3; mode paper uses the printed 0.4 m"
    )
    dwell: float = quantity(
        0.3, 0.0, 5.0, "s", "shortest stay in a state of the acceptor (mode default)"
    )
    rate_hz: float = quantity(100.0, 20.0, 200.0, "Hz", "pilot loop frequency")
    acceleration_noise: float = quantity(
        0.4,
        0.01,
        20.0,
        "m/s^2",
        "Kalman filter: one-sigma unmodelled acceleration; mode paper takes the number as a"
        " spectral density [m/s^1.5]",
    )
    position_noise: float = quantity(
        0.003, 0.0001, 1.0, "m", "Kalman filter: one-sigma tracking noise"
    )
