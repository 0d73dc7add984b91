"""``housefly reproduce`` as a whole."""

from __future__ import annotations

import io
from contextlib import redirect_stdout
from importlib import resources
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
import pytest
from installed_chromium import chromium_path
from PIL import Image

from housefly.app import reproduction_run
from housefly.app.commands import reproduce
from housefly.app.console_camera import ConsoleCamera
from housefly.app.reproduction_flights import demanded_accelerations, read_service
from housefly.cli import main
from housefly.lab.reproduction import counterexamples
from housefly.lab.reproduction.counterexamples import COUNTEREXAMPLES
from housefly.lab.reproduction.fig12_loops import feedback_signals, forward_signals
from housefly.messages import Action, Phase
from housefly.pilot.control.laws import saturated_jointly, tilt
from housefly.record.truth import read_truth
from housefly.sites.loaded_site import open_site, read_site

pytestmark = pytest.mark.timeout(900)
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


DEAR_WORLDS = {"Kalman filter", "estimation is required", "immediate answer", "low frame rate"}
"""Fleets fly in these: ``lab/reproduction/test_counterexamples.py`` judges each."""


def flown_in(out: Path) -> tuple[Path, ...]:
    flights = [out / "flights" / mode / "flight.mcap" for mode in ("paper", "default")]
    return (*flights, *sorted((out / "batch").glob("*.npy")))


def quick_site(folder: Path) -> Path:
    """Return the paper's site with a quarter of the pilot's steps and of the tracking."""
    shipped = resources.files("housefly.sites").joinpath("bsen.toml").read_text(encoding="utf-8")
    text = shipped.replace("[twin]\n", "[control]\nrate_hz = 25\n[twin]\nmocap_rate_hz = 25\n")
    assert text != shipped
    (file := folder / "quick.toml").write_text(text, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return what two runs made: Ctrl-C ended the first one when all had been flown."""
    out = tmp_path_factory.mktemp("reproduction")
    line = ["reproduce", "--quick", "--no-wires", "--out", str(out), "--site", str(quick_site(out))]
    measure = reproduction_run.measure

    def stopped(*arguments: Any, **options: Any) -> NoReturn:
        measure(*arguments, **options)
        raise KeyboardInterrupt

    worlds = {key: world for key, world in COUNTEREXAMPLES.items() if key not in DEAR_WORLDS}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(reproduce, "_QUICK_SEEDS", 2)
        patch.setattr(counterexamples, "COUNTEREXAMPLES", worlds)
        patch.setattr("housefly.record.recorder.write_report", lambda *_: None)
        with pytest.MonkeyPatch.context() as inner:
            inner.setattr(reproduction_run, "measure", stopped)
            assert main(line) == 130
        assert not (out / "reproduction.html").exists()
        stamps = [path.stat().st_mtime_ns for path in flown_in(out)]
        with redirect_stdout(io.StringIO()) as said:
            assert main(line) == 0
    (out / "said.txt").write_text(said.getvalue())
    assert [path.stat().st_mtime_ns for path in flown_in(out)] == stamps, "flown again"
    return out


@pytest.mark.slow
@pytest.mark.interop
def test_every_figure_is_there_and_none_is_blank(made: Path) -> None:
    for stem in FIGURES:
        picture = np.asarray(Image.open(made / f"{stem}.png").convert("L"), dtype=float)
        assert picture.std() > 10, stem
        assert (made / f"{stem}.svg").stat().st_size > 5_000, stem


@pytest.mark.slow
@pytest.mark.interop
def test_the_page_shows_figures_claims_and_tables(made: Path) -> None:
    text = (made / "reproduction.html").read_text()
    for number in ("7", "10", "11", "12", "13", "15", "16", "17"):
        assert f"<h2>Fig. {number}: " in text
    assert text.count('class="claim"') > 40
    assert text.count("<h2>Table ") == 10
    assert "10 to 100 frames per second cause unstable behaviors in some cases" in text
    assert "housefly reproduce --seed 1 --quick --no-wires" in text


@pytest.mark.slow
@pytest.mark.interop
def test_without_wires_no_picture_is_said_to_be_received(made: Path) -> None:
    text = (made / "reproduction.html").read_text()
    assert "On a stepped clock there is neither page nor camera" in text
    assert "as received" not in text and "no picture received" not in text
    strip = np.asarray(Image.open(made / "fig17.png").convert("L"), dtype=float)
    assert strip[:, strip.shape[1] // 2 :].std() > 20


@pytest.mark.slow
@pytest.mark.interop
def test_the_flights_of_a_run_that_was_stopped_are_kept_and_the_next_one_flies_none(
    made: Path,
) -> None:
    paper, default, *blocks = flown_in(made)
    assert all(path.stat().st_size > 100_000 for path in (paper, default)) and blocks
    said = (made / "said.txt").read_text()
    assert said.splitlines()[0].startswith("reproducing the paper into ")
    for mode in ("paper", "default"):
        assert f"service in mode {mode}: kept from an earlier run" in said
    assert (made / "reproduction.html").exists()


@pytest.mark.slow
@pytest.mark.interop
def test_the_demanded_acceleration_is_the_controllers_and_the_position_is_true(
    made: Path,
) -> None:
    loaded = open_site(read_site(str(made / "quick.toml"), twin__seed=1, map__planner="grid"))
    service = read_service(loaded, made / "flights" / "default")
    flight = service.flight
    demanded = demanded_accelerations(loaded, flight.steps)
    for step, wanted in zip(flight.steps, demanded, strict=True):
        sent = step.outputs.command
        if sent.action is not Action.FLY or np.isnan(wanted).any():
            continue
        assert step.outputs.estimate is not None
        yaw, gain = step.outputs.estimate.yaw, loaded.site.drone.attitude_gain
        theta, phi = tilt(float(wanted[0]), float(wanted[1]), yaw, gain)
        asked = saturated_jointly(theta, phi, loaded.site.limits.tilt_max)
        assert (sent.setpoint.theta, sent.setpoint.phi) == pytest.approx(asked, abs=1e-9)
    start = float(flight.at[flight.during(Phase.OUTBOUND)][0])
    *_, last = forward_signals(flight, demanded, start)
    assert last.name == "true x [m]"
    truth = read_truth(made / "flights" / "default" / "truth.jsonl")
    assert truth is not None
    at = truth.time - flight.steps[0].now
    shown = np.interp(last.curves[0].at + start, at, truth.position[:, 0])
    assert last.curves[0].values == pytest.approx(shown, abs=1e-6)
    seen, estimated = feedback_signals(flight, start)
    noise = seen.curves[0].values
    assert 0.5 < noise.std() < 2.0, "tracking differs from the truth by its noise [mm]"
    assert "true" in seen.name and "filter" in estimated.name


def test_a_bad_seed_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reproduce", "--seed", "-1", "--out", str(tmp_path)]) == 2
    assert "--seed: is -1; allowed: a number from 0" in capsys.readouterr().err


@pytest.mark.wire
@pytest.mark.browser
@pytest.mark.slow
@pytest.mark.interop
def test_one_service_is_flown_over_real_wires_and_photographed(tmp_path: Path) -> None:
    assert chromium_path()
    assert main(["reproduce", "--quick", "--out", str(tmp_path)]) == 0
    text = (tmp_path / "reproduction.html").read_text()
    assert "One service over real wires (completed" in text
    assert "photographs of the page in Chromium" in text
    assert (tmp_path / "flights" / "wires" / "video.mp4").stat().st_size > 500_000
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        browser = play.chromium.launch(
            executable_path=chromium_path(), args=["--no-sandbox", "--disable-gpu"]
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
