"""The safety gate, the last before the drone: may only make a command smaller."""
