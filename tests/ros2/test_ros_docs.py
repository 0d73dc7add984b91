"""The page of ROS 2 says of every topic what the table of the node says."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.ros2.topic_table import DRONE_TOPICS, ROOM_TOPICS, RosTopic

PAGE = (Path(__file__).parents[2] / "docs" / "ros2.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("topic", (*DRONE_TOPICS, *ROOM_TOPICS), ids=lambda one: one.name)
def test_every_topic_stands_on_the_page(topic: RosTopic) -> None:
    assert f"| `{topic.name}` | `{topic.type}` | {topic.quality.value} | {topic.about} |" in PAGE
