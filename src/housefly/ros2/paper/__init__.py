"""The names of the paper's own drone node, for nodes that were written for it."""
