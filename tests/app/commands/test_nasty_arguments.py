"""Whatever is typed is done or refused in words: 2, or 1 where the answer is no; no traceback."""

from __future__ import annotations

import io
import sys
from argparse import ArgumentParser, _SubParsersAction
from collections.abc import Iterator
from pathlib import Path

import pytest

from housefly.app.launcher import Launcher
from housefly.cli import build_parser, main
from housefly.twin.world import SimulatedWorld

EMPTY = ""
UNSPEAKABLE = ("x\0y", "a" * 5000, "\udc80", "two\nlines", "9" * 5000, "a/" * 1500, "a/" * 3000)
"""Refused whatever they stand for."""
ODD = ("[/x]", "/dev/zero", ".", "~nobody_x/y", "a" * 300)
"""Words that are a style, a device, a folder, in the home of nobody, longer than a name."""
NOT_A_COUNT = ("x", "nan", "-1", "9" * 4000, "[/x]")
NOT_A_NUMBER = ("x", "nan", "inf", "-inf", "1e400", "9" * 4000, "[/x]")
NOT_A_POINT = (",", "1", "1,2,3", "nan,nan", "inf,1", "1e400,2", "9" * 4000 + ",1")

LINES: dict[str, tuple[str, ...]] = {
    "demo": (),
    "new": ("mylab", "--yes", "--no-test"),
    "run": (),
    "fly": ("entrance", "--headless", "--lockstep"),
    "preflight": (),
    "plan": ("--to=home", "--mode=paper"),
    "room show": (),
    "room import": ("map.yaml", "--out=room"),
    "replay": ("recording",),
    "identify": ("--lockstep",),
    "gains": ("--alpha=3.6", "--beta=3.24", "--rate=10", "--latency=0.1"),
    "ask": ("where is the cup",),
    "tasks": (),
    "cancel": ("1",),
    "task check": ("task.yaml",),
    "task rehearse": ("look", "subject=refrigerator"),
    "task import-rpn": ("9001$pid", "--name=go"),
    "rules list": (),
    "rules check": ("rules.yaml",),
    "rules dry-run": (),
    "clips list": (),
    "clips export": ("1", "--out=clips"),
    "clips tidy": (),
    "mcp": ("--http=0",),
    "ros2": ("--domain=300",),
    "where": ("shelf",),
    "is": ("door", "open"),
    "who": ("somebody",),
    "nights": ("bed",),
    "history": ("shelf",),
    "watch": (),
    "sensors": (),
    "report": ("hover.csv", "--out=hover.html"),
    "export": ("events.csv",),
    "memory forget": ("person-1",),
    "memory import-tms": ("dump.json",),
    "memory export-tms": ("dump.json",),
    "campaign": ("campaign.toml",),
    "reproduce": ("--no-wires", "--quick"),
    "safety": ("--seeds=0",),
    "cert": ("--out=tls",),
    "user add": ("carer", "--role=fly"),
    "user role": ("carer", "--role=fly"),
    "user remove": ("carer",),
    "user list": (),
    "doctor": (),
}
"""Each command as somebody means it, the words that have no option first; into each of its words
and options the nasty ones are put in turn.
"""
NO_NEED_TO_REFUSE = {
    # Names of files and folders, and words for people: these may be anything that can be written.
    *{("demo", "record"), ("run", "record"), ("fly", "out"), ("identify", "out"), ("cert", "out")},
    *{
        ("gains", "out"),
        ("report", "out"),
        ("plan", "png"),
        ("room show", "png"),
        ("room import", "out"),
    },
    *{("clips export", "out"), ("reproduce", "out"), ("safety", "out"), ("campaign", "out")},
    *{("memory export-tms", "file"), ("task import-rpn", "out"), ("task import-rpn", "title")},
    *{("new", "name"), ("new", "port"), ("history", "kind"), ("export", "kind")},
    *{("mcp", "site"), ("export", "file"), ("export", "pseudonyms"), ("export", "thing")},
    *{("clips list", word) for word in ("person", "place", "thing", "task", "limit")},
    *{(command, "seed") for command in ("demo", "fly", "identify", "reproduce", "safety")},
    # The answer is no, or nothing.
    *{("plan", "start"), ("plan", "goal"), ("history", "limit"), ("safety", "wires")},
    *{("tasks", "pause"), ("tasks", "proceed"), ("identify", "recorded"), ("ask", "words")},
}
"""Commands and arguments for which an odd word is no mistake by itself."""
MAP = "image: map.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
MAP += "occupied_thresh: 0.65\nfree_thresh: 0.196\n"
TASK = "name: go\ntitle: go there\nsteps:\n  - say: there\n"
CAMPAIGN = 'name = "small"\nseeds = 1\n[mission]\nwaypoints = [[0, 0], [1, 0]]\nduration_s = 3.0\n'
AFTER_A_POWER_CUT = b"\0" * 100
BYTES = (
    AFTER_A_POWER_CUT,
    b"\xff\xfe",
    b"[" * 100_000,
    b'{"a":' * 50_000,
    b"\xff\n" * 3,
    b'"a"',
    b"5",
)
FILES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("x.yaml", ("task", "check", "x.yaml")),
    ("tasks/x.yaml", ("task", "check", "tasks")),
    ("x.yaml", ("rules", "check", "x.yaml")),
    ("x.yaml", ("rules", "dry-run", "--file=x.yaml")),
    ("x.yaml", ("room", "import", "x.yaml", "--out=room")),
    ("map.pgm", ("room", "import", "map.yaml", "--out=room")),
    ("x.json", ("memory", "import-tms", "x.json")),
    ("x.toml", ("campaign", "x.toml", "--out=out")),
    ("out/campaign.json", ("campaign", "campaign.toml", "--out=out")),
    ("x.toml", ("gains", "--profile=x.toml")),
    ("x.toml", ("doctor", "--site=x.toml")),
    ("x.mcap", ("replay", "x.mcap", "--site=bsen")),
    ("site.json", ("replay", ".")),
    ("x.mcap", ("report", "x.mcap")),
    ("x.bag", ("report", "x.bag")),
    ("x.csv", ("report", "x.csv")),
    ("x.mcap", ("export", "x.csv", "--flight=x.mcap")),
    ("out/site.json", ("identify", "--from=out")),
    ("out/flights.jsonl", ("safety", "--seeds=0", "--out=out")),
    ("out/wired_flights.jsonl", ("safety", "--seeds=0", "--out=out")),
    ("out/flown_by.json", ("safety", "--seeds=0", "--out=out")),
    ("lab/draft.json", ("new", "lab", "--yes", "--no-test")),
    ("x.svg", ("new", "lab", "--yes", "--no-test", "--room=../x.svg")),
)
"""A file, and the line that reads it."""
NOT_MEANT: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("--from", ("identify", "--lockstep", "--from", "")),
    ("--from", ("identify", "--lockstep", "--from=")),
    ("--record", ("run", "--record", " ")),
    ("argument 2", ("fly", "", "--lockstep")),
    ("nobody_x", ("new", "lab", "--yes", "--no-test", "--room=~nobody_x/y.svg")),
    ("nobody_x", ("new", "lab", "--yes", "--no-test", "--drone=10.0.0.5 profile=~nobody_x/y")),
    ("F13/2cm, F13/5cm, F13/steps, F13/jumps_5cm, F13/up_5cm", ("demo", "--fault=F13/nan")),
    ("drone.kind: is 'spitfire'; allowed", ("demo", "--drone", "spitfire")),
    ("--box", ("identify", "--lockstep", "--box=nan")),
    ("--box", ("identify", "--lockstep", "--box=1e9")),
)
"""What a refusal names, and the line."""


