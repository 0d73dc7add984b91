"""The console's listening socket: the launcher keeps it for the whole run, the console accepts.

So no other user takes the port while a console that died is not yet started again.
"""

from __future__ import annotations

import os
import socket
import weakref

from housefly.errors import ConfigError
from housefly.web.http.handshakes import HandshakeListener


class ConsolePort:
    """A TCP port that listens while this object exists, for web processes that inherit its socket.

    Nobody accepts here: who connects waits for a web process.

    Args:
        host: address of this machine.
        port: 0 takes a free one.

    Attributes:
        number: of the port.
        descriptor: of the socket; no child inherits it that is not given it by name.

    Raises:
        ConfigError: the address cannot be had.
    """

    def __init__(self, host: str, port: int) -> None:
        listener = listening(host, port)
        self._close = weakref.finalize(self, listener.close)
        self.number = int(listener.getsockname()[1])
        self.descriptor = listener.fileno()

    def close(self) -> None:
        """Hold it no longer; web processes that have the socket keep it."""
        self._close()


def listening(host: str, port: int) -> HandshakeListener:
    """Return a socket that listens; raises ConfigError when the address cannot be had."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    # Without the protocol asyncio leaves Nagle on, and every answer waits 40 ms for an
    # acknowledgement.
    listener = HandshakeListener(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((host, port))
        # Browsers that connect before the application is up wait instead of being refused.
        listener.listen()
    except OSError as error:
        listener.close()
        raise ConfigError(
            "web.port",
            f"cannot listen on {host} port {port} ({error.strerror}); choose another port",
        ) from error
    return listener


def inherited_listener(descriptor: int) -> HandshakeListener:
    """Return the socket of a ``ConsolePort`` of the launcher; raises ConfigError for anything else.

    Args:
        descriptor: under which this process has it; its own children do not get it.
    """
    try:
        os.set_inheritable(descriptor, False)
        listener = HandshakeListener(fileno=descriptor)
        if listener.getsockopt(socket.SOL_SOCKET, socket.SO_ACCEPTCONN):
            return listener
        listener.detach()
        problem = "does not listen"
    except (OSError, OverflowError, ValueError) as error:
        problem = str(error)
    raise ConfigError(
        "--listener", f"file descriptor {descriptor} is no socket that listens: {problem}"
    )
