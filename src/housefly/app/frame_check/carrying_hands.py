"""Simulated hands: in the simulated room they do what the person is asked to do."""

from __future__ import annotations

import asyncio
from pathlib import Path

from housefly.lab.frames.plan import CarryPlan, CarryStep
from housefly.twin.hands import CarryOrder
from housefly.twin.hands_link import send_carry
from housefly.twin.quadrotor.body import STANDING_HEIGHT

_CARRY_TIME = 1.5
_WAIT = 1.7
"""After a step the drone lies still for as long as a sample and a delay need [s]."""


class CarryingHands:
    """Carries the drone of the simulated room along a plan.

    Args:
        plan: the ways.
        path: socket of the simulated room.
    """

    def __init__(self, plan: CarryPlan, path: Path) -> None:
        self._plan, self._path = plan, path

    async def do(self, step: CarryStep) -> None:
        """Do a step; returns when the drone lies there. Raises LinkError."""
        x, y, z = self._plan.place(step)
        place = (x, y, z + STANDING_HEIGHT)
        send_carry(self._path, CarryOrder(place, self._plan.nose(step), _CARRY_TIME))
        await asyncio.sleep(_CARRY_TIME + _WAIT)
