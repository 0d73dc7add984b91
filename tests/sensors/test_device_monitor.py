"""What devices are called."""

import pytest

from housefly.sensors.device_monitor import titled


@pytest.mark.parametrize(
    ("kind", "device", "title"),
    [
        ("Intelligent cabinet", "cabinet", "Intelligent cabinet"),
        ("Intelligent cabinet", "cabinet-2", "Intelligent cabinet cabinet-2"),
        ("Door contact", "entrance-door", "Door contact entrance-door"),
    ],
)
def test_a_title_says_no_word_twice_where_the_kind_says_it_all(
    kind: str, device: str, title: str
) -> None:
    assert titled(kind, device) == title
