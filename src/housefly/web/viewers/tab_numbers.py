"""Numbers and names of the tabs that were open; a few of each owner are remembered."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace

from housefly.web.status.console_memory import KnownTab

TABS_OF_ONE = 16
"""Tabs of one owner of a session that are remembered; more than it may have open."""
TABS_KEPT = 256
"""Tabs that are remembered in all; more than may be open."""


class TabNumbers:
    """Gives each tab a number that no other had, and forgets the oldest that are not here.

    Args:
        tabs: what an earlier console kept.
    """

    def __init__(self, tabs: Iterable[KnownTab] = ()) -> None:
        self._tabs = {(one.owner, one.tab): one for one in tabs}
        self.newest = max((one.number for one in self._tabs.values()), default=0)

    def number_of(self, owner: str, tab: str) -> int | None:
        """Return the number of a tab, or None of one that is not known."""
        found = self._tabs.get((owner, tab))
        return found.number if found else None

    def name_of(self, number: int | None) -> str:
        """Return the name that others saw, or ""."""
        return next((one.name for one in self._tabs.values() if one.number == number), "")

    def number_for(self, owner: str, tab: str, here: Collection[int]) -> int:
        """Return the number of a tab that is here now, a fresh one when it is not known.

        Args:
            owner: of its session.
            tab: as its page calls itself.
            here: numbers that must not be forgotten.
        """
        found = self._tabs.pop((owner, tab), None)
        if found is None:
            self._forget([key for key in self._tabs if key[0] == owner], TABS_OF_ONE, here)
            self._forget(list(self._tabs), TABS_KEPT, here)
            self.newest += 1
            found = KnownTab(owner, tab, self.newest, "")
        self._tabs[owner, tab] = found
        return found.number

    def rename(self, owner: str, tab: str, name: str) -> None:
        """Note the name that others see of a known tab."""
        self._tabs[owner, tab] = replace(self._tabs[owner, tab], name=name)

    def kept(self) -> tuple[KnownTab, ...]:
        """Return all that is remembered; who was here last comes last."""
        return tuple(self._tabs.values())

    def _forget(self, keys: list[tuple[str, str]], most: int, here: Collection[int]) -> None:
        """Make room for one more."""
        absent = [key for key in keys if self._tabs[key].number not in here]
        for key in absent[: max(0, len(keys) - most + 1)]:
            del self._tabs[key]
