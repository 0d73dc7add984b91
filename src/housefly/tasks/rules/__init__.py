"""Rules: when something happens in the room and the mode allows it, a task is asked for."""
