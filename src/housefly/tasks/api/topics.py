"""What the tasks publish on the bus."""

from __future__ import annotations

from housefly.bus.topics import Delivery, Encoding, Topic
from housefly.tasks.api.answers import TaskBoard

TASK_NEWS_TOPIC: Topic[TaskBoard] = Topic(
    "tasks/news",
    TaskBoard,
    Delivery.LATEST,
    depth=8,
    max_size=2 * 2**20,
    encoding=Encoding.JSON,
)
