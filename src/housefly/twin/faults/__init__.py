"""Faults of the simulated room: what lies, fails or arrives late, when, and by how much."""
