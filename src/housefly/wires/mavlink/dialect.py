"""pymavlink's definitions of the common messages: an optional part, loaded when first asked for."""

from __future__ import annotations

from functools import lru_cache
from importlib import import_module
from typing import Any

from housefly.errors import MissingPartError

PART = "pymavlink (the definitions of MAVLink)"
INSTALL = 'pip install "housefly[mavlink]"'


@lru_cache
def dialect() -> Any:
    """Return the module of the common messages; raises MissingPartError where there is none."""
    try:
        return import_module("pymavlink.dialects.v20.common")
    except ImportError as error:
        raise MissingPartError(PART, INSTALL) from error
