"""The last gate before the drone: may only make a command smaller."""
