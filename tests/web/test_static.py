"""What is shipped to the browser."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from housefly.web.access.page_routes import STATIC_FOLDER

CONSOLE = ("index.html", "app.js", "video-worker.js", "app.css", "favicon.svg")
LETTERS = "inter.woff2"
"""The page's own typeface: 48 kB, once; the page is shown before it has come."""
INSTALLED = ("manifest.json", "service-worker.js", "icon-192.png", "icon-512.png")
"""What only a device loads that has the console as an app."""
LIMIT = 190_000
"""What is loaded before the first screen shows, a third of it the styles of all screens."""
LATER_LIMIT = 60_000
"""Other screens and parts, which are loaded when there is time or need."""
SCRIPT_LIMIT = 42_000
"""All script of the first load on its way, compressed."""
ALL_SCRIPT_LIMIT = 60_000
"""The same with all that comes later by itself, in English: without what is fetched only when
somebody opens it (the view in space, editing, the strip of a simulated room)."""
WHEN_OPENED_LIMIT = 6_000
"""Editing and the strip, together."""
LANGUAGE_LIMIT = 20_000
"""One language on its way, compressed: only who reads it loads it."""
LATER_STYLE = "later.css"
IN_SPACE = "chunk-room-in-space"
IN_LANGUAGE = ("chunk-ja-", "chunk-de-")
NEW_PAGE_LIMIT = 86_000
"""The page of `housefly new`: 25 kB of it are what the console has too."""


def loaded_with(script: str, pattern: str = r'(?:from|import)"\./([^"]+)"') -> set[str]:
    """Return the scripts that one loads as it begins, itself too."""
    found = {script}
    for name in re.findall(pattern, (STATIC_FOLDER / script).read_text(encoding="utf-8")):
        found |= loaded_with(name)
    return found


def called_by(scripts: set[str]) -> set[str]:
    """Return the scripts that some may load later, and what those load or call themselves."""
    found: set[str] = set()
    for name in scripts:
        text = (STATIC_FOLDER / name).read_text(encoding="utf-8")
        for chunk in re.findall(r'import\("\./([^"]+)"\)', text):
            found |= loaded_with(chunk)
    fresh = found - scripts
    return found | called_by(scripts | fresh) if fresh else found


FIRST = loaded_with("app.js") | {"video-worker.js"}
LATER = called_by(FIRST) - FIRST
IN_SPACE_ONLY = {name for name in LATER if name.startswith(IN_SPACE)}
LANGUAGES = {name for name in LATER if name.startswith(IN_LANGUAGE)}
IN_ENGLISH = {name for name in LATER if name.startswith("chunk-later-")}
BESIDE = set().union(*map(loaded_with, IN_ENGLISH)) - FIRST
SEVERAL = {"drones.css", "drones.js"}
"""What only the page of a room with several drones loads."""
NEW_FIRST = loaded_with("new.js")
NEW_PAGE = {"new.html", "new.css", *NEW_FIRST}
NEW_LATER = called_by(NEW_FIRST) - NEW_FIRST
"""What the page of `housefly new` loads at once, and its languages."""


def compressed(names: set[str]) -> int:
    """Return how many bytes of script go over the wire."""
    scripts = [STATIC_FOLDER / f"{name}.br" for name in names if name.endswith(".js")]
    return sum(script.stat().st_size for script in scripts)


@pytest.mark.parametrize(
    ("files", "limit"),
    [
        ({*CONSOLE, *FIRST}, LIMIT),
        ({*BESIDE, LATER_STYLE}, LATER_LIMIT),
        (NEW_PAGE, NEW_PAGE_LIMIT),
        ({*CONSOLE, *FIRST, *SEVERAL}, LIMIT),
    ],
    ids=["console", "later", "new", "several drones"],
)
def test_no_page_is_larger_than_allowed(files: set[str], limit: int) -> None:
    assert sum((STATIC_FOLDER / name).stat().st_size for name in files) < limit


def test_the_script_is_small_on_its_way() -> None:
    assert compressed(FIRST) < SCRIPT_LIMIT
    assert compressed(FIRST | BESIDE | {"service-worker.js"}) < ALL_SCRIPT_LIMIT
    assert compressed(LATER - BESIDE - IN_SPACE_ONLY - LANGUAGES) < WHEN_OPENED_LIMIT


def test_the_first_load_is_in_few_files() -> None:
    assert len([name for name in FIRST if name.endswith(".js")]) <= 3


def test_each_language_is_a_chunk_of_its_own_and_small() -> None:
    assert len(LANGUAGES) == len(IN_LANGUAGE)
    of_new_page = {name for name in NEW_LATER if name.startswith(("new-ja-", "new-de-"))}
    assert len(of_new_page) == len(IN_LANGUAGE)
    assert all(compressed({name}) < LANGUAGE_LIMIT for name in LANGUAGES | of_new_page)


def test_the_screen_of_the_tasks_is_not_in_the_first_load() -> None:
    first = "".join((STATIC_FOLDER / name).read_text(encoding="utf-8") for name in FIRST)
    later = "".join((STATIC_FOLDER / name).read_text(encoding="utf-8") for name in LATER)
    assert "What can be done" in later and "What can be done" not in first


def test_nothing_is_shipped_that_no_page_loads() -> None:
    found = {file.name.removesuffix(".br") for file in STATIC_FOLDER.iterdir()}
    loaded = {
        *CONSOLE,
        LETTERS,
        LATER_STYLE,
        *INSTALLED,
        *FIRST,
        *LATER,
        *NEW_PAGE,
        *NEW_LATER,
        *SEVERAL,
    }
    for_others = {"LICENSES.txt", "housefly.d.ts"}
    assert found == loaded | for_others


def test_nothing_in_it_points_to_another_host() -> None:
    for file in STATIC_FOLDER.iterdir():
        if file.suffix in (".png", ".br", ".woff2") or file.name == "LICENSES.txt":
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
        if built.suffix == ".br":  # another release of node may pack otherwise
            continue
        assert built.read_bytes() == (STATIC_FOLDER / built.name).read_bytes(), (
            f"{built.name}: run npm run build"
        )


def test_what_is_packed_is_what_lies_beside_it() -> None:
    if (node := shutil.which("node")) is None:
        pytest.skip("no node to unpack with")
    packed = sorted(STATIC_FOLDER.glob("*.br"))
    assert {file.stem for file in packed} == {
        file.name for file in STATIC_FOLDER.iterdir() if file.suffix in (".js", ".css")
    }
    unpack = (
        "process.stdout.write(require('zlib').brotliDecompressSync(require('fs').readFileSync(0)))"
    )
    for file in packed:
        done = subprocess.run(
            [node, "-e", unpack], input=file.read_bytes(), capture_output=True, check=True
        )
        assert done.stdout == file.with_suffix("").read_bytes(), f"{file.name}: run npm run build"
