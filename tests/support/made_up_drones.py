"""Drones that nobody sells: one of each form of setpoints, and one with next to nothing.

Their airframes lie beside this file.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from housefly.config import airframe

FOLDER = Path(__file__).parent / "airframes"
VELOCITY, POSITION, BARE = "glider", "homer", "bare"


@contextmanager
def known_made_up_drones() -> Iterator[None]:
    """Let sites name them, for a while."""
    airframe.folders.append(FOLDER)
    try:
        yield
    finally:
        airframe.folders.remove(FOLDER)
