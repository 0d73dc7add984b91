"""Client of a running room: its discovery, and its questions over HTTP or a loopback line."""
