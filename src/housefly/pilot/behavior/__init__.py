"""The finite state acceptor (paper V-B), the reference, and the mission."""
