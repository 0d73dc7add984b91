"""A child process that hears ROS 2 for its parent, in lines of JSON; it ends with the parent.

rclpy has threads of its own and may not be reloaded: it is nobody's guest.
"""

from __future__ import annotations

import importlib
import importlib.util
import json
import os
import signal
import sys
import threading
from collections.abc import Callable
from typing import IO, Any

from housefly.errors import MissingPartError


def ros2_command(module: str, settings: dict[str, Any]) -> tuple[str, ...]:
    """Return what starts a child.

    Args:
        module: that calls ``run_ros2_child``.
        settings: for it, ``domain`` and ``discovery`` among them.

    Raises:
        MissingPartError: there is no rclpy.
    """
    if importlib.util.find_spec("rclpy") is None:
        raise MissingPartError("rclpy", "source ROS 2, or pip install 'housefly[ros2]'")
    return sys.executable, "-m", module, json.dumps(settings)


def run_ros2_child(hear: Callable[[dict[str, Any], IO[str]], None]) -> None:
    """Run a child until the parent is gone.

    Args:
        hear: is given the settings, and where its lines go; it may raise whatever the library
            raises, and the parent says it in words.
    """
    settings = json.loads(sys.argv[1])
    out = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)  # what the library itself prints
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent
    threading.Thread(target=_end_with_parent, daemon=True).start()
    try:
        hear(settings, out)
    except BrokenPipeError:
        return
    except Exception as error:
        write_line(out, {"problem": str(error) or type(error).__name__})


def ros2_node(name: str, settings: dict[str, Any]) -> Any:
    """Join ROS 2 as its parent's settings say; return the node."""
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = settings["discovery"].upper()
    rclpy = importlib.import_module("rclpy")
    none = importlib.import_module("rclpy.signals").SignalHandlerOptions.NO
    rclpy.init(args=[], domain_id=settings["domain"], signal_handler_options=none)
    return rclpy.create_node(name)


def ros2_type(name: str) -> Any:
    """Return the class of an interface by its full name; raises ImportError, AttributeError."""
    package, kind, interface = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), interface)


def write_line(out: IO[str], line: dict[str, Any]) -> None:
    """Tell the parent something."""
    out.write(json.dumps(line) + "\n")


def _end_with_parent() -> None:
    sys.stdin.buffer.read()
    os._exit(0)
