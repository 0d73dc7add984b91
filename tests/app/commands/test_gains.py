"""``housefly gains`` on the command line."""

from __future__ import annotations

import re
import subprocess
import sys
from contextlib import redirect_stdout
from functools import cache
from io import StringIO
from pathlib import Path

import pytest

from housefly.app.public.gains import judge_gains
from housefly.cli import main
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind
from housefly.sites.loaded_site import LoadedSite, load_site


@cache
def lines_for(rate: str, latency: str) -> str:
    """Return what the command prints for a site file."""
    with redirect_stdout(StringIO()) as said:
        assert main(["gains", "--rate", rate, "--latency", latency]) == 0
    _, _, after = said.getvalue().partition("for the site file:\n")
    return "".join(
        f"{line}\n" for line in after.splitlines() if line.startswith("[") or " = " in line
    )


def site_with(lines: str, folder: Path) -> LoadedSite:
    file = folder / "advised.toml"
    file.write_text(lines)
    return load_site(str(file))


@pytest.mark.interop
def test_the_advice_for_five_frames_a_second_flies_with_the_lines_it_comes_with(
    tmp_path: Path,
) -> None:
    lines = lines_for("5", "0.1")
    assert "pose_age_level = 0.55" in lines
    advised = site_with(lines, tmp_path)
    assert advised.site.twin.mocap_rate_hz == 5.0
    order = Order(OrderKind.SERVICE, "table", look_s=0.0)
    contacts = list[object]()
    outcome = fly_lockstep(
        advised, order, lambda step: None, on_world=lambda world: contacts.extend(world.contact_log)
    )
    assert outcome == "completed" and not contacts


@pytest.mark.interop
def test_without_the_advised_limits_the_refusal_names_the_age_of_the_pose(
    tmp_path: Path,
) -> None:
    lines = lines_for("5", "0.1").replace("pose_age_level = 0.55\n", "")
    order = Order(OrderKind.SERVICE, "table", look_s=0.0)
    outcome = fly_lockstep(site_with(lines, tmp_path), order, lambda step: None)
    assert re.search(r"refused: tracking shows the drone as it was 0\.\d+ s ago", outcome)
    assert "limits.pose_age_level: 0.25 s" in outcome and "does not see" not in outcome


def test_tracking_that_is_fast_enough_needs_no_other_limits() -> None:
    lines = lines_for("50", "0.02")
    assert "[limits]" not in lines and "mocap_rate_hz = 50" in lines


@pytest.mark.parametrize("rate", ["5", "10", "30"])
def test_what_it_writes_is_what_it_judged(rate: str, tmp_path: Path) -> None:
    loaded = site_with(lines_for(rate, "0.1"), tmp_path)
    judged = judge_gains(loaded)
    assert judged.objections == ()
    assert loaded.site.limits.pose_age_level > 0.1 + 2.0 / float(rate)


def test_a_drone_described_by_hand_is_described_in_the_lines(
    capsys: pytest.CaptureFixture[str],
) -> None:
    hand = ["--c", "4.5", "--lambda", "5", "--delay", "0.1", "--drag", "0.3", "--tilt-max", "0.15"]
    assert main(["gains", *hand]) == 0
    output = capsys.readouterr().out
    for line in (
        "attitude_lag = 5", "attitude_gain = 0.9", "command_delay = 0.1", "drag = 0.3",
        "tilt_max = 0.15",
    ):  # fmt: skip
        assert f"\n{line}\n" in output


def test_it_says_what_the_pilot_does_not_know_of_the_delay(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["gains", "--alpha", "3.6", "--beta", "3.24"]) == 0
    output = " ".join(capsys.readouterr().out.split())
    assert "delay 75 ms in all, of which the pilot knows 60 ms" in output


def test_it_recommends_and_draws(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gains", "--rate", "30", "--latency", "0.05", "--out", str(tmp_path)]) == 0
    output = capsys.readouterr().out
    for words in (
        "tracking: 30 Hz, 50 ms late",
        "as identified",
        "lambda +40 %",
        "K1 (yaw)",
        "[control]",
        "alpha = ",
    ):
        assert words in output
    assert (tmp_path / "gains.png").stat().st_size > 20_000
    assert (tmp_path / "gains.svg").stat().st_size > 5_000


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (
            ["--alpha", "1", "--beta", "7"],
            1,
            "refused: beta (7 1/s^2) is not below lambda * alpha (7 1/s^2)",
        ),
        (
            ["--alpha", "12", "--beta", "36", "--rate", "10", "--latency", "0.1"],
            1,
            "objection: gain margin",
        ),
        (["--alpha", "3.6", "--beta", "3.24"], 0, "alpha 3.6 1/s, beta 3.24 1/s^2"),
        (
            ["--c", "5", "--lambda", "5", "--delay", "0.1", "--mode", "paper", "--jitter", "0.01"],
            0,
            "30 ms late",
        ),
    ],
)
def test_a_pair_is_judged(
    arguments: list[str], code: int, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["gains", *arguments]) == code
    assert words in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--rate", "1000"], "--rate: is 1000; allowed: a number from 5 to 400 Hz"),
        (["--lambda", "nan"], "--lambda: is nan; allowed: a number from 0.5 to 50 1/s"),
        (["--alpha", "3"], "give both or none"),
    ],
)
def test_a_bad_option_is_named_with_range_and_unit(
    arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["gains", *arguments]) == 2
    assert words in capsys.readouterr().err


_FIRST_WORD = """
import sys
from housefly.app.terminal import console
def told(*words, **how):
    sys.exit(3 if "numba" in sys.modules or "numpy" in sys.modules else 0)
console.print = told
from housefly.cli import main
main(sys.argv[1:])
"""


@pytest.mark.parametrize("command", [["gains"], ["identify", "--lockstep"]])
def test_the_first_words_come_before_anything_heavy_is_loaded(
    command: list[str], tmp_path: Path
) -> None:
    line = [sys.executable, "-c", _FIRST_WORD, *command]
    assert subprocess.run(line, cwd=tmp_path, check=False, timeout=60).returncode == 0
