"""The WebSocket of a console: what each message does, and what all are sent."""
