"""Says where the console is: the address for this machine, a QR code for a phone."""

from __future__ import annotations

import os
import select
import sys
from contextlib import suppress

from rich.text import Text

from housefly.app.runtime import Runtime
from housefly.app.terminal import console
from housefly.clock import RealClock
from housefly.web.access.exposure import console_address, guest_address
from housefly.web.access.invitations import INVITATION_LIFE, Invitations
from housefly.web.access.roles import Role
from housefly.web.http.qr_code import qr_lines

_ROLE = Role.FLY
"""What the phone of who sits at the terminal may do; the words say it."""


class ConsoleAddresses:
    """Prints addresses of a run's console.

    Args:
        runtime: of the run.
    """

    def __init__(self, runtime: Runtime) -> None:
        self._runtime = runtime
        self._site = runtime.site()
        self._invitations = Invitations(runtime.secret, RealClock())

    def print_address(self) -> None:
        """Print the address, and an invitation where other machines get in."""
        address = f"{console_address(self._site)}/?token={self._runtime.token}"
        console.print(f"console:  [bold]{address}[/bold]  (works once)", soft_wrap=True)
        if guest_address(self._site):
            self._print_invitation()

    def print_asked_invitation(self) -> None:
        """Print a fresh invitation when somebody has pressed Enter."""
        if guest_address(self._site) and _enter_was_pressed():
            self._print_invitation()

    def _print_invitation(self) -> None:
        host = guest_address(self._site)
        link = f"{host}/?token={self._invitations.new(_ROLE).token}"
        minutes = f"{INVITATION_LIFE / 60:.0f} minutes"
        if not console.is_terminal:
            console.print(f"phone:    {link}  (works once, for {minutes})", soft_wrap=True)
            return
        code = Text("\n".join(qr_lines(link)), style="#ffffff on #000000", no_wrap=True)
        console.print(code)
        console.print(f"phone:    {link}", style="dim", soft_wrap=True)
        console.print(
            f"Point a phone of this network at it; it may then fly. Works once, for {minutes};"
            f" Enter makes a fresh one. A new phone first opens {host}/authority.crt, as `housefly"
            " cert` tells."
        )


def _enter_was_pressed() -> bool:
    """Return whether a line was typed; reads nothing that is typed for another program."""
    with suppress(OSError, ValueError):
        descriptor = sys.stdin.fileno()
        in_front = os.isatty(descriptor) and os.tcgetpgrp(descriptor) == os.getpgrp()
        if in_front and select.select([descriptor], [], [], 0.0)[0]:
            return os.read(descriptor, 1024).endswith(b"\n")
    return False
