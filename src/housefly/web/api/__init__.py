"""The room, its tasks and its places over HTTP."""
