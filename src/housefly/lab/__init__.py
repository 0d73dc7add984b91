"""Experiments with simulated drones: campaigns, gains, identification, the paper's reproduction."""
