"""Drawings of the room: a picture that is one, and text that fits a terminal."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from housefly.config.site import changed, site_from_file
from housefly.errors import RoomError
from housefly.room.bsen import bsen
from housefly.room.draw import draw_room, text_map
from housefly.room.grid import Cell, build_grid
from housefly.room.model import Place

SITE = site_from_file(Path(__file__).parents[2] / "src" / "housefly" / "sites" / "bsen.toml")
GRID = build_grid(bsen(), SITE)


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
    assert max(len(line) for line in lines[:-1]) <= 80
    assert len(lines) <= 40
    assert all(place.name in lines[-1] for place in bsen().places)
    assert "E" in text
    assert "H" in text
    assert "v" in text


@pytest.mark.parametrize(
    ("mode", "scale"), [("default", "0.2 m across, 0.4"), ("paper", "0.25 m across, 0.5")]
)
def test_the_text_map_says_how_large_a_character_is(mode: str, scale: str) -> None:
    grid = build_grid(bsen(), changed(SITE, mode=mode))
    text = text_map(bsen(), grid)
    assert f"one character: {scale} m up" in text
    rows = text.split("\n\n")[0].splitlines()
    across = float(scale.split()[0])
    width = grid.resolution * grid.shape[0]
    assert max(map(len, rows)) * across == pytest.approx(width, abs=3 * across)


@given(st.integers(2, 400), st.integers(2, 400))
def test_a_text_map_of_any_room_fits_a_terminal_in_proportion(nx: int, ny: int) -> None:
    grid = replace(GRID, cells=np.full((nx, ny), Cell.OCCUPIED, dtype=np.int8))
    rows = text_map(replace(bsen(), places=()), grid).split("\n\n")[0].splitlines()
    across, up = max(map(len, rows)), len(rows)
    assert across <= 80 and up <= 51
    assert across / nx == pytest.approx(2.0 * up / ny, abs=4.0 / min(nx, ny))


def test_the_text_map_shows_a_route_from_its_start_to_its_end() -> None:
    route = ((10.55, 1.25), (10.55, 4.25), (3.05, 4.25))
    plain, drawn = text_map(bsen(), GRID), text_map(bsen(), GRID, route)
    assert "* path" in drawn and "*" not in plain
    changed_ = [(a, b) for a, b in zip(plain, drawn, strict=False) if b == "*"]
    assert len(changed_) > 35 and "H" in drawn and "E" in drawn
    for a, b in zip(plain.splitlines()[:-3], drawn.splitlines()[:-3], strict=True):
        assert all(one == two or two == "*" for one, two in zip(a, b, strict=True))


@given(
    st.lists(
        st.sampled_from(["home", "table", "tv", "tea", "vent", "1", "e t", "хата", "h"]),
        unique=True,
    )
)
def test_no_two_places_share_a_sign_and_home_is_h(names: list[str]) -> None:
    places = tuple(
        Place(name, (10.5 + 0.3 * i, 1.2), (0.0, 0.0, 0.0)) for i, name in enumerate(names)
    )
    legend = text_map(replace(bsen(), places=places), GRID).splitlines()[-1] if names else ""
    entries = (entry.split(" ", 1) for entry in legend.split("  ") if entry)
    signs = {name: sign for sign, name in entries}
    assert sorted(signs) == sorted(names)
    assert len(set(signs.values())) == len(names)
    assert signs.get("home", "H") == "H"