class FlightBegan(BaseException):
    """Somebody would fly now."""


def began(*_: object, **__: object) -> None:
    raise FlightBegan


@pytest.fixture(autouse=True)
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Stand in a folder of one's own, at which every flight ends before it begins."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))
    (desk := tmp_path / "desk").mkdir()
    (desk / "map.yaml").write_text(MAP)
    (desk / "map.pgm").write_bytes(b"P5 40 40 255\n" + bytes([0]) * 40 + bytes([254]) * 1560)
    (desk / "task.yaml").write_text(TASK)
    (desk / "rules.yaml").write_text("rules: []\n")
    (desk / "dump.json").write_text("")
    (desk / "campaign.toml").write_text(CAMPAIGN)
    monkeypatch.chdir(desk)
    monkeypatch.setattr(SimulatedWorld, "__init__", began)
    monkeypatch.setattr(Launcher, "__enter__", began)
    for flies in (
        "housefly.lab.safety_case.faulty_flight.fly_trial",
        "housefly.app.reproduction_run.measure",
        "housefly.lab.campaigns.runner.fly_chunks",
        "housefly.lab.tuning.plots.draw_judgement",  # flies nothing, and takes its time
    ):
        monkeypatch.setattr(flies, began)
    for takes_its_time in ("app.compiling.compile_once", "record.recorder.write_report"):
        monkeypatch.setattr(f"housefly.{takes_its_time}", lambda *_: None)
    return desk


