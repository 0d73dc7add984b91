"""One pilot for one drone: estimation, planning, behavior, control and safety as one pure step."""
