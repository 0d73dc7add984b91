"""The finite state acceptor (paper V-B) and the errand."""
