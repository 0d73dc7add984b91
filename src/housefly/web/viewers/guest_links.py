"""One-time links that viewers make for others, and what is told when one is used."""

from __future__ import annotations

from collections.abc import Callable

from housefly.messages.words import Words
from housefly.web.access.invitations import Invitation
from housefly.web.access.roles import Role
from housefly.web.access.session_auth import SessionAuth
from housefly.web.http.qr_code import qr_view
from housefly.web.messages.client_messages import InviteRequest
from housefly.web.messages.server_messages import InvitationUsed, InviteReply
from housefly.web.viewers.viewer import Viewer

_MAX_HOSTS = 200
"""Links whose makers are told when they are used."""
_GUEST_WORDS = {
    Role.WATCH: Words("it may watch"),
    Role.ASK: Words("it may watch and ask"),
    Role.FLY: Words("it may fly"),
    Role.ADMIN: Words("it may do everything"),
}


class GuestLinks:
    """Makes links, and remembers who made which.

    Args:
        auth: what a link is exchanged at.
        address: of this console as guests see it; "" when they have none to come by.
        tell: takes a line that everybody reads.
        record: takes a line for the audit log.
    """

    def __init__(
        self,
        auth: SessionAuth,
        address: str,
        tell: Callable[[Words], None],
        record: Callable[[str], None],
    ) -> None:
        self._auth, self._address, self._tell, self._record = auth, address, tell, record
        self._hosts: dict[str, Viewer] = {}
        auth.on_guest = self._used

    def make(self, viewer: Viewer, message: InviteRequest) -> InviteReply:
        """Return a link for a guest; raises MissingPartError where no code can be drawn of it."""
        invitation = self._auth.invite(Role(message.role))
        self._hosts[invitation.name] = viewer
        while len(self._hosts) > _MAX_HOSTS:
            del self._hosts[next(iter(self._hosts))]
        path, origin = f"/?token={invitation.token}", self._address
        qr = qr_view(origin + path) if origin else None
        return InviteReply(message.id, invitation.name, origin, path, invitation.until, qr)

    def _used(self, invitation: Invitation) -> None:
        """Tell everybody that a link was used, and who made it by whose link somebody came."""
        host = self._hosts.pop(invitation.name, None)
        by = Words("the link of the terminal")
        if host is not None:
            by = Words("the link that {who} made", who=host.name)
        may = _GUEST_WORDS[invitation.role]
        self._tell(Words("a browser came in by {link}: {what}", link=by, what=may))
        self._record(f"a one-time link was used: {invitation.role.value}, by {by}")
        if host is not None:
            host.send(InvitationUsed(invitation.name))
