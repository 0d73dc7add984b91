"""``import housefly`` is light, complete, documented, and enough for the course and the README."""

from __future__ import annotations

import ast
import inspect
import re
import subprocess
import sys
import textwrap
from collections import Counter
from contextlib import redirect_stdout
from io import StringIO
from itertools import islice, pairwise
from pathlib import Path

import pytest
from quick_flights import QUICK

import housefly

TOPICS = housefly.DroneTopics()

ROOT = Path(__file__).resolve().parents[1]
README, PAGE = (ROOT / "README.md").read_text(), (ROOT / "docs" / "python.md").read_text()
SOURCE = Path(housefly.__file__)
HEAVY = {"aiomqtt", "av", "matplotlib", "mujoco", "numba", "numpy", "pyarrow", "pydantic", "zenoh"}
OURS = {"housefly", "examples", "tests", "benchmarks"}


def block_after(text: str, heading: str, language: str = "") -> str:
    """Return the first code block of a language after a heading."""
    rest = text[text.index(heading) :]
    found = re.search(rf"^```{language}\n(.*?)^```$", rest, flags=re.MULTILINE | re.DOTALL)
    assert found is not None
    return found.group(1)


TOUR = block_after(README, "## From Python", "python")


@pytest.fixture(scope="module")
def tour() -> tuple[str, housefly.Flight]:
    """Run the five lines of the README; return what they print and the flight."""
    printed, names = StringIO(), dict[str, object]()
    with redirect_stdout(printed):
        exec(TOUR, names)
    flight = names["flight"]
    assert isinstance(flight, housefly.Flight)
    return printed.getvalue(), flight


def test_all_is_sorted_and_is_what_dir_shows() -> None:
    names = list(housefly.__all__)
    assert sorted(names) == dir(housefly) == sorted(set(names))
    for kind in (str.isupper, lambda name: name[0].isupper() and not name.isupper(), str.islower):
        of_kind = [name for name in names if kind(name)]
        assert of_kind == sorted(of_kind)


@pytest.mark.parametrize("name", housefly.__all__)
def test_every_name_resolves_and_has_a_docstring(name: str) -> None:
    value = getattr(housefly, name)
    if inspect.isclass(value) or inspect.isfunction(value):
        words = value.__doc__ or ""
        assert len(words.split()) > 2 and not words.startswith(f"{name}("), name
    assert getattr(housefly, name) is value


def test_a_misspelt_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="has no attribute 'flie'"):
        housefly.flie  # type: ignore[attr-defined] # noqa: B018


def test_type_checkers_see_exactly_the_names_that_there_are() -> None:
    imported = {
        alias.name: node.module
        for node in ast.walk(ast.parse(SOURCE.read_text()))
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("housefly.")
        for alias in node.names
    }
    assert set(imported) == set(housefly.__all__)
    for name, module in imported.items():
        assert housefly._MODULE_OF.get(name, "messages") == str(module).removeprefix("housefly.")


def test_every_message_and_every_error_is_there() -> None:
    from housefly import errors, messages

    assert set(messages.__all__) <= set(housefly.__all__)
    kinds = {name for name, value in vars(errors).items() if inspect.isclass(value)}
    assert kinds <= set(housefly.__all__)


def test_importing_is_light() -> None:
    code = "import sys, housefly; print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    loaded = set(done.stdout.split())
    assert not loaded & HEAVY
    assert {name for name in loaded if name.startswith("housefly")} == {"housefly"}


def test_the_command_line_loads_what_a_command_needs_when_it_runs() -> None:
    code = "import sys, housefly.cli as cli; cli.build_parser(); print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert not set(done.stdout.split()) & HEAVY


def test_every_name_stands_once_in_the_tables_of_the_page_and_no_other() -> None:
    rows = Counter(re.findall(r"^\| `(\w+)` \| \S", PAGE, flags=re.MULTILINE))
    assert rows == Counter(housefly.__all__)


def test_the_module_docstring_lists_every_name_but_messages_and_errors() -> None:
    words = set(re.findall(r"\w+", housefly.__doc__ or ""))
    topics = {name for name in housefly.__all__ if name.endswith("_TOPIC")}
    others = set(housefly.messages.__all__) | topics
    missing = {name for name in housefly.__all__ if name not in words} - others
    errors = {"StaleEdits", "UnknownState"}
    assert all(name.endswith("Error") or name in errors for name in missing), missing


def test_the_five_lines_are_the_same_everywhere() -> None:
    assert block_after(PAGE, "# From Python", "python") == TOUR
    assert textwrap.indent(TOUR, "    ") in (housefly.__doc__ or "")
    lines = [line for line in TOUR.splitlines() if line]
    assert len(lines) == 5


@pytest.mark.parametrize("path", sorted((ROOT / "examples").glob("*.py")), ids=lambda p: p.name)
def test_examples_need_only_the_front_door(path: Path) -> None:
    tree = ast.parse(path.read_text())
    modules = {
        node.module if isinstance(node, ast.ImportFrom) else alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.Import | ast.ImportFrom)
        for alias in node.names
    }
    ours = {str(module) for module in modules if str(module).split(".")[0] in OURS}
    assert ours == {"housefly"}
    from_us = {
        alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module == "housefly"
        for alias in node.names
    }
    by_dot = {
        node.attr
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Name)
        and node.value.id == "housefly"
    }
    assert from_us | by_dot <= set(housefly.__all__)


