"""What is shipped to the browser."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from housefly.web.page_routes import STATIC_FOLDER

CONSOLE = ("index.html", "app.js", "app.css", "favicon.svg")
LIMIT = 118_000
"""100 kB, 12 kB for editing, 1 kB for furniture that moves, 5 kB for the pre-flight checks."""
NEW_PAGE = ("new.html", "new.js", "new.css")
NEW_PAGE_LIMIT = 84_000
"""The page of `housefly new`: 25 kB of it are what the console has too."""


@pytest.mark.parametrize(("files", "limit"), [(CONSOLE, LIMIT), (NEW_PAGE, NEW_PAGE_LIMIT)])
def test_no_page_is_larger_than_allowed(files: tuple[str, ...], limit: int) -> None:
    assert sum((STATIC_FOLDER / name).stat().st_size for name in files) < limit


def test_nothing_is_shipped_that_no_page_loads() -> None:
    found = {file.name for file in STATIC_FOLDER.iterdir()}
    assert found == {*CONSOLE, *NEW_PAGE, "LICENSES.txt"}


def test_nothing_in_it_points_to_another_host() -> None:
    for file in STATIC_FOLDER.iterdir():
        if file.name == "LICENSES.txt":
            continue
        found = set(re.findall(r"(?:https?|wss?)://[\w.-]+", file.read_text(encoding="utf-8")))
        assert found <= {"http://www.w3.org"}, file.name


@pytest.mark.parametrize("name", ["index.html", "new.html"])
def test_the_page_holds_no_script_and_no_style_of_its_own(name: str) -> None:
    page = (STATIC_FOLDER / name).read_text(encoding="utf-8")
    assert "style=" not in page and "<style" not in page
    assert re.findall(r"<script[^>]*>(.*?)</script>", page, re.DOTALL) == [""]


def test_the_committed_bundle_is_what_the_source_builds(tmp_path: Path) -> None:
    client = STATIC_FOLDER.parent / "client"
    node = shutil.which("node")
    if node is None or not (client / "node_modules" / "esbuild").is_dir():
        pytest.skip("the client's tools are not installed: npm ci in src/housefly/web/client")
    subprocess.run([node, "build.mjs", str(tmp_path)], cwd=client, check=True)
    for built in tmp_path.iterdir():
        assert built.read_bytes() == (STATIC_FOLDER / built.name).read_bytes(), (
            f"{built.name}: run npm run build"
        )