def each_command(
    parser: ArgumentParser, words: tuple[str, ...] = ()
) -> Iterator[tuple[str, ArgumentParser]]:
    groups = [one for one in parser._actions if isinstance(one, _SubParsersAction)]
    if not groups:
        yield " ".join(words), parser
    for group in groups:
        for word, inner in group.choices.items():
            yield from each_command(inner, (*words, word))


COMMANDS = dict(each_command(build_parser()))


def nasty_lines(command: str) -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Yield lines with one nasty word each, with the name of its argument and the word."""
    usual, place = LINES[command], 0
    for argument in COMMANDS[command]._actions:
        if argument.nargs == 0:
            continue
        odd = NOT_A_COUNT if argument.type is int else ODD
        odd = NOT_A_NUMBER if argument.type is float else odd
        for word in (EMPTY, *UNSPEAKABLE, *odd):
            if argument.option_strings:
                option = argument.option_strings[-1]
                given = (option, word, "yes") if argument.nargs == 2 else (f"{option}={word}",)
                words = (*usual, *given)
            else:
                words = (*usual[:place], word, *usual[place + 1 :])
            yield argument.dest, word, (*command.split(), *words)
        place += not argument.option_strings


def test_every_command_is_typed_with_nasty_words() -> None:
    assert set(LINES) == set(COMMANDS)


@pytest.mark.parametrize("command", LINES)
def test_a_nasty_word_is_done_or_refused_in_words_and_flies_nothing(
    command: str, desk: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = []
    for argument, word, line in nasty_lines(command):
        monkeypatch.setattr(sys, "stdin", io.StringIO("a long password\n"))
        before = sorted(desk.rglob("*"))
        told = outcome(line)
        said = capsys.readouterr()
        is_refused = told == "2" and "housefly" in said.err
        if word in (EMPTY, *UNSPEAKABLE):
            is_fine = is_refused and sorted(desk.rglob("*")) == before
        elif (command, argument) in NO_NEED_TO_REFUSE:
            is_fine = (
                is_refused
                or told in ("0", "1")
                or (told == "begins" and argument in ("out", "record"))
            )
        else:
            is_fine = is_refused
        if not is_fine:
            shown = " ".join(line) if len(word) < 100 else f"{command} {argument} {word[:9]} ..."
            wrong.append(f"{shown!r}: {told} {said.err[-200:]}")
    assert not wrong, "\n".join(wrong)


def outcome(line: tuple[str, ...]) -> str:
    """Return the exit code, ``begins`` for a flight, or the error that nobody caught."""
    try:
        return str(main(list(line)))
    except SystemExit as left:  # what argparse refuses
        return str(left.code)
    except FlightBegan:
        return "begins"
    except Exception as error:
        return f"{type(error).__name__}: {error}"[:200]


@pytest.mark.parametrize("point", NOT_A_POINT, ids=lambda point: point[:12])
@pytest.mark.parametrize("option", ["--from", "--to"])
def test_a_way_to_no_point_is_refused(option: str, point: str) -> None:
    assert outcome(("plan", "--to=home", "--mode=paper", f"{option}={point}")) in ("1", "2")


@pytest.mark.parametrize("file, line", FILES, ids=lambda one: str(one)[:40])
def test_a_file_of_nasty_bytes_is_refused_in_words(
    file: str, line: tuple[str, ...], desk: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = []
    for content in BYTES:
        (desk / file).parent.mkdir(exist_ok=True)
        (desk / file).write_bytes(content)
        told = outcome(line)
        said = capsys.readouterr()
        is_refused = told == "2" and said.err.startswith("housefly: ")
        is_left_out = told == "1" and "rows left out" in said.out.replace("\n", " ")
        is_cut_short = file.endswith(".jsonl") and content == AFTER_A_POWER_CUT
        if not (is_refused or is_left_out or is_cut_short):
            wrong.append(f"{content[:9]!r}: {told} {said.out[-300:]} {said.err[-200:]}")
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("named, line", NOT_MEANT, ids=lambda one: str(one)[:50])
def test_a_refusal_names_what_is_wrong(
    named: str, line: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    assert outcome(line) == "2"
    assert named in capsys.readouterr().err.replace("\n", " ")
