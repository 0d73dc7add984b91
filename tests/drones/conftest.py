"""Drivers and simulated drones in one event loop: its time is theirs."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator, Mapping

import pytest
from virtual_time import VirtualTimeLoop, loop_time

from housefly.clock import RealClock


def pytest_asyncio_loop_factories(
    item: pytest.Item,
) -> Mapping[str, Callable[[], asyncio.AbstractEventLoop]]:
    """Give a test that is marked so a loop that makes its own time."""
    is_virtual = item.get_closest_marker("virtual_time") is not None
    return {"virtual": VirtualTimeLoop} if is_virtual else {"real": asyncio.new_event_loop}


@pytest.fixture(autouse=True)
def the_loop_tells_the_time(request: pytest.FixtureRequest) -> Iterator[None]:
    """Let drivers and rooms read the time that the loop makes."""
    with pytest.MonkeyPatch.context() as patch:
        if request.node.get_closest_marker("virtual_time") is not None:
            patch.setattr(RealClock, "now", loop_time)
        yield
