"""Drones that nobody sells, one of each form of setpoints; their airframes lie beside this file."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from housefly.config import airframe

FOLDER = Path(__file__).parent / "airframes"
VELOCITY, POSITION = "glider", "homer"


@contextmanager
def known_made_up_drones() -> Iterator[None]:
    """Let sites name them, for a while."""
    airframe.folders.append(FOLDER)
    try:
        yield
    finally:
        airframe.folders.remove(FOLDER)
