"""The paper's figures: drawn from what flies, complete, the same for the same data."""

from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from housefly.config.site import Site, changed
from housefly.lab.reproduction import fig07_grid, fig10_acceptor, fig17_service, page
from housefly.lab.reproduction.exhibit import ClaimFinding, Exhibit, Table, Verdict
from housefly.lab.reproduction.fig10_acceptor import transitions
from housefly.messages import Behavior
from housefly.pilot.behavior.acceptor import STATES, TABLE
from housefly.room.files import load_room
from housefly.room.grid import Cell, OccupancyGrid, build_grid


@pytest.fixture(scope="module")
def grid(site: Site) -> OccupancyGrid:
    return build_grid(load_room("bsen"), changed(site, mode="paper"))


def pixels(path: Path) -> np.ndarray:
    return np.asarray(Image.open(path).convert("RGB"), dtype=float)


def test_the_grid_is_drawn_with_the_drone_and_its_cells_counted(
    grid: OccupancyGrid, tmp_path: Path
) -> None:
    with_drone = fig07_grid.draw_fig07(tmp_path, grid, (10.55, 1.25))
    first = (tmp_path / "fig07.png").read_bytes()
    assert "25 x 9 = 225" in with_drone.caption
    counted = [int(n) for n in re.findall(r"(\d+) (?:blocked|behind|free)", with_drone.caption)]
    assert len(counted) == 4 and sum(counted) == grid.cells.size
    assert counted[-1] == (grid.cells == Cell.FREE).sum()
    fig07_grid.draw_fig07(tmp_path, grid, (5.0, 3.0))
    assert (tmp_path / "fig07.png").read_bytes() != first
    fig07_grid.draw_fig07(tmp_path, grid, (10.55, 1.25))
    assert (tmp_path / "fig07.png").read_bytes() == first
    assert pixels(tmp_path / "fig07.png").std() > 20


def test_the_acceptor_has_an_edge_exactly_where_the_table_has_one() -> None:
    drawn = {(state, target) for state, target, _ in transitions()}
    table = {
        (STATES[i], STATES[TABLE[i, bits]])
        for i in range(len(STATES))
        for bits in range(TABLE.shape[1])
    }
    assert drawn == table


def test_a_table_without_a_transition_is_drawn_without_its_arrow(tmp_path: Path) -> None:
    fig10_acceptor.draw_fig10(tmp_path)
    whole = (tmp_path / "fig10.svg").read_text()
    broken = TABLE.copy()
    yaw, hover = STATES.index(Behavior.YAW_CONTROL), STATES.index(Behavior.HOVER)
    broken[yaw][broken[yaw] == hover] = yaw
    exhibit = fig10_acceptor.draw_fig10(tmp_path, broken)
    assert "11 transitions" in exhibit.caption
    assert len((tmp_path / "fig10.svg").read_text()) < len(whole)
    assert (Behavior.YAW_CONTROL, Behavior.HOVER) not in {
        (state, target) for state, target, _ in transitions(broken)
    }


class Links(HTMLParser):
    """Collects what the page refers to, and complains about tags that are never closed."""

    def __init__(self) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.targets += [value or "" for name, value in attrs if name in ("href", "src")]
        if tag not in ("img", "meta", "br", "link"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_the_page_holds_everything_and_needs_nobody(tmp_path: Path) -> None:
    exhibit = fig10_acceptor.draw_fig10(tmp_path)
    findings = tuple(
        ClaimFinding(f"key {n}", "V-B", f"claim <{n}>", verdict, f"because of {n} & more", ("10",))
        for n, verdict in enumerate(Verdict)
    )
    table = Table("How far?", ("mode", "error [cm]"), (("paper", "4.2 ± 0.1"),), "of 100 drones")
    path = page.write_page(
        tmp_path, (exhibit,), (table,), findings, page.RunNotes((("made by", "a test"),))
    )
    text = path.read_text()
    reader = Links()
    reader.feed(text)
    assert not reader.open
    assert all(
        re.match(r"data:image/png;base64,|fig10\.(png|svg)$", target) for target in reader.targets
    ), reader.targets
    for words in (
        "4.2 ± 0.1",
        "claim &lt;2&gt;",
        "because of 3 &amp; more",
        "holds with a condition",
        "Fig. 10",
    ):
        assert words in text
    assert isinstance(exhibit, Exhibit)
    assert 'class="notice"' not in text


def test_what_was_not_flown_as_wanted_is_told_first_and_beside_its_figure(tmp_path: Path) -> None:
    exhibit = replace(fig10_acceptor.draw_fig10(tmp_path), notice="a stand-in <flight>")
    made = page.RunNotes((("made by", "a test"),), ("no flight over wires & why",))
    text = page.write_page(tmp_path, (exhibit,), (), (), made).read_text()
    first, second = (m.start() for m in re.finditer('class="notice"', text))
    assert first < text.index("no flight over wires &amp; why") < text.index('id="fig10"') < second
    assert "a stand-in &lt;flight&gt;" in text[second:]


@pytest.mark.parametrize("over_wires", [True, False])
def test_only_a_flight_over_wires_has_a_column_of_camera_pictures(
    tmp_path: Path, over_wires: bool
) -> None:
    grey = np.full((90, 160, 3), 128, np.uint8)
    moments = tuple(
        fig17_service.Moment(title, 5.0 * n, grey, grey if over_wires else None)
        for n, title in enumerate(("taking off", "on the way", "landing"))
    )
    exhibit = fig17_service.draw_fig17(
        tmp_path, moments, "completed", False, over_wires=over_wires, notice="why"
    )
    assert ("as received" in exhibit.caption) is over_wires and exhibit.notice == "why"
    written = (tmp_path / "fig17.svg").read_text()
    assert written.count("<image") == (6 if over_wires else 3)
    assert "no picture received" not in written
