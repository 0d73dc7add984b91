"""One short word for the source: any change of what flies is another word."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from housefly.lab.safety_case.flown_by import source_digest


@pytest.fixture
def package(tmp_path: Path) -> Path:
    for name in ("pilot/gate.py", "sites/bsen.toml", "twin/drone.xml", "bus/msg/Order.msg"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    return tmp_path


def test_the_source_as_installed_has_twelve_characters_and_the_same_each_time() -> None:
    assert re.fullmatch(r"[0-9a-f]{12}", source_digest())
    assert source_digest() == source_digest()


@pytest.mark.parametrize(
    "name", ["pilot/gate.py", "sites/bsen.toml", "twin/drone.xml", "bus/msg/Order.msg"]
)
def test_each_file_counts_with_its_content_and_its_name(name: str, package: Path) -> None:
    before, file = source_digest(package), package / name
    file.write_text("if False:")
    changed = source_digest(package)
    file.rename(file.with_name(f"other{file.suffix}"))
    moved = source_digest(package)
    file.with_name(f"other{file.suffix}").unlink()
    assert len({before, changed, moved, source_digest(package)}) == 4


def test_what_moves_from_the_end_of_one_file_to_the_next_counts(package: Path) -> None:
    first, second = package / "pilot/gate.py", package / "pilot/gate2.py"
    first.write_text("ab"), second.write_text("c")
    before = source_digest(package)
    first.write_text("a"), second.write_text("bc")
    assert source_digest(package) != before


@pytest.mark.parametrize(
    "left", ["pilot/__pycache__/gate.pyc", "web/client/node_modules/a/b.js", "web/client/src/a.ts"]
)
def test_what_is_compiled_or_not_installed_does_not_count(left: str, package: Path) -> None:
    before = source_digest(package)
    (package / left).parent.mkdir(parents=True)
    (package / left).write_text("x")
    assert source_digest(package) == before


def test_a_package_of_the_name_of_the_console_s_source_counts(package: Path) -> None:
    before = source_digest(package)
    (package / "hub/client").mkdir(parents=True)
    (package / "hub/client/discovery.py").write_text("x")
    assert source_digest(package) != before
