"""Client of a running room: its discovery, and its questions over HTTP or the hub's socket."""
