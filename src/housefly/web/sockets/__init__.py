"""The open consoles: what they send, and what all of them are sent."""
