"""The simulated room behind real wires."""
