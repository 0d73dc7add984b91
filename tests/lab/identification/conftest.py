"""Blocks flown by the reduced-order drone with its own constants, tracked with noise at 30 Hz."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from housefly.lab.identification.pattern import Axis, Block, blocks
from housefly.lab.identification.samples import COMMANDS_BEFORE, Samples
from housefly.numeric import compiled_with_arrays
from housefly.pilot.control.model import Constants, DroneState, drone_step

TICK = 0.01
STEPS = 20
"""Steps of the drone for each tick: switches are then known to a quarter of a millisecond."""


@compiled_with_arrays
def integrated(
    body: DroneState,
    edges: np.ndarray,
    values: np.ndarray,
    axis: int,
    wind: tuple[float, float],
    constants: Constants,
    dt: float,
    steps: int,
) -> np.ndarray:
    """Return the states of the drone, shape (steps + 1, 10).

    The command ``values[i]`` acts from ``edges[i]`` on.
    """
    states = np.zeros((steps + 1, 10))
    at = 0
    for step in range(steps + 1):
        for column in range(10):
            states[step, column] = body[column]
        while at + 1 < edges.size and edges[at + 1] <= (step + 0.5) * dt:
            at += 1
        value = values[at]
        theta, phi = value if axis == 0 else 0.0, value if axis == 1 else 0.0
        climb, turn = value if axis == 2 else 0.0, value if axis == 3 else 0.0
        body = drone_step(body, theta, phi, climb, turn, wind, constants, dt)
    return states


def fly_block(
    block: Block,
    constants: Constants,
    delay: float,
    random: np.random.Generator,
    *,
    frames_hz: float = 30.0,
    noise: float = 0.001,
    dropout: float = 0.05,
    late: float = 0.0,
) -> Samples:
    """Fly one block from near rest; ``late`` is one sigma of how much later switches leave [s]."""
    ticks = np.arange(-round(COMMANDS_BEFORE / TICK), round(block.duration / TICK) + 1) * TICK
    sent = np.array([block.asked(t + 1e-9) if t > -1e-9 else 0.0 for t in ticks])
    edges = ticks.copy()
    jumps = np.flatnonzero(np.diff(sent, prepend=0.0))
    edges[jumps] += random.uniform(-1.73, 1.73, jumps.size) * late
    start = random.normal(0.0, 0.02, 4)
    body = DroneState(
        0.1, -0.2, 1.1, 0.4, start[0], start[1], start[2], 0.0, start[3] * 0.2, start[3] * 0.2
    )
    wind = tuple(random.normal(0.0, 0.05, 2).tolist())
    dt = TICK / STEPS
    axis = list(Axis).index(block.axis)
    states = integrated(
        body,
        edges + delay,
        sent,
        axis,
        (wind[0], wind[1]),
        constants,
        dt,
        round(block.duration / dt),
    )
    return seen(block, ticks, sent, states, dt, random, frames_hz, noise, dropout)


def seen(
    block: Block,
    ticks: np.ndarray,
    sent: np.ndarray,
    states: np.ndarray,
    dt: float,
    random: np.random.Generator,
    frames_hz: float,
    noise: float,
    dropout: float,
) -> Samples:
    at = np.arange(random.uniform(0.0, 1.0 / frames_hz), block.duration, 1.0 / frames_hz)
    at = at[random.random(at.size) >= dropout]
    index = np.round(at / dt).astype(int)
    rows, at = states[index], index * dt
    x, y, z, psi = rows[:, :4].T
    theta, phi = rows[:, 8:].T
    psi0 = rows[0, 3]
    place = {
        Axis.PITCH: x * np.cos(psi0) + y * np.sin(psi0),
        Axis.ROLL: x * np.sin(psi0) - y * np.cos(psi0),
        Axis.CLIMB: z,
        Axis.TURN: np.unwrap(psi),
    }[block.axis]
    spread = noise / 0.15 if block.axis is Axis.TURN else noise
    angle = {Axis.PITCH: theta, Axis.ROLL: phi}.get(block.axis, np.zeros(0))
    return Samples(
        block,
        ticks,
        sent,
        at,
        place + random.normal(0.0, spread, at.size),
        angle + random.normal(0.002, noise / 0.15, angle.size),
    )


@pytest.fixture(scope="session")
def fly_pattern() -> Callable[..., tuple[Samples, ...]]:
    """Return a function that flies all blocks of a pattern."""

    def fly(
        constants: Constants, delay: float, seed: int, repeats: int = 6, **tracking: float
    ) -> tuple[Samples, ...]:
        random = np.random.default_rng(seed)
        return tuple(
            fly_block(block, constants, delay, random, **tracking)
            for block in blocks(repeats, 0.21)
        )

    return fly
