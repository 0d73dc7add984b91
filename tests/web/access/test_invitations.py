"""One-time links: each once, for ten minutes, and nobody makes one without the run's secret."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.clock import SteppedClock
from housefly.web.access.invitations import INVITATION_LIFE, Invitations
from housefly.web.access.roles import Role


def test_a_link_that_the_terminal_made_opens_one_browser_with_its_role() -> None:
    clock = SteppedClock(5000.0)
    terminal, console = Invitations("secret", clock), Invitations("secret", clock)
    for role in Role:
        link = terminal.new(role)
        found = console.redeemed(link.token)
        assert found is not None and (found.role, found.name) == (role, link.name)
        assert console.redeemed(link.token) is None


@pytest.mark.parametrize(("wait", "opens"), [(INVITATION_LIFE - 2, True), (INVITATION_LIFE, False)])
def test_a_link_is_over_after_ten_minutes(wait: float, opens: bool) -> None:
    clock = SteppedClock(5000.9)
    invitations = Invitations("secret", clock)
    link = invitations.new(Role.WATCH)
    clock.advance(wait + 0.5)
    assert (invitations.redeemed(link.token) is not None) is opens


def test_a_link_of_another_run_opens_nothing() -> None:
    clock = SteppedClock()
    link = Invitations("another secret", clock).new(Role.ADMIN)
    assert Invitations("secret", clock).redeemed(link.token) is None


@given(place=st.integers(0, 43), letter=st.sampled_from("ABCXYZabcxyz059-_"))
def test_no_letter_of_a_link_can_be_changed(place: int, letter: str) -> None:
    invitations = Invitations("secret", SteppedClock())
    token = invitations.new(Role.WATCH).token
    forged = token[:place] + letter + token[place + 1 :]
    assert forged == token or invitations.redeemed(forged) is None


@given(text=st.text())
def test_what_is_no_link_opens_nothing(text: str) -> None:
    assert Invitations("secret", SteppedClock()).redeemed(text) is None


def test_links_do_not_repeat_and_fit_a_small_qr_code() -> None:
    invitations = Invitations("secret", SteppedClock())
    tokens = {invitations.new(Role.WATCH).token for _ in range(100)}
    assert len(tokens) == 100 and all(len(token) == 44 for token in tokens)
