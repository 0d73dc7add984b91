"""Who an order is from when a person gave it."""

from __future__ import annotations

from housefly.messages.flight import TASK_SENDER
from housefly.messages.order_fault import NAME_LENGTH_MAX


def person_sender(name: str) -> str:
    """Return the sender of a person's order; no name makes it look like a task's."""
    own = f"person {name}" if name.startswith(TASK_SENDER) else name
    return own[:NAME_LENGTH_MAX]
