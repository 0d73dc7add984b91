"""Asks the tasks of a room that runs on this machine."""
