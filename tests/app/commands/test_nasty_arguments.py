"""Whatever is typed is done or refused in words: 2, or 1 where the answer is no; no traceback."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.cli import main

ODD = ("x\0y", "a" * 300, "a/" * 3000, "\udc80", "two\nlines", "9" * 5000)
NOT_A_NUMBER = ("", "x", "nan", "inf", "-inf", "1e400", "9" * 5000, "x\0y")
NOT_A_POINT = ("", ",", "1", "1,2,3", "nan,nan", "inf,1", "1e400,2", "x\0y", "9" * 5000 + ",1")

LINES: tuple[tuple[str, ...], ...] = (
    *(
        (command, *more, f"--site={odd}")
        for odd in ODD
        for command, *more in (
            ("demo",),
            ("run",),
            ("fly", "entrance"),
            ("plan", "--to=entrance"),
            ("room", "show"),
            ("identify",),
            ("sensors",),
            ("where", "shelf"),
            ("doctor",),
        )
    ),
    *(("fly", odd, "--headless", "--lockstep", "--out=out") for odd in ODD),
    *(("fly", "entrance", "--headless", "--lockstep", f"--out={odd}") for odd in ODD),
    *(("fly", "entrance", "--lockstep", f"--look={odd}") for odd in NOT_A_NUMBER),
    *(("fly", "entrance", "--lockstep", f"--seed={odd}") for odd in NOT_A_NUMBER),
    *(("fly", "entrance", "--lockstep", f"--mocap-rate={odd}") for odd in NOT_A_NUMBER),
    *(("run", f"--port={odd}") for odd in (*NOT_A_NUMBER, "-1", "70000")),
    *(("plan", "--to=entrance", f"--from={odd}") for odd in NOT_A_POINT),
    *(("plan", f"--to={odd}") for odd in (*NOT_A_POINT, *ODD)),
    *(("plan", "--to=entrance", f"--png={odd}") for odd in ODD[:4]),
    *(("room", "show", f"--png={odd}") for odd in ODD[:4]),
    *(("room", "import", odd, "--out=room") for odd in (*ODD, "/dev/zero", "/dev/null", ".")),
    *(("replay", odd) for odd in (*ODD, "/dev/null", "/dev/zero", ".", "")),
    *(("memory", "import-tms", odd) for odd in (*ODD, "/dev/null", ".")),
    *(("memory", "export-tms", odd) for odd in (*ODD[:4], ".", "/")),
    *(("gains", odd) for odd in ODD),
)


@pytest.mark.parametrize("line", LINES, ids=lambda line: repr(" ".join(line))[:60])
def test_a_line_that_nobody_means_is_refused_in_words(
    line: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))
    monkeypatch.chdir(tmp_path)
    try:
        code = main(list(line))
    except SystemExit as left:  # what argparse refuses
        code = int(left.code or 0)
    told = capsys.readouterr()
    # 1: the question was understood, and the answer is no.
    assert code == 2 or (code == 1 and line[0] in ("plan", "memory")), f"exit code {code}"
    assert told.err.count("housefly") or told.out
