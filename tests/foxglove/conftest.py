"""A live view of the shipped room on a bus of this process."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import AbstractAsyncContextManager
from dataclasses import dataclass
from typing import Any

import pytest
from foxglove_client import Viewer, watching
from foxglove_room import Talker

from housefly.bus.local import LocalBus
from housefly.config.site import changed
from housefly.sites.loaded_site import LoadedSite, load_site


@dataclass
class Live:
    """A live view, who talks to it, and how to watch it."""

    site: LoadedSite
    view: Any
    talker: Talker
    channels: int

    def watch(self, origin: str | None = None) -> AbstractAsyncContextManager[Viewer]:
        """Return a viewer of it."""
        return watching(self.view.port, origin=origin, channels=self.channels)

    @contextlib.asynccontextmanager
    async def talking(self) -> AsyncIterator[None]:
        """Tell everything again and again."""

        async def talk() -> None:
            while True:
                self.talker.tell()
                await asyncio.sleep(0.05)

        task = asyncio.create_task(talk())
        try:
            yield
        finally:
            task.cancel()


@pytest.fixture(scope="session")
def loaded() -> LoadedSite:
    pytest.importorskip("foxglove", reason="foxglove-sdk is not installed")
    return load_site("bsen", foxglove__enabled=True, foxglove__port=0)


@pytest.fixture
def live(loaded: LoadedSite) -> Iterator[Callable[..., Live]]:
    """Open live views of the room, with other values of its site."""
    from housefly.foxglove.channels import channels_of
    from housefly.foxglove.process import LiveView

    with contextlib.ExitStack() as stack:

        def opened(**values: Any) -> Live:
            site = changed(loaded.site, **values) if values else loaded.site
            shown = LoadedSite(site, loaded.room, loaded.grid)
            bus = stack.enter_context(LocalBus())
            view = LiveView(shown, bus)
            thread = threading.Thread(target=view.run, daemon=True)
            thread.start()
            stack.callback(view.close)
            stack.callback(thread.join)
            stack.callback(view.end)
            return Live(shown, view, Talker(bus, site), len(channels_of(site)))

        yield opened
