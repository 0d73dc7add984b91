"""Ask a running room: where it is to be found, and a client for its HTTP API."""
