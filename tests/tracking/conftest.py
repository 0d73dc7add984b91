"""What the tests of the tracking clients share."""

from __future__ import annotations

import pytest
from tracking_bench import Bench


@pytest.fixture
def bench() -> type[Bench]:
    """Return the room and its helpers."""
    return Bench
