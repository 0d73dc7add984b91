"""The four motors: a wrench as four thrusts, what weak motors and a low voltage leave of it.

Order everywhere: front left, front right, rear right, rear left. Front left and rear right turn so
that more of their thrust turns the drone to the left.
"""

from __future__ import annotations

from housefly.twin.disturbance import MotorGains
from housefly.twin.drone_mechanics import USUAL, Mechanics
from housefly.twin.simulated_body import MOTORS_OFF, Wrench

_YAW_ARM = 0.02
"""Torque about z over thrust of one rotor [m]; typical of propellers of this size."""


def motor_duties(wrench: Wrench, mechanics: Mechanics = USUAL) -> MotorGains:
    """Return the duty cycles of the four motors, 0 to 1; turning left or right is left out."""
    if wrench.thrust <= 0.0:
        return 0.0, 0.0, 0.0, 0.0
    front_left, front_right, rear_right, rear_left = (
        min(max(4 * force / mechanics.thrust_max, 0.0), 1.0)
        for force in _lifts(wrench, mechanics.rotor_arm)
    )
    return front_left, front_right, rear_right, rear_left


def achieved_wrench(
    wrench: Wrench,
    gains: MotorGains,
    voltage_share: float = 1.0,
    mechanics: Mechanics = USUAL,
) -> Wrench:
    """Return what motors make of a wrench.

    Each saturates between none and full thrust; lift and attitude go before yaw.

    Args:
        wrench: what the firmware asks.
        gains: share of its thrust that each motor has, 0 to 1.
        voltage_share: voltage over the voltage without load; full thrust falls with its square,
            because the speed of a motor follows its voltage.
        mechanics: of the drone.
    """
    if wrench.thrust <= 0.0:
        return MOTORS_OFF
    arm = mechanics.rotor_arm
    full = mechanics.thrust_max / 4 * voltage_share * voltage_share
    lifts = [min(max(force, 0.0), full) for force in _lifts(wrench, arm)]
    room = min(min(force, full - force) for force in lifts)
    turn = min(max(wrench.yaw / (4 * _YAW_ARM), -room), room)
    signed = (turn, -turn, turn, -turn)
    front_left, front_right, rear_right, rear_left = (
        gain * (force + share) for gain, force, share in zip(gains, lifts, signed, strict=True)
    )
    return _pushed((front_left, front_right, rear_right, rear_left), arm)


def rotor_wrench(shares: MotorGains, mechanics: Mechanics) -> Wrench:
    """Return what four rotors push that have such shares of their full thrust, 0 to 1."""
    full = mechanics.thrust_max / 4
    front_left, front_right, rear_right, rear_left = (full * share for share in shares)
    return _pushed((front_left, front_right, rear_right, rear_left), mechanics.rotor_arm)


def _pushed(forces: MotorGains, arm: float) -> Wrench:
    """Return what four thrusts [N] push together."""
    front_left, front_right, rear_right, rear_left = forces
    return Wrench(
        thrust=front_left + front_right + rear_right + rear_left,
        roll=arm * (front_left - front_right - rear_right + rear_left),
        pitch=arm * (rear_right + rear_left - front_left - front_right),
        yaw=_YAW_ARM * (front_left - front_right + rear_right - rear_left),
    )


def _lifts(wrench: Wrench, arm: float) -> MotorGains:
    """Return the thrust of each motor [N] that lifts, rolls and pitches."""
    lift, roll, pitch = (
        wrench.thrust / 4,
        wrench.roll / (4 * arm),
        wrench.pitch / (4 * arm),
    )
    return lift + roll - pitch, lift - roll - pitch, lift - roll + pitch, lift + roll + pitch
