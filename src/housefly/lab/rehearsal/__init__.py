"""Rehearsals: a task is flown in simulation before a person says yes."""
