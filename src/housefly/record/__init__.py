"""Flight recorder, replay, report."""
