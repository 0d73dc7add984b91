"""MuJoCo, or an error that says what is missing."""

from __future__ import annotations

import os

from housefly.errors import MissingPartError
from housefly.twin.installed import INSTALL, PART

try:
    import mujoco
except ImportError as error:
    raise MissingPartError(PART, INSTALL) from error
except AttributeError as error:
    # MuJoCo loads the OpenGL that MUJOCO_GL names while it is imported, and trips when the library
    # is not there.
    backend = os.environ.get("MUJOCO_GL", "")
    raise MissingPartError(
        f"the OpenGL library of MUJOCO_GL={backend}",
        "apt-get install libegl1 libgl1-mesa-dri libosmesa6 (or unset MUJOCO_GL)",
    ) from error

__all__ = ["mujoco"]
