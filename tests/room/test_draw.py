"""Drawings of the room: a picture that is one, and text that fits a terminal."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from housefly.config.site import changed, site_from_file
from housefly.errors import RoomError
from housefly.room.bsen import bsen
from housefly.room.draw import draw_room, text_map
from housefly.room.grid import build_grid

SITE = site_from_file(Path(__file__).parents[2] / "src" / "housefly" / "sites" / "bsen.toml")


@pytest.mark.parametrize("mode", ["default", "paper"])
def test_the_picture_changes_when_a_route_is_drawn(mode: str, tmp_path: Path) -> None:
    grid = build_grid(bsen(), changed(SITE, mode=mode))
    draw_room(bsen(), grid, tmp_path / "plain.png")
    draw_room(
        bsen(),
        grid,
        tmp_path / "route.png",
        route=((10.5, 1.2), (3.0, 4.2)),
        trail=((10.5, 1.3), (3.0, 4.3)),
    )
    plain, route = (
        np.asarray(Image.open(tmp_path / f"{name}.png").convert("RGB"), dtype=int)
        for name in ("plain", "route")
    )
    assert plain.shape[1] > 800
    assert plain.std() > 20
    # The legend has one more entry, so only the map's part of the picture is compared.
    assert np.any(np.abs(plain[100:-150] - route[100:-150]) > 60)


def test_a_folder_that_does_not_exist_is_named(tmp_path: Path) -> None:
    with pytest.raises(RoomError, match="nowhere"):
        draw_room(bsen(), build_grid(bsen(), SITE), tmp_path / "nowhere" / "map.png")


@pytest.mark.parametrize("mode", ["default", "paper"])
def test_the_text_map_fits_a_terminal_and_names_every_place(mode: str) -> None:
    text = text_map(bsen(), build_grid(bsen(), changed(SITE, mode=mode)))
    lines = text.splitlines()
    assert max(len(line) for line in lines) <= 120
    assert len(lines) <= 40
    assert all(place.name in lines[-1] for place in bsen().places)
    assert "E" in text
    assert "H" in text
    assert "v" in text
