"""Who may do what: a role for every message of a browser and every path of the server.

STOP and LAND are for everybody who is in: whatever else is refused, those only make the drone
safer. What is not in a table needs the highest role.
"""

from __future__ import annotations

from typing import Any

from housefly.hub.api.endpoints import API_PREFIX
from housefly.messages import OrderKind
from housefly.messages.words import UNSAID, Words
from housefly.web.messages.client_messages import (
    Hello,
    InviteRequest,
    LeaseRequest,
    NudgeRequest,
    OrderRequest,
    PingRequest,
    PlanQuestion,
    StopRequest,
)
from housefly.web.messages.role import Role as Role

ROLE_OF_MESSAGE: dict[type, Role] = {
    Hello: Role.WATCH,
    PingRequest: Role.WATCH,
    StopRequest: Role.WATCH,
    PlanQuestion: Role.ASK,
    NudgeRequest: Role.FLY,
    LeaseRequest: Role.FLY,
    InviteRequest: Role.ADMIN,
}
"""For a message other than an order."""

ROLE_OF_ORDER: dict[OrderKind, Role] = {
    OrderKind.STOP: Role.WATCH,
    OrderKind.LAND: Role.WATCH,
    OrderKind.TAKE_OFF: Role.FLY,
    OrderKind.HOVER: Role.FLY,
    OrderKind.GO: Role.FLY,
    OrderKind.SERVICE: Role.FLY,
    OrderKind.HOME: Role.FLY,
    OrderKind.RESUME: Role.FLY,
    OrderKind.CUT: Role.FLY,
    OrderKind.RESET: Role.FLY,
    OrderKind.NUDGE: Role.FLY,
}

OPEN_PATHS = (
    *("/", "/login", "/logout", "/account", "/service-worker.js", "/authority.crt"),
    f"{API_PREFIX}/openapi.json",
)
"""They ask for themselves who is there, or tell nothing."""
OPEN_FOLDERS = ("/static/",)

ROLE_OF_PATH: dict[str, Role] = {
    "/socket": Role.WATCH,
    "/rosbridge": Role.WATCH,
    "/stop": Role.WATCH,
    "/drones": Role.WATCH,
    "/video": Role.WATCH,
    "/video.mjpeg": Role.WATCH,
    "/coverage": Role.WATCH,
    "/flights": Role.WATCH,
    "/edits": Role.WATCH,
    "/bell": Role.WATCH,
    "/simulation": Role.WATCH,
    f"{API_PREFIX}/watch": Role.WATCH,
    f"{API_PREFIX}/picture": Role.WATCH,
    f"{API_PREFIX}/things": Role.WATCH,
    f"{API_PREFIX}/events": Role.WATCH,
    f"{API_PREFIX}/feed": Role.WATCH,
    f"{API_PREFIX}/sensors": Role.WATCH,
    f"{API_PREFIX}/near": Role.ASK,
    f"{API_PREFIX}/people": Role.ASK,
    f"{API_PREFIX}/nights": Role.ASK,
    f"{API_PREFIX}/tasks": Role.WATCH,
    f"{API_PREFIX}/tasks/history": Role.WATCH,
    f"{API_PREFIX}/services": Role.WATCH,
    f"{API_PREFIX}/rules": Role.WATCH,
    f"{API_PREFIX}/rules/dry-run": Role.ASK,
    f"{API_PREFIX}/clips": Role.WATCH,
    f"{API_PREFIX}/clips.zip": Role.FLY,
}
"""For reading, and for WebSockets."""
ROLE_OF_FOLDER: dict[str, Role] = {
    "/flights/": Role.WATCH,
    f"{API_PREFIX}/where/": Role.ASK,
    f"{API_PREFIX}/contents/": Role.ASK,
    f"{API_PREFIX}/trajectory/": Role.ASK,
    f"{API_PREFIX}/is/": Role.ASK,
    f"{API_PREFIX}/clips/": Role.WATCH,
}
ROLE_OF_CHANGE: dict[str, Role] = {
    "/stop": Role.WATCH,
    "/land": Role.WATCH,
    "/edits": Role.ADMIN,
    "/bell": Role.ASK,
    "/simulation": Role.FLY,
    "/edits/undo": Role.ADMIN,
    "/edits/use": Role.ADMIN,
    f"{API_PREFIX}/tasks": Role.ASK,
    f"{API_PREFIX}/tasks/rehearse": Role.ASK,
    f"{API_PREFIX}/sentence": Role.ASK,
    f"{API_PREFIX}/mode": Role.FLY,
    f"{API_PREFIX}/photo": Role.FLY,
}
"""For every method but GET and HEAD. What a mere asker asks for waits for somebody's yes."""
ROLE_OF_TASK_CHANGE: dict[str, Role] = {
    "cancel": Role.ASK,
    "reply": Role.FLY,
    "pause": Role.FLY,
    "continue": Role.FLY,
}
"""For ``/tasks/{id}/{change}``; a mere asker ends only what they asked for (``tasks_api``)."""
ROLE_OF_CLIP_CHANGE: dict[str, Role] = {"keep": Role.FLY, "delete": Role.ADMIN}
"""For ``/clips/{id}/{change}``."""
ROLE_OF_RULE_CHANGE: dict[str, Role] = {"change": Role.ADMIN}
"""For ``/rules/{name}/{change}``: what the house does by itself is for who runs it."""
_CHANGES_BELOW = {
    f"{API_PREFIX}/tasks/": ROLE_OF_TASK_CHANGE,
    f"{API_PREFIX}/clips/": ROLE_OF_CLIP_CHANGE,
    f"{API_PREFIX}/rules/": ROLE_OF_RULE_CHANGE,
}


def role_for_message(message: Any) -> Role:
    """Return the role that a browser's message needs."""
    if isinstance(message, OrderRequest):
        return ROLE_OF_ORDER.get(message.order, Role.ADMIN)
    return ROLE_OF_MESSAGE.get(type(message), Role.ADMIN)


def role_for_path(path: str, *, changes: bool) -> Role | None:
    """Return the role that a request needs, or None for a path that is open.

    Args:
        path: without the query.
        changes: whether the method is another than GET and HEAD.
    """
    if path in OPEN_PATHS or path.startswith(OPEN_FOLDERS):
        return None
    if changes:
        return ROLE_OF_CHANGE.get(path) or _role_for_change_of_one(path)
    for folder, role in ROLE_OF_FOLDER.items():
        if path.startswith(folder):
            return role
    return ROLE_OF_PATH.get(path, Role.ADMIN)


def _role_for_change_of_one(path: str) -> Role:
    """Return the role for a change of one task, clip or rule."""
    for folder, roles in _CHANGES_BELOW.items():
        one, _, change = path.removeprefix(folder).partition("/")
        if path.startswith(folder) and one:
            return roles.get(change, Role.ADMIN)
    return Role.ADMIN


def role_objection(role: Role, needed: Role) -> Words:
    """Return why a role is not enough, in words, or UNSAID."""
    if role.includes(needed):
        return UNSAID
    return Words(
        "your role is {name}, and this needs {what}: ask who runs Housefly",
        name=repr(role.value),
        what=repr(needed.value),
    )
