"""The wheel holds the whole package, and what it says of itself agrees with the code."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from zipfile import ZipFile

import pytest

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
CLIENT = "housefly/web/client/"
"""What the console's bundle is made from: nothing reads it at run time."""
BUILD = "from setuptools.build_meta import build_wheel; build_wheel('.')"
PAGE = ROOT / "docs" / "install.md"
FOR_DEVELOPERS = {"dev", "fuzz"}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> ZipFile:
    """Build the wheel of a copy: a build folder that lies in the checkout would be packed, too."""
    copy = tmp_path_factory.mktemp("checkout") / "copy"
    ignored = shutil.ignore_patterns("node_modules", "__pycache__", "*.egg-info")
    shutil.copytree(ROOT / "src", copy / "src", ignore=ignored)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, copy)
    subprocess.run([sys.executable, "-c", BUILD], cwd=copy, check=True, capture_output=True)
    return ZipFile(next(copy.glob("*.whl")))


def test_the_wheel_holds_every_file_of_the_package_but_the_sources_of_the_page(
    wheel: ZipFile,
) -> None:
    source = ROOT / "src"
    files = {
        path.relative_to(source).as_posix()
        for path in (source / "housefly").rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and "node_modules" not in path.parts
    }
    packed = {name for name in wheel.namelist() if ".dist-info/" not in name}
    assert packed == {name for name in files if not name.startswith(CLIENT)}
    assert any(name.endswith("static/index.html") for name in packed)


def test_an_install_command_that_an_error_names_is_of_an_extra_that_there_is() -> None:
    words = "".join(path.read_text() for path in (ROOT / "src" / "housefly").rglob("*.py"))
    named = set(re.findall(r"pip install 'housefly\[(\w+)\]'", words))
    assert named and named <= set(PROJECT["optional-dependencies"])


def test_the_page_on_installing_lists_every_extra_for_users_and_every_python() -> None:
    page = PAGE.read_text()
    extras = page.split("\n## ")[3]
    rows = set(re.findall(r"^\| `(\w+)` \|", extras, flags=re.MULTILINE))
    assert rows == set(PROJECT["optional-dependencies"]) - FOR_DEVELOPERS
    pythons = re.findall(r"Python :: (3\.\d+)", " ".join(PROJECT["classifiers"]))
    assert pythons[0] == PROJECT["requires-python"].removeprefix(">=")
    assert all(re.search(rf"^\| {re.escape(python)}\.\d+ \|", page, re.M) for python in pythons)
