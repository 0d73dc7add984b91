"""ROS messages as JSON, as rosbridge writes them.

Bytes are base64, times ``sec`` and ``nanosec``, numbers that JSON does not have null. Source:
ROSBRIDGE_PROTOCOL.md of the rosbridge v2 protocol, section 3.1, and what its ROS 2 server sends.
"""

from __future__ import annotations

from base64 import b64encode
from math import isfinite, nan
from typing import Any

import numpy as np
from rosbags.interfaces import Nodetype

from housefly.bus.interfaces import type_store
from housefly.config.text import shortened
from housefly.errors import WireError

_BYTES = frozenset({"uint8", "char"})
"""Arrays of them are base64."""
_INTEGERS = {
    **{f"int{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in (8, 16, 32, 64)},
    **{f"uint{bits}": (0, 2**bits - 1) for bits in (8, 16, 32, 64)},
    **dict.fromkeys(("octet", "byte", "char"), (0, 255)),
}
_FLOATS = {"float32": 3.4e38, "float64": float("inf")}
_SHOWN = 40


def full_type(name: str) -> str:
    """Return the full name of a type: ``std_msgs/String`` is ``std_msgs/msg/String``."""
    package, slash, rest = name.partition("/")
    return f"{package}/msg/{rest}" if slash and "/" not in rest else name


def json_tree(message: Any) -> dict[str, Any]:
    """Return a message as what ``json`` writes."""
    _, fields = type_store().fielddefs[message.__msgtype__]
    return {name: _told(kind, getattr(message, name)) for name, kind in fields}


def message_of(tree: Any, kind: str, where: str = "msg") -> Any:
    """Return the message of a type that a JSON tree holds; what it leaves out is zero or empty.

    Raises:
        WireError: naming the field, the value, and what is allowed.
    """
    if not isinstance(tree, dict):
        raise WireError(f"{where} is {_short(tree)}; allowed: an object, as {kind} has it")
    _, fields = type_store().fielddefs[kind]
    known = {name for name, _ in fields}
    if unknown := sorted(set(tree) - known):
        there = ", ".join(sorted(known - {"structure_needs_at_least_one_member"})) or "none"
        raise WireError(f"{where}.{_short(unknown[0])}: no such field; there are: {there}")
    values = {
        name: _read(field, tree[name], f"{where}.{name}") if name in tree else _empty(field)
        for name, field in fields
    }
    return type_store().types[kind](**values)


def _told(kind: Any, value: Any) -> Any:
    node, what = kind
    if node is Nodetype.NAME:
        return json_tree(value)
    if node is Nodetype.BASE:
        return _told_plain(what[0], value)
    (inner_node, inner), _ = what
    if inner_node is not Nodetype.BASE:
        return [_told(what[0], one) for one in value]
    if inner[0] in _BYTES:
        return b64encode(np.asarray(value, dtype=np.uint8).tobytes()).decode()
    plain = value.tolist() if isinstance(value, np.ndarray) else value
    return [_told_plain(inner[0], one) for one in plain]


def _told_plain(kind: str, value: Any) -> Any:
    if kind in _FLOATS:
        exact = np.float32(value) if kind == "float32" else value  # as ROS has it, bit for bit
        return float(exact) if isfinite(exact) else None
    if kind in _INTEGERS:
        return int(value)
    return bool(value) if kind == "bool" else str(value)


def _read(kind: Any, value: Any, where: str) -> Any:
    node, what = kind
    if node is Nodetype.NAME:
        return message_of(value, what, where)
    if node is Nodetype.BASE:
        return _read_plain(what[0], value, where)
    raise WireError(f"{where} is a list, which no message to this room has")


def _read_plain(kind: str, value: Any, where: str) -> Any:
    if kind in _FLOATS:
        if value is None:
            return nan
        if _is_number(value) and abs(value) <= _FLOATS[kind]:
            return float(value)
        raise WireError(f"{where} is {_short(value)}; allowed: a number of {kind}, or null")
    if kind in _INTEGERS:
        low, high = _INTEGERS[kind]
        if isinstance(value, int) and not isinstance(value, bool) and low <= value <= high:
            return value
        raise WireError(f"{where} is {_short(value)}; allowed: a whole number, {low} to {high}")
    wanted, words = (bool, "true or false") if kind == "bool" else (str, "text")
    if not isinstance(value, wanted):
        raise WireError(f"{where} is {_short(value)}; allowed: {words}")
    return value


def _empty(kind: Any) -> Any:
    node, what = kind
    if node is Nodetype.NAME:
        return message_of({}, what)
    if node is Nodetype.BASE:
        return "" if what[0] == "string" else False if what[0] == "bool" else 0
    return []


def _is_number(value: Any) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return isfinite(value)
    except OverflowError:
        return False


def _short(value: Any) -> str:
    return shortened(repr(value), _SHOWN)
