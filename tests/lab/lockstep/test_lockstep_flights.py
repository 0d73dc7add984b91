"""Whole services on a stepped clock, through the command line."""

import json
from collections.abc import Callable
from importlib import resources
from pathlib import Path

import pytest
from mcap.reader import make_reader

from housefly.cli import main

Fly = Callable[..., Path]
SHIPPED = resources.files("housefly.sites").joinpath("bsen.toml").read_text(encoding="utf-8")
QUICK = "[control]\nrate_hz = 50\n[twin]\nmocap_rate_hz = 25\n"
QUICKER = QUICK.replace("50", "25")
"""For what holds of any flight, however it is flown."""


def fly(out: Path, *arguments: str) -> dict[str, object]:
    code = main(
        [
            "fly",
            *(arguments or ("entrance",)),
            "--headless",
            "--lockstep",
            "--look",
            "2",
            "--out",
            str(out),
        ]
    )
    summary: dict[str, object] = json.loads((out / "summary.json").read_text())
    assert (code == 0) == (summary["outcome"] == "completed")
    return summary


def summary_of(out: Path) -> dict[str, object]:
    summary: dict[str, object] = json.loads((out / "summary.json").read_text())
    return summary


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Fly:
    """Return what gives the folder of a flight with these arguments, which is flown only once."""
    folders: dict[tuple[str, ...], Path] = {}

    def folder_of(*arguments: str) -> Path:
        if arguments not in folders:
            folders[arguments] = tmp_path_factory.mktemp("flown")
            fly(folders[arguments], *arguments)
        return folders[arguments]

    return folder_of


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rate", "seed"),
    [
        (100, 1),
        (10, 2),
        *(
            pytest.param(*case, marks=pytest.mark.safety)
            for case in ((100, 2), (30, 1), (30, 2), (10, 1))
        ),
    ],
)
def test_the_service_is_completed_at_every_tracking_rate(
    flown: Fly, tmp_path: Path, rate: int, seed: int
) -> None:
    # The shipped steps at the shipped rate, half of them where tracking is slow.
    site = () if rate == 100 else ("--site", str(quick(tmp_path)))
    rates = ("--mocap-rate", str(rate), "--seed", str(seed))
    summary = summary_of(flown("entrance", *rates, *site))
    assert summary["outcome"] == "completed"
    assert summary["seed"] == seed
    assert abs(float(str(summary["mocap_rate_hz"])) - rate) < 0.1 * rate
    assert float(str(summary["rms_error_m"])) < 0.12
    assert float(str(summary["arrival_error_m"])) < 0.25
    assert float(str(summary["landed_error_m"])) < 0.35
    assert float(str(summary["min_clearance_m"])) > 0.0


def quick(folder: Path, shipped: str = SHIPPED, rates: str = QUICK) -> Path:
    """Return a site file with half the steps of the pilot and a quarter of the tracking."""
    text = shipped.replace("[twin]\n", rates)
    assert text != shipped
    (file := folder / "site.toml").write_text(text, encoding="utf-8")
    return file


@pytest.mark.interop
@pytest.mark.slow
@pytest.mark.usefixtures("no_report")
def test_the_same_seed_gives_the_same_flight_and_another_seed_another(tmp_path: Path) -> None:
    site = str(quick(tmp_path, rates=QUICKER))
    first, again, other = (
        fly(tmp_path / str(number), "tv", "--seed", seed, "--site", site)
        for number, seed in enumerate("113")
    )
    assert first == again
    assert {**first, "seed": 3} != other


@pytest.mark.slow
def test_a_replay_of_the_recording_gives_the_same_commands(
    flown: Fly, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["replay", str(flown("entrance", "--mocap-rate", "100", "--seed", "1"))]) == 0
    assert "bit for bit" in capsys.readouterr().out


@pytest.mark.slow
def test_the_recording_holds_ros_2_types_that_the_mcap_library_reads(flown: Fly) -> None:
    out = flown("entrance", "--mocap-rate", "100", "--seed", "1")
    with (out / "flight.mcap").open("rb") as stream:
        summary = make_reader(stream).get_summary()
    assert summary is not None
    schemas = {schema.name for schema in summary.schemas.values()}
    assert {
        "geometry_msgs/msg/PoseStamped",
        "nav_msgs/msg/Odometry",
        "nav_msgs/msg/Path",
        "sensor_msgs/msg/BatteryState",
    } <= schemas
    assert (out / "report.html").stat().st_size > 10_000


@pytest.mark.interop
@pytest.mark.slow
@pytest.mark.usefixtures("no_report")
def test_the_paper_mode_flies_the_service_too(tmp_path: Path) -> None:
    site = quick(tmp_path)
    summary = fly(tmp_path / "out", "tv", "--mode", "paper", "--site", str(site))
    assert summary["mode"] == "paper"
    assert summary["outcome"] == "completed"


def test_an_unknown_place_is_refused_with_the_known_ones(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["fly", "cellar", "--headless", "--lockstep", "--out", str(tmp_path)]) == 2
    assert "entrance" in capsys.readouterr().err


@pytest.mark.interop
@pytest.mark.slow
@pytest.mark.usefixtures("no_report")
@pytest.mark.parametrize(
    ("name", "place"),
    [("small_house", "east"), pytest.param("turtlebot3", "far", marks=pytest.mark.safety)],
)
def test_strangers_maps_are_imported_and_flown(
    tmp_path: Path, shared_data: Path, name: str, place: str
) -> None:
    map_file = shared_data / "rooms" / name / "map.yaml"
    assert main(["room", "import", str(map_file), "--out", str(tmp_path / "room")]) == 0
    site = quick(tmp_path / "room", (tmp_path / "room" / "site.toml").read_text(encoding="utf-8"))
    summary = fly(tmp_path / "out", place, "--site", str(site.parent))
    assert summary["outcome"] == "completed"
