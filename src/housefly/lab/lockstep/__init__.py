"""Flights in lock step: pilot and simulated room, tick by tick, faster than real time."""
