"""The report is one file that shows a flight to a person."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from installed_chromium import chromium_path
from playwright.sync_api import sync_playwright

from housefly.config.site import Site
from housefly.messages import PilotStep, PlannedTrajectory, TrajectoryPoint
from housefly.record.report import write_report
from housefly.record.series import collect
from housefly.record.summary import summarize_flight
from housefly.room.grid import OccupancyGrid
from housefly.room.model import Room
from housefly.theme import DARK, LIGHT


@pytest.fixture(scope="module")
def report(
    tmp_path_factory: pytest.TempPathFactory,
    site: Site,
    room: Room,
    grid: OccupancyGrid,
    flight: tuple[PilotStep, ...],
) -> Path:
    path = tmp_path_factory.mktemp("report") / "report.html"
    series = collect(flight, "ardrone")
    write_report(
        path, series, summarize_flight(series, "completed", site, room, grid), site, room, grid
    )
    return path


class Addresses(HTMLParser):
    """Collects whatever a browser might fetch."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found += [
            value or ""
            for name, value in attrs
            if name in ("src", "href", "xlink:href", "srcset", "data")
        ]


def test_the_report_asks_for_nothing_from_elsewhere(report: Path) -> None:
    text = report.read_text()
    parser = Addresses()
    parser.feed(text)
    assert [address for address in parser.found if not address.startswith("#")] == []
    assert re.findall(r"url\((?!#)", text) == []
    assert "@import" not in text
    assert "<script" not in text


def test_the_report_shows_every_plot_and_number(report: Path) -> None:
    text = report.read_text()
    assert text.count('role="img"') == text.count("</svg>") == 6
    for words in (
        "completed",
        "small room",
        "path error, rms",
        "landing error",
        "23.0 <small>s",
        "Entrance",
        "pathTracking",
    ):
        assert words in text


def test_words_of_a_flight_cannot_become_markup(report: Path) -> None:
    text = report.read_text()
    assert "&lt;entrance&gt; &amp; back" in text
    assert "<entrance>" not in text


def test_all_colours_come_from_the_style_sheet(report: Path) -> None:
    plots = report.read_text().split("</style>", 1)[1]
    assert re.findall(r"(?:fill|stroke): #[0-9a-f]{6}", plots) == []
    assert "DejaVu" not in plots
    assert plots.count('class="plot"') == plots.count('class="plot" tabindex="0"'), "keys scroll"


def test_ids_of_the_plots_do_not_collide(report: Path) -> None:
    plots = re.findall(r"<svg.*?</svg>", report.read_text(), flags=re.DOTALL)
    used = [set(re.findall(r'<(?:clipPath|path) id="([^"]+)"', plot)) for plot in plots]
    shared = [names & others for index, names in enumerate(used) for others in used[index + 1 :]]
    assert not any(name.startswith("p") for names in shared for name in names), (
        "clip paths are per plot"
    )


def test_curves_in_space_are_shown_with_their_heights_and_colours_of_speed(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid, flight: tuple[PilotStep, ...]
) -> None:
    paths = {step.outputs.path for step in flight if step.outputs.path}
    planned = [
        PlannedTrajectory(
            0.0,
            tuple(
                TrajectoryPoint((x, y, 1.0 + 0.2 * k), 3.0 * k, 0.5 * k)
                for k, (x, y) in enumerate(path.waypoints)
            ),
        )
        for path in paths
    ]
    series = collect(flight, "ardrone", planned)
    assert [len(points) for points in series.planned] == [3, 3]
    summary = summarize_flight(series, "completed", site, room, grid)
    write_report(tmp_path / "report.html", series, summary, site, room, grid)
    text = (tmp_path / "report.html").read_text()
    assert "Height along the way" in text and "planned 0.8 to 1.0 m/s" in text
    slow, fast = "var(--v1)", "var(--v3)"
    assert slow in text and fast in text, "the legs have 0.25 and 0.75 m/s of at most 1.0"
    assert text.count('role="img"') == 7


def test_a_recording_without_a_single_step_still_has_a_report(
    tmp_path: Path, site: Site, room: Room, grid: OccupancyGrid
) -> None:
    empty = collect((), "ardrone")
    write_report(
        tmp_path / "report.html",
        empty,
        summarize_flight(empty, "the pilot did not start", site, room, grid),
        site,
        room,
        grid,
    )
    text = (tmp_path / "report.html").read_text()
    assert "the pilot did not start" in text
    assert "Nothing was reported" in text


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    path = chromium_path()
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
        yield chromium
        chromium.close()


@pytest.mark.browser
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [1280, 390])
def test_a_browser_shows_the_report_without_errors_or_requests(
    report: Path, browser: Any, scheme: str, width: int
) -> None:
    page = browser.new_page(color_scheme=scheme, viewport={"width": width, "height": 800})
    requests: list[str] = []
    problems: list[str] = []
    page.on("request", lambda request: requests.append(request.url))
    page.on("console", lambda message: problems.append(message.text))
    page.goto(report.as_uri())
    assert requests == [report.as_uri()]
    assert problems == []
    assert page.locator("svg").count() == 6
    assert page.evaluate("document.documentElement.scrollWidth") <= width, (
        "only the plots scroll sideways"
    )
    paper, ink = page.evaluate(
        "[getComputedStyle(document.body).backgroundColor, getComputedStyle(document.body).color]"
    )
    brightness = [sum(map(int, re.findall(r"\d+", colour)[:3])) for colour in (paper, ink)]
    assert (brightness[0] > brightness[1]) == (scheme == "light")
    line = page.locator("svg path[style*='--accent']").first.evaluate(
        "node => getComputedStyle(node).stroke"
    )
    themes = (LIGHT, DARK)
    assert line in [f"rgb{tuple(bytes.fromhex(theme.accent[1:]))}" for theme in themes]
    page.close()
