"""The browser of this machine."""

from __future__ import annotations

import shutil

import pytest

NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
"""The one without windows draws the same pages for little more than half the time."""


def chromium_path() -> str:
    """Return where Chromium is, or skip: `make setup-dev` installs it where it can."""
    found = next(filter(None, map(shutil.which, NAMES)), None)
    if found is None:
        pytest.skip("Chromium is not installed")
    return found
