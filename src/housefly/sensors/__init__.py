"""Drivers of the room's sensors: devices that report where things are and what happened."""
