"""The open consoles: who they are, and the queue to each."""
