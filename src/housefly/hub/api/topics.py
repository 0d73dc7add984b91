"""What the hub publishes on the bus."""

from __future__ import annotations

from housefly.bus.topics import Delivery, Encoding, Topic
from housefly.hub.api.answers import News

ROOM_NEWS_TOPIC: Topic[News] = Topic(
    "room/news",
    News,
    Delivery.LATEST,
    depth=50,
    max_size=4 * 2**20,
    encoding=Encoding.JSON,
)
