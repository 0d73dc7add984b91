"""The strangers' programs that the environment names."""

from __future__ import annotations

import os
import socket
from pathlib import Path

import pytest


def named_firmware(variable: str) -> Path:
    """Return the program that a variable names; skip where it may not run here."""
    path = os.environ.get(variable, "")
    if not path:
        pytest.skip(f"{variable} names no program")
    if others := [name for _, name in socket.if_nameindex() if name != "lo"]:
        pytest.skip(f"it listens on every interface ({others}): run this under unshare -rn")
    return Path(path)
