"""Writes ``docs/bus.md`` from the code: every key of the bus, its type, who writes it, how often.

``python scripts/bus_page.py > docs/bus.md``
"""

from __future__ import annotations

from typing import Any

from housefly.bus.interfaces import ros_name
from housefly.bus.simulated_bell import BELL_QUERY
from housefly.bus.simulated_room import SIMULATION_QUERY
from housefly.bus.topics import (
    HUB_QUERY,
    ROOM_TOPICS,
    TASKS_QUERY,
    USE_EDITS_QUERY,
    Delivery,
    DroneTopics,
    Encoding,
    Topic,
)
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.tasks.api.topics import TASK_NEWS_TOPIC

_HEAD = """# The bus

The processes of a run talk over [zenoh](https://zenoh.io): topics that one writes and many read,
and queries that one answers. This page is made from the code (`python scripts/bus_page.py`).

- **Where**: a Unix socket in the run's folder, which only its user can enter (`bus/endpoint.py`);
  `housefly run` prints it as `bus:`. Nothing listens on a network.
- **Keys** are relative to the run, so two rooms on one machine have two buses. `NAME` is the name
  of a drone; the only one of a site is called `drone`.
- **Encoding**: CDR of ROS 2 interface types, `src/housefly/bus/msg/*.msg`, package `housefly_msgs`;
  what hub and tasks answer as JSON, too, is JSON. A message that is longer than its limit, or makes
  no sense, is not delivered.
- **Latest** keeps some unread messages for a slow reader and drops the oldest; **every** blocks
  rather than lose one.
- Whoever may enter the folder may read, and order; the pilot checks each order as everybody's
  (`messages/order_fault.py`), takes 20 a second of one sender, and its last gate stands.
- Times in CDR messages are the monotonic clock of the machine [s], in JSON Unix time [s].

```python
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus

with ZenohBus(connect="unixsock-stream//tmp/housefly-run-.../bus") as bus:
    bus.subscribe(DroneTopics().step, lambda step: print(step.outputs.estimate))
    print(bus.ask("hub/ask", '{"ask": "where", "thing": "cup"}'))
```

[`examples/05_listen_on_the_bus.py`](../examples/05_listen_on_the_bus.py) starts a house of its own
and listens. From elsewhere: [Python](python.md), [ROS 2](ros2.md), HTTP
([asking](asking.md), [tasks](tasks-screen.md)), [MQTT](devices.md).

## Topics

| key | message | written by | how often | delivery, unread | longest [kB] | |
|---|---|---|---|---|---|---|
"""
_QUERIES_HEAD = """
## Queries

| key | answered by | request; reply |
|---|---|---|
"""
_TOPICS: dict[str, tuple[str, str, str]] = {
    "room/frame": ("room", "each frame of tracking", "where the bodies are"),
    "room/obstacles": ("perception", "10 Hz each", "what stands or walks in the way"),
    "room/depth": ("twin", "as the camera", "depth images of a simulated camera"),
    "room/sensors": ("perception", "1 Hz each", "how scanners and depth cameras do"),
    "room/sight": ("perception", "10 Hz", "until when people were looked for"),
    "room/event": ("tasks", "when it happens", "what the hub is to keep"),
    "room/news": ("hub", "up to 5 Hz", "things, events, situations, obstacles"),
    "tasks/news": ("tasks", "on a change, up to 5 Hz", "the board"),
    "drones/NAME/step": ("pilot", "100 Hz", "all that it heard and decided"),
    "drones/NAME/trajectory": ("pilot", "on a change", "what is planned in space"),
    "drones/NAME/link": ("pilot", "2 Hz", "its wires and its loop"),
    "drones/NAME/video": ("pilot", "as the camera", "H.264, an access unit a message"),
    "drones/NAME/order": ("console, tasks, programs", "when asked", "what people and tasks want"),
    "drones/NAME/recording": ("tasks", "2 Hz while it is so", "whether the camera is recorded"),
}
"""Who writes each key, how often, and what it is."""
_QUERIES = (
    (HUB_QUERY, "hub", "JSON question to the memory ([asking](asking.md)), JSON answer"),
    (TASKS_QUERY, "tasks", "JSON question to the tasks ([tasks](tasks-screen.md)), JSON answer"),
    ("drones/NAME/plan", "pilot", "JSON request of a path, JSON answer"),
    ("drones/NAME/room", "pilot", "nothing; JSON of the room and the map of the drone"),
    ("drones/NAME/preflight", "pilot", "nothing; JSON list of the pre-flight checks"),
    ("drones/NAME/stand_down", "pilot", "nothing; empty, or why it cannot stand still now"),
    (BELL_QUERY, "twin", "nothing; what the doorbell of the simulated room did"),
    (SIMULATION_QUERY, "twin", "JSON of what a person does to the simulated room; what came of it"),
    (USE_EDITS_QUERY, "launcher", "number of saved edits; empty, or why they cannot be used"),
)


def bus_page() -> str:
    """Return the page."""
    topics = (*ROOM_TOPICS, ROOM_NEWS_TOPIC, TASK_NEWS_TOPIC, *DroneTopics("NAME").all)
    rows = "".join(map(_row, topics))
    queries = "".join(f"| `{key}` | {who} | {what} |\n" for key, who, what in _QUERIES)
    return f"{_HEAD}{rows}{_QUERIES_HEAD}{queries}"


def _row(topic: Topic[Any]) -> str:
    writer, often, about = _TOPICS[topic.key]
    is_cdr = topic.encoding is Encoding.CDR
    kind = ros_name(topic.type.__name__) if is_cdr else f"{topic.type.__name__}, JSON"
    every = topic.delivery is Delivery.EVERY
    delivery = "every" if every else f"latest, {topic.depth}"
    size = f"{topic.max_size / 1024:g}"
    return f"| `{topic.key}` | `{kind}` | {writer} | {often} | {delivery} | {size} | {about} |\n"


if __name__ == "__main__":
    print(bus_page(), end="")
