"""The browser of this machine."""

from __future__ import annotations

import pytest

from housefly.app import browser_video


def chromium_path() -> str:
    """Return where Chromium is, or skip: `make setup-dev` installs it where it can."""
    found = browser_video.chromium_path()
    if found is None:
        pytest.skip("Chromium is not installed")
    return found
