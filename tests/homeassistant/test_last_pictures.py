"""The newest snapshot of each drone is shown, written down once, and not in privacy."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

import pytest
from clip_rows import NOW, added, clip
from PIL import Image

from housefly.config.house_mode import HouseMode
from housefly.config.tasks import TasksConfig
from housefly.evidence.clip_index import ClipIndex
from housefly.homeassistant.last_pictures import LastPictures
from housefly.homeassistant.topics import HomeTopics

TOPICS = HomeTopics("home")
RED, BLUE = TOPICS.picture("drone-red-image"), TOPICS.picture("drone-blue-image")


class Kept:
    """An index of clips, and who looks at its newest snapshots."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.mode = folder, HouseMode.HOME
        self.index = ClipIndex(folder, TasksConfig(), wall=lambda: NOW)
        self.pictures = LastPictures(self.index, ("red", "blue"), TOPICS, lambda: self.mode)

    def add(self, at: float, drone: str, brightness: int) -> str:
        name = added(self.index, self.folder, clip(at, "snapshot", drone=drone))
        Image.new("L", (64, 36), brightness).convert("RGB").save(self.folder / f"{name}.jpg")
        return name

    def shown(self) -> dict[str, int]:
        """Return how bright the picture on each topic is."""
        return {
            topic: round(Image.open(BytesIO(picture)).convert("L").getpixel((9, 9)) / 50)
            for topic, picture in self.pictures.messages()
        }


@pytest.fixture
def kept(tmp_path: Path) -> Iterator[Kept]:
    made = Kept(tmp_path)
    yield made
    made.index.close()


def test_the_newest_snapshot_of_each_drone_is_shown_and_no_clip(kept: Kept) -> None:
    assert kept.shown() == {}
    kept.add(NOW - 30.0, "", 50)
    kept.add(NOW - 20.0, "blue", 100)
    added(kept.index, kept.folder, clip(NOW - 5.0, "clip", drone="red"))
    assert kept.shown() == {RED: 1, BLUE: 2}, "what an earlier version kept is of the first"
    kept.add(NOW - 10.0, "red", 200)
    assert kept.shown() == {RED: 4, BLUE: 2}


def test_who_was_shown_a_picture_is_written_down_once(kept: Kept) -> None:
    name = kept.add(NOW, "red", 50)
    for _ in range(3):
        kept.shown()
    assert [(entry.who, entry.what) for entry in kept.index.audit_log(name)] == [
        ("Home Assistant", "watched")
    ]


@pytest.mark.parametrize("mode", [HouseMode.PRIVACY, HouseMode.MAINTENANCE, None])
def test_in_a_mode_that_records_nothing_nothing_is_shown(kept: Kept, mode: HouseMode) -> None:
    kept.add(NOW, "red", 50)
    kept.mode = mode
    assert kept.shown() == {}


def test_a_deleted_or_broken_file_is_no_picture(kept: Kept) -> None:
    added(kept.index, kept.folder, clip(NOW, "snapshot", drone="red"))
    assert kept.shown() == {}, "its file holds zeros"
    name = kept.add(NOW + 1.0, "red", 50)
    (kept.folder / f"{name}.jpg").unlink()
    assert kept.shown() == {}
