"""``housefly gains`` on the command line."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.cli import main


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
