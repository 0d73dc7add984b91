"""Whether the simulated room can start: MuJoCo is an extra."""

from __future__ import annotations

from importlib.util import find_spec

from housefly.errors import MissingPartError

PART = "MuJoCo (the simulated room)"
INSTALL = "pip install 'housefly[twin]'"


def is_installed() -> bool:
    """Return whether MuJoCo is there; it is not imported, which takes long."""
    return find_spec("mujoco") is not None


def require_simulator() -> None:
    """Refuse to start a simulated room without MuJoCo; raises MissingPartError."""
    if not is_installed():
        raise MissingPartError(PART, INSTALL)
