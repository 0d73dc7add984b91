"""The house stays one that a newcomer can enter: names, lines, layers, the walk."""

from __future__ import annotations

import ast
import re
import tomllib

import pytest
import reach

import house

SHARED_NAMES = {f"{package}.main": "entry points of processes" for package in ("app", "twin")}
"""Names that several modules of a package define, and why."""


def test_no_two_functions_or_classes_of_a_package_share_a_name_without_a_reason() -> None:
    twice = {name for name, places in house.public_definitions().items() if len(places) > 1}
    assert twice == set(SHARED_NAMES)


def test_no_line_is_longer_than_a_hundred_columns() -> None:
    assert house.long_lines() == []


def test_who_walks_from_a_sighting_to_a_command_meets_neither_planner_nor_commander() -> None:
    walk = set(house.walk())
    behavior = {f"housefly.pilot.behavior.{name}" for name in ("commander", "mission_manager")}
    assert not walk & {"housefly.pilot.navigator", "housefly.config.site", "housefly.room.model"}
    assert not walk & behavior
    assert not {name for name in walk if name.startswith("housefly.pilot.planning.space")}


def test_the_map_of_the_house_names_every_layer_of_the_contract() -> None:
    project = tomllib.loads((house.ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = project["tool"]["importlinter"]["contracts"][0]["layers"]
    page = (house.ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    drawn = page.partition("┌──")[2].partition("└──")[0]
    names = {name for layer in layers for name in layer.split(" | ")}
    assert [
        name for name in sorted(names) if not re.search(rf"(?:│ |  |[(]|, ){name}[ ,)]", drawn)
    ] == []


OWN_FOLDERS = (
    *("wires/ardrone", "drones/ardrone", "twin/ardrone", "ros2/paper"),
    "config/airframes",
)
STILL_NAME_IT = {
    "words for people": (
        "__init__.py",
        "app/frame_check/carrying_hands.py",
        "app/new_site/questions.py",
    ),
    "the site's file chooses among models": ("config/drone.py", "config/tracking.py"),
    "the one table of drivers, and lock step's": (
        "drones/__init__.py",
        "lab/lockstep/lockstep_wires.py",
    ),
    "the paper flew one": ("lab/reproduction/equations.py", "lab/reproduction/fleet.py"),
    "the twin simulates one": (
        "twin/drone_servers.py",
        "twin/faults/catalogue.py",
        "twin/faults/wire_link.py",
        "twin/quadrotor/",
        "twin/served_drone.py",
    ),
}
"""Why a file outside the drone's own folders names it; the table may only become shorter."""


def test_no_other_file_names_one_model_of_a_drone() -> None:
    excused = tuple(file for files in STILL_NAME_IT.values() for file in files)
    named = [
        name
        for path in house.PACKAGE.rglob("*.py")
        if re.search(r"ar\.?drone", path.read_text(encoding="utf-8"), re.IGNORECASE)
        and not (name := path.relative_to(house.PACKAGE).as_posix()).startswith(OWN_FOLDERS)
    ]
    assert [name for name in sorted(named) if not name.startswith(excused)] == []


def test_every_module_that_ships_is_reached_from_where_users_enter() -> None:
    graph = reach.import_graph()
    assert len(graph.modules) == len(house.modules())
    assert reach.unreached(graph) == [], "to benchmarks, tests/support or scripts, or away"


def test_what_nobody_imports_starts_or_names_is_found() -> None:
    graph = reach.import_graph()
    graph.remove_import(importer="housefly.cli", imported="housefly.app.commands.replay")
    assert "housefly.app.commands.replay" in reach.unreached(graph)
    launched, launcher = "housefly.app.tasks_main", "housefly.app.launcher"
    for importer in graph.find_modules_that_directly_import(launcher):
        graph.remove_import(importer=importer, imported=launcher)
    assert {launcher, launched} <= set(reach.unreached(graph))


@pytest.mark.parametrize("folder", ["pilot", "lab/experiments"])
def test_no_state_of_the_step_is_built_by_position(folder: str) -> None:
    """Swapping two of five nested fields would pass the type check."""
    nested = {
        *("EstimatorState", "StepState", "PilotParameters", "EstimatorParameters", "Guidance"),
        *("HeightYawState", "DelayFilterState", "PaperFilterState", "PathProgress"),
        *("TrajectorySetpoint", "TaskState", "Stream"),
    }
    for path in (house.PACKAGE / folder).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                assert node.func.id not in nested or not node.args, f"{path}:{node.lineno}"


def test_nothing_waits_by_what_loses_a_cancellation() -> None:
    # Python 3.11's wait_for does, when the answer comes in the same turn: the task never ends.
    sources = {path: path.read_text("utf-8") for path in (house.ROOT / "src").rglob("*.py")}
    assert [path for path, text in sources.items() if "asyncio.wait_for(" in text] == []
