"""The catalogue file: read, checked, refused in words."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

from housefly.errors import ConfigError
from housefly.geometry import yaw_of
from housefly.hub.things.catalogue import catalogue_from_toml, load_catalogue
from housefly.hub.things.thing import NamedPose, Thing, ThingKind

GOOD = """
[[thing]]
id = "cup"
name = "the red cup"
aliases = ["mug"]
inside = "cabinet"

[[thing]]
id = "cabinet"
kind = "furniture"
position = [2, 1.5, 0.9]
yaw = 1.5
viewpoints = [{ name = "front", position = [2.0, 0.5, 1.2], yaw = 1.57, robot = "ardrone" }]
facts = { doors = 2, locked = false, maker = "oak & sons" }
"""


def test_a_catalogue_becomes_things(tmp_path: Path) -> None:
    path = tmp_path / "things.toml"
    path.write_text(GOOD)
    cup, cabinet = load_catalogue(path)
    assert cup == Thing("cup", "the red cup", ThingKind.OBJECT, ("mug",), inside="cabinet")
    assert (cabinet.name, cabinet.kind, cabinet.position) == (
        "cabinet",
        ThingKind.FURNITURE,
        (2.0, 1.5, 0.9),
    )
    assert cabinet.orientation is not None and yaw_of(cabinet.orientation) == pytest.approx(1.5)
    assert cabinet.viewpoints == (NamedPose("front", (2.0, 0.5, 1.2), 1.57, 0.0, "ardrone"),)
    assert cabinet.facts == (("doors", 2.0), ("locked", False), ("maker", "oak & sons"))
    assert cabinet.viewpoints[0].yaw < pi / 2


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        (
            "[[thing]]\nid='a'\nkind='animal'",
            "house: thing 1.kind: is 'animal'; input should be 'person', 'robot'",
        ),
        (
            "[[thing]]\nid='a'\nposition=[0, 0, 9999]",
            "house: thing 1.position 3: is 9999; input should be less than or equal",
        ),
        ("[[thing]]\nid='a'\nposition=[0, 0]", "house: thing 1.position 3: is missing"),
        ("[[thing]]\nid='A cup'", "house: thing 1.id: is 'A cup'; string should match pattern"),
        ("[[thing]]\nname='x'", "house: thing 1.id: is missing"),
        ("[[thing]]\nid='a'\ncolour='red'", "house: thing 1.colour: is not a known key"),
        (
            "[[thing]]\nid='a'\n[[thing]]\nid='a'",
            "house: thing 2.id: is 'a', as another thing's; every id is given once",
        ),
        (
            "[[thing]]\nid='a'\ninside='b'",
            "house: thing 1.inside: is 'b'; allowed: the id of a thing in this file",
        ),
        (
            "[[thing]]\nid='a'\ninside='a'",
            "house: thing.inside: a is in a: a thing cannot be inside itself",
        ),
        ("[[thing", "house: catalogue: cannot be parsed"),
    ],
)
def test_a_bad_catalogue_is_refused_in_words(text: str, answer: str) -> None:
    with pytest.raises(ConfigError) as refused:
        catalogue_from_toml(text, "house")
    assert str(refused.value).startswith(answer)


def test_an_absent_catalogue_is_refused_in_words(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="catalogue: cannot be read"):
        load_catalogue(tmp_path / "none.toml")
