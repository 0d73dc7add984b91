"""Fixtures that every test may use."""

from __future__ import annotations

import contextlib
import gc
import itertools
import os
from collections.abc import AsyncIterator, Generator
from pathlib import Path
from typing import TYPE_CHECKING

import psutil
import pytest
import pytest_asyncio
from hypothesis import settings
from installed_chromium import chromium_path

from housefly.config import process_log

if TYPE_CHECKING:
    from playwright.async_api import Browser

# The first call of a compiled function compiles it: no deadline. `make test` tries the same
# examples each time, so that it tells of a change and not of chance; pytest alone goes on looking.
settings.register_profile("housefly", deadline=None)
settings.register_profile("same-examples", deadline=None, derandomize=True)
settings.load_profile("housefly")

_counter = itertools.count(1)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Keep the garbage collector away from thousands of tests that all live to the end.

    Looking through them again and again took half of the time of collecting them.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, object, object]:
    """End what a failed test started: a whole house that flies on makes every later test late."""
    if item.get_closest_marker("realtime") is None:
        return (yield)
    before = set(psutil.Process().children())
    try:
        return (yield)
    except BaseException:
        for child in set(psutil.Process().children()) - before:
            _end_with_children(child)
        raise


def _end_with_children(process: psutil.Process) -> None:
    with contextlib.suppress(psutil.Error):
        family = [process, *process.children(recursive=True)]
        for one in family:
            one.kill()
        psutil.wait_procs(family, timeout=5.0)


@pytest.fixture
def loopback() -> str:
    """Return a loopback address that no other test, in any process, uses at the same time."""
    number = next(_counter)
    return f"127.{1 + os.getpid() % 250}.{os.getpid() // 250 % 250}.{1 + number % 250}"


@pytest_asyncio.fixture(loop_scope="session", scope="session")
async def chromium() -> AsyncIterator[Browser]:
    """Yield real headless Chromium, one for all tests of a process, or skip."""
    from playwright.async_api import async_playwright

    path = chromium_path()
    quiet = [
        "--no-sandbox",
        "--disable-gpu",
        "--disable-background-networking",
        "--disable-component-update",
        "--no-first-run",
    ]
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=path, args=quiet)
        yield browser
        await browser.close()


@pytest.fixture
def no_report(monkeypatch: pytest.MonkeyPatch) -> None:
    """Draw no page of a flight of which only the numbers are looked at: a second of processor."""
    monkeypatch.setattr("housefly.record.recorder.write_report", lambda *_: None)


@pytest.fixture
def fresh_log(monkeypatch: pytest.MonkeyPatch) -> None:
    """Print every traceback, whatever failed in a test just before."""
    monkeypatch.setattr(process_log, "_REPEATS", process_log._Repeats())


@pytest.fixture
def shared_data() -> Path:
    """Return the folder of recorded data beside the project, or skip."""
    folder = Path(__file__).resolve().parents[2] / "shared" / "data"
    if not folder.is_dir():
        pytest.skip("the folder ../shared/data with recorded data is absent")
    return folder
