"""``housefly reproduce`` as a whole."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from housefly.app.console_camera import ConsoleCamera
from housefly.cli import main

FIGURES = (
    "fig07",
    "fig10",
    "fig11",
    "fig12",
    "fig13",
    "fig15",
    "fig16",
    "fig17",
    "stability_by_rate",
    "distance_by_rate",
)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("reproduction")
    assert main(["reproduce", "--quick", "--no-wires", "--out", str(out)]) == 0
    return out


@pytest.mark.slow
def test_every_figure_is_there_and_none_is_blank(made: Path) -> None:
    for stem in FIGURES:
        picture = np.asarray(Image.open(made / f"{stem}.png").convert("L"), dtype=float)
        assert picture.std() > 10, stem
        assert (made / f"{stem}.svg").stat().st_size > 5_000, stem


@pytest.mark.slow
def test_the_page_shows_figures_claims_and_tables(made: Path) -> None:
    text = (made / "reproduction.html").read_text()
    for number in ("7", "10", "11", "12", "13", "15", "16", "17"):
        assert f"<h2>Fig. {number}: " in text
    assert text.count('class="claim"') > 40
    assert text.count("<h2>Table ") == 10
    assert "Only where frames are held and differentiated" in text
    assert "housefly reproduce --seed 1 --quick --no-wires" in text


@pytest.mark.slow
def test_the_flights_behind_it_are_kept(made: Path) -> None:
    for mode in ("paper", "default"):
        assert (made / "flights" / mode / "flight.mcap").stat().st_size > 100_000


def test_a_bad_seed_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reproduce", "--seed", "-1", "--out", str(tmp_path)]) == 2
    assert "--seed: is -1; allowed: a number from 0" in capsys.readouterr().err


@pytest.mark.wire
@pytest.mark.browser
@pytest.mark.slow
@pytest.mark.interop
@pytest.mark.timeout(300)
def test_one_service_is_flown_over_real_wires_and_photographed(tmp_path: Path) -> None:
    assert shutil.which("chromium")
    assert main(["reproduce", "--quick", "--out", str(tmp_path)]) == 0
    text = (tmp_path / "reproduction.html").read_text()
    assert "One service over real wires (completed" in text
    assert "photographs of the page in Chromium" in text
    assert (tmp_path / "flights" / "wires" / "video.mp4").stat().st_size > 500_000
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        browser = play.chromium.launch(
            executable_path=shutil.which("chromium"), args=["--no-sandbox", "--disable-gpu"]
        )
        for width in (1280, 390):
            page = browser.new_page(viewport={"width": width, "height": 844})
            page.goto((tmp_path / "reproduction.html").as_uri())
            assert page.evaluate("document.documentElement.scrollWidth") == width
        browser.close()


def test_without_a_browser_nothing_is_photographed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("shutil.which", lambda name: None)
    with ConsoleCamera("http://127.0.0.1:9/") as camera:
        camera.shoot("nothing")
        assert not camera.available
    assert camera.pictures() == {}