@pytest.mark.slow
def test_the_five_lines_print_what_the_readme_says(tour: tuple[str, housefly.Flight]) -> None:
    after = README[README.index(TOUR) + len(TOUR) + len("```") :]
    told, written = tour[0], block_after(after, "```")
    assert re.sub(r"\d+ mm", "", told) == re.sub(r"\d+ mm", "", written)
    off, said = (int(re.findall(r"(\d+) mm", text)[0]) for text in (told, written))
    assert abs(off - said) <= 1  # other compilers round another way


@pytest.mark.slow
def test_a_flight_is_read_replayed_and_opened_again(tour: tuple[str, housefly.Flight]) -> None:
    flight = tour[1]
    numbers = [step.sequence for step in flight.steps()]
    assert len(numbers) == flight.summary.steps and all(b == a + 1 for a, b in pairwise(numbers))
    replay = flight.replay()
    assert (replay.steps, replay.missing, replay.difference) == (len(numbers), 0, None)
    again = housefly.open_flight(flight.folder)
    assert (again.outcome, again.summary) == (flight.outcome, flight.summary)
    again.close()
    assert flight.folder.is_dir()


def test_a_flight_that_is_not_there_is_refused_in_words(tmp_path: Path) -> None:
    with pytest.raises(housefly.RecordingError, match=r"summary\.json cannot be read"):
        housefly.open_flight(tmp_path)
    (tmp_path / "summary.json").write_text('{"outcome": 7}')
    with pytest.raises(housefly.RecordingError, match="is no summary of a flight"):
        housefly.open_flight(tmp_path)


def test_places_and_values_that_cannot_be_are_refused_in_words() -> None:
    site = housefly.load_site("bsen")
    with pytest.raises(housefly.ConfigError, match="no place called 'moon'; known places: home"):
        site.plan("moon")
    with pytest.raises(housefly.ConfigError, match="no place called 'moon'"):
        housefly.fly("moon", site)
    with pytest.raises(housefly.ConfigError, match=r"look_s: is -1; allowed: .* 0 to 120 s"):
        housefly.fly("sofa", site, look_s=-1.0)
    with pytest.raises(housefly.ConfigError, match=r"twim\.seed: is not a known key"):
        housefly.load_site("bsen", twim__seed=7)
    with pytest.raises(housefly.ConfigError, match="repeats: is 3; allowed: a number from 4 to 40"):
        housefly.identify(site, repeats=3)


def test_a_plan_begins_where_it_is_told_to_and_ends_at_a_point() -> None:
    site = housefly.load_site("bsen")
    answer = site.plan((10.0, 1.5), start="entrance")
    assert answer.path is not None
    assert answer.path.waypoints[-1] == (10.0, 1.5)
    assert answer.start == site.room.place("entrance").viewpoint


@pytest.mark.interop
@pytest.mark.slow
def test_the_folder_of_a_flight_is_the_given_one_or_goes_with_the_flight(
    tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    site, near = housefly.load_site("bsen", **QUICK), (10.0, 1.5)
    heard: list[int] = []
    kept = housefly.fly(
        near, site, look_s=0.0, out=tmp_path, on_step=lambda s: heard.append(s.sequence)
    )
    assert kept.outcome == "completed" and len(heard) == kept.summary.steps
    kept.close()
    assert (tmp_path / "report.html").is_file()
    request.getfixturevalue("no_report")  # it was seen to be there
    passing = housefly.fly(near, site, look_s=0.0)
    assert passing.summary == kept.summary
    folder = passing.folder
    assert folder.is_dir()
    del passing
    assert not folder.exists()


@pytest.mark.slow
def test_a_simulation_flies_what_fly_flies(tour: tuple[str, housefly.Flight]) -> None:
    simulation = housefly.Simulation(housefly.load_site("bsen", twin__seed=7))
    order = housefly.Order(
        housefly.OrderKind.SERVICE,
        place="entrance",
        look_s=5.0,
        sender="python",
        source=housefly.OrderSource.PROGRAM,
    )
    for recorded in islice(tour[1].steps(), 2500):  # the take-off, and half of the way there
        simulation.advance()
        given = [order] if recorded.inputs.orders else []
        assert simulation.step(simulation.inputs(*given)) == recorded


def test_python_runs_the_package_as_the_command_line() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "housefly", "room", "paint"], capture_output=True, text=True
    )
    assert done.returncode == 2
    assert "housefly room: error: no command 'paint'" in done.stderr


@pytest.fixture
def wired(loopback: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> housefly.LoadedSite:
    """Return a site on real wires that leaves nothing in the user's folders."""
    for variable in ("XDG_RUNTIME_DIR", "XDG_STATE_HOME"):
        monkeypatch.setenv(variable, str(tmp_path / "state"))
    wires = {"drone__address": loopback, "tracking__address": loopback}
    return housefly.load_site("bsen", **wires, drone__has_video=False, twin__video=False)


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.interop
@pytest.mark.slow
def test_a_flight_over_real_wires_is_recorded(wired: housefly.LoadedSite) -> None:
    flight = housefly.fly((10.0, 1.5), wired, lockstep=False, look_s=0.0)
    assert flight.outcome == "completed"
    assert (flight.folder / "logs" / "pilot.log").is_file()
    assert flight.replay().difference is None


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.slow
def test_the_room_that_was_launched_is_found_and_asked(wired: housefly.LoadedSite) -> None:
    with housefly.launch(wired) as bus, housefly.connect("B-sen") as room:
        assert bus.ask(TOPICS.plan, '{"place": "sofa"}').startswith("{")
        assert room.where("sofa").kind == "furniture"
    with pytest.raises(housefly.LinkError, match="no room called 'B-sen' is running here"):
        housefly.connect("B-sen")
