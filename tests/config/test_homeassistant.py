"""What a site file may say of Home Assistant."""

from __future__ import annotations

from typing import Any

import pytest

from housefly.config.site import Site, site_from_tree
from housefly.errors import ConfigError

OPEN = {"broker": "192.168.1.10"}
GUARDED = {"broker": "192.168.1.10", "username": "housefly"}
OWN = {"broker": "127.0.0.1", "start": True, "username": "housefly"}


def site(mqtt: dict[str, Any], **home: Any) -> Site:
    return site_from_tree({"mqtt": mqtt, "homeassistant": {"enabled": True, **home}})


def test_it_is_off_and_shows_no_pictures_until_the_site_says_so() -> None:
    home = Site().homeassistant
    assert (home.enabled, home.pictures, home.answers, home.requests) == (
        *(False, False, False),
        "ask",
    )


def test_it_needs_a_broker() -> None:
    with pytest.raises(ConfigError, match=r"homeassistant\.enabled = true without mqtt\.broker"):
        site({})
    assert site(OPEN).homeassistant.enabled
    assert not site_from_tree({"homeassistant": {"answers": True}}).homeassistant.enabled


@pytest.mark.parametrize("more", [{"requests": "auto"}, {"answers": True}])
@pytest.mark.parametrize("mqtt", [OPEN, OWN])
def test_a_broker_that_asks_nobody_lets_nobody_fly_or_say_yes(
    mqtt: dict[str, Any], more: dict[str, Any]
) -> None:
    with pytest.raises(ConfigError, match=r"flies without a person's yes.*mqtt\.username"):
        site(mqtt, **more)
    assert site(GUARDED, **more).homeassistant.enabled


@pytest.mark.parametrize("prefix", ["", "a/b", "home#", "+"])
def test_a_prefix_is_one_level_of_a_topic(prefix: str) -> None:
    with pytest.raises(ConfigError, match="prefix"):
        site(OPEN, prefix=prefix)
