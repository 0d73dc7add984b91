from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.web.status.console_memory import KnownTab
from housefly.web.viewers.tab_numbers import TABS_KEPT, TABS_OF_ONE, TabNumbers

VISITS = st.lists(st.tuples(st.integers(0, 40), st.integers(0, 40)), max_size=600)


def test_a_tab_that_comes_back_has_its_number_and_its_name() -> None:
    tabs = TabNumbers()
    assert tabs.number_for("anna", "one", set()) == 1
    tabs.rename("anna", "one", "Anna")
    assert tabs.number_for("ben", "one", set()) == 2
    assert tabs.number_for("anna", "one", set()) == 1
    assert (tabs.name_of(1), tabs.name_of(7), tabs.name_of(None)) == ("Anna", "", "")
    again = TabNumbers(tabs.kept())
    assert again.kept() == tabs.kept() and again.number_of("anna", "one") == 1
    assert again.number_for("ben", "two", set()) == 3


def test_of_one_owner_the_tab_that_is_away_for_longest_is_forgotten() -> None:
    tabs = TabNumbers()
    tabs.number_for("anna", "hers", set())
    numbers = {name: tabs.number_for("eve", name, set()) for name in map(str, range(TABS_OF_ONE))}
    tabs.number_for("eve", "1", set())
    tabs.number_for("eve", "another", {numbers["0"]})
    assert tabs.number_of("eve", "2") is None
    assert tabs.number_of("eve", "0") == numbers["0"] and tabs.number_of("eve", "1") is not None
    assert tabs.number_of("anna", "hers") == 1, "who floods takes nobody else's place"


def test_too_many_that_were_kept_are_forgotten_as_soon_as_somebody_comes() -> None:
    kept = [KnownTab("eve", str(n), n, "Eve") for n in range(1, 10_001)]
    tabs = TabNumbers([KnownTab("anna", "hers", 10_001, "Anna"), *kept])
    assert tabs.number_for("ben", "his", {1}) == 10_002
    assert len(tabs.kept()) == TABS_KEPT
    assert tabs.number_of("eve", "1") == 1 and tabs.number_of("eve", "2") is None


@given(VISITS)
def test_few_are_remembered_and_no_number_is_given_twice(visits: list[tuple[int, int]]) -> None:
    tabs, given_to = TabNumbers(), dict[int, tuple[str, str]]()
    for owner, tab in visits:
        who = (str(owner), str(tab))
        number = tabs.number_for(*who, set())
        assert given_to.setdefault(number, who) == who
        owners = [one.owner for one in tabs.kept()]
        assert len(owners) <= TABS_KEPT and owners.count(who[0]) <= TABS_OF_ONE
