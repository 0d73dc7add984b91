"""What clients of rosbridge ask of ``rosapi``: which topics and services there are, the time."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from housefly.errors import WireError
from housefly.record.ros_messages import nanoseconds
from housefly.ros2.ros_json import full_type

_NODE = "/housefly"
_TEXT_MAX = 256


@dataclass(frozen=True, slots=True)
class Directory:
    """What there is, by full name.

    Attributes:
        topics: their types.
        services: likewise.
        inputs: topics to which clients publish; they are among ``topics``.
    """

    topics: Mapping[str, str]
    services: Mapping[str, str]
    inputs: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class RosapiService:
    """One service: its type, the names of its parameters, what answers it."""

    type: str
    parameters: tuple[str, ...]
    answer: Callable[..., dict[str, Any]]


def _topics(there: Directory) -> dict[str, Any]:
    return {"topics": list(there.topics), "types": list(there.topics.values())}


def _of_type(names: Mapping[str, str], kind: str) -> list[str]:
    return [name for name, one in names.items() if one in (kind, full_type(kind))]


def _time(_: Directory) -> dict[str, Any]:
    seconds, rest = divmod(nanoseconds(time.time()), 1_000_000_000)
    return {"time": {"sec": seconds, "nanosec": rest}}


def _node_details(there: Directory, node: str) -> dict[str, Any]:
    told = [name for name in there.topics if name not in there.inputs]
    if node != _NODE:
        return {"subscribing": [], "publishing": [], "services": []}
    return {
        "subscribing": sorted(there.inputs),
        "publishing": told,
        "services": list(there.services),
    }


ROSAPI: dict[str, RosapiService] = {
    "/rosapi/topics": RosapiService("rosapi_msgs/srv/Topics", (), _topics),
    "/rosapi/topic_type": RosapiService(
        "rosapi_msgs/srv/TopicType",
        ("topic",),
        lambda there, topic: {"type": there.topics.get(topic, "")},
    ),
    "/rosapi/topics_for_type": RosapiService(
        "rosapi_msgs/srv/TopicsForType",
        ("type",),
        lambda there, kind: {"topics": _of_type(there.topics, kind)},
    ),
    "/rosapi/services": RosapiService(
        "rosapi_msgs/srv/Services", (), lambda there: {"services": list(there.services)}
    ),
    "/rosapi/service_type": RosapiService(
        "rosapi_msgs/srv/ServiceType",
        ("service",),
        lambda there, service: {"type": there.services.get(service, "")},
    ),
    "/rosapi/services_for_type": RosapiService(
        "rosapi_msgs/srv/ServicesForType",
        ("type",),
        lambda there, kind: {"services": _of_type(there.services, kind)},
    ),
    "/rosapi/nodes": RosapiService("rosapi_msgs/srv/Nodes", (), lambda there: {"nodes": [_NODE]}),
    "/rosapi/node_details": RosapiService("rosapi_msgs/srv/NodeDetails", ("node",), _node_details),
    "/rosapi/get_time": RosapiService("rosapi_msgs/srv/GetTime", (), _time),
}


def rosapi_answer(
    service: RosapiService, there: Directory, args: dict[str, Any] | list[Any] | None
) -> dict[str, Any]:
    """Return the answer to a call.

    Raises:
        WireError: a parameter is missing, or no text.
    """
    given = dict(zip(service.parameters, args, strict=False)) if isinstance(args, list) else args
    values = [(given or {}).get(name) for name in service.parameters]
    for name, value in zip(service.parameters, values, strict=True):
        if not isinstance(value, str) or len(value) > _TEXT_MAX:
            raise WireError(f"args.{name}: a text of at most {_TEXT_MAX} letters is needed")
    return service.answer(there, *values)
