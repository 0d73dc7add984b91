"""The ROS 2 interface types of Housefly: standard ones, and its own in ``msg/*.msg``.

One type store serves the bus, the flight recorder and the replay, so that the same bytes go
everywhere.
"""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import Any

from rosbags.typesys import Stores, TypesysError, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

from housefly.errors import WireError

_PACKAGE = "housefly_msgs"
"""ROS package name of our own types."""

_FOREIGN = {"CompressedVideo": "foxglove_msgs"}
"""Types in ``msg/`` of other packages, because ROS 2 does not ship them."""


def ros_name(name: str) -> str:
    """Return the full ROS 2 name of a type in ``msg/``, for example ``housefly_msgs/msg/Order``."""
    return f"{_FOREIGN.get(name, _PACKAGE)}/msg/{name}"


@cache
def type_store() -> Typestore:
    """Return the types of ROS 2 Jazzy and our own."""
    store = get_typestore(Stores.ROS2_JAZZY)
    own: dict[str, Any] = {}
    for entry in files("housefly.bus").joinpath("msg").iterdir():
        if entry.name.endswith(".msg"):
            name = entry.name.removesuffix(".msg")
            own.update(get_types_from_msg(entry.read_text(encoding="utf-8"), ros_name(name)))
    store.register(own)
    return store


@cache
def recorded_store(type_name: str, schema: str) -> Typestore:
    """Return the types that a recording was written with.

    Args:
        type_name: of its messages.
        schema: its own ``ros2msg`` text, nested types included.

    Raises:
        WireError: the text defines no types.
    """
    if schema == definition(type_name):
        return type_store()
    store = get_typestore(Stores.EMPTY)
    try:
        store.register(get_types_from_msg(schema, type_name))
    except TypesysError as error:
        raise WireError(f"{type_name} is not defined: {error}") from error
    return store


def definition(type_name: str) -> str:
    """Return the complete ``ros2msg`` schema text of a type, nested types included."""
    text, _ = type_store().generate_msgdef(type_name, ros_version=2)
    return str(text)
