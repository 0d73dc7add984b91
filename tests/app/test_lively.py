"""The changes that make the demo lively are those of a site that can be loaded."""

from __future__ import annotations

from housefly.app.lively import lively_changes
from housefly.app.loaded_site import load_site


def test_every_scanner_hangs_in_the_room_above_beds_and_chairs_and_below_the_drone() -> None:
    loaded = load_site("bsen", **lively_changes())
    x_min, y_min, x_max, y_max = loaded.room.bounds
    assert len(loaded.site.lasers) == len(lively_changes()["lasers"]) > 0
    for laser in loaded.site.lasers:
        assert x_min < laser.x < x_max and y_min < laser.y < y_max
        assert 0.8 < laser.z < loaded.site.map.flight_height


def test_somebody_lives_there_and_the_broker_is_its_own() -> None:
    site = load_site("bsen", **lively_changes()).site
    assert site.twin.scene == "bsen"
    assert site.mqtt.start and site.mqtt.broker == "127.0.0.1"
    assert load_site("bsen").site.twin.scene != "bsen"
