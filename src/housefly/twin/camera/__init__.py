"""The simulated camera of the drone: rendered and encoded in a process of its own."""
