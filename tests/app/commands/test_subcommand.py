"""A slip of the pen on the command line is answered with what may have been meant."""

from __future__ import annotations

import pytest

from housefly.cli import main


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ("flyy", "no command 'flyy': did you mean 'fly'? `housefly --help` lists all"),
        ("zzz", "no command 'zzz'; `housefly --help` lists all"),
        ("room shwo", "no command 'shwo': did you mean 'show'?"),
        ("fly sofa --lokstep", "unknown argument '--lokstep': did you mean '--lockstep'?"),
        ("plan --to sofa --mode papr", "is 'papr': did you mean 'paper'?"),
        ("plan --to sofa --mode x", "is 'x'; allowed: default, paper"),
        ("run --site bsn", "no site of that name is shipped: did you mean 'bsen'?"),
        ("fly kithcen --lockstep", "no place called 'kithcen': did you mean 'kitchen'?"),
    ],
)
def test_what_is_not_known_is_answered_with_what_may_be_meant(
    typed: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        code = main(typed.split())
    except SystemExit as ended:
        code = int(str(ended.code))
    told = capsys.readouterr().err
    assert code == 2 and words in told and len(told) < 700


def test_without_a_command_the_help_is_shown_and_a_group_lists(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main([]) == 0
    assert "housefly demo" in capsys.readouterr().out
    assert main(["rules"]) == 0
    assert "bell:" in capsys.readouterr().out
    assert main(["task"]) == 2
    assert "rehearse" in capsys.readouterr().out
