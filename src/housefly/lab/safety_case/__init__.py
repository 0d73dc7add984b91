"""The safety case: every fault of the matrix, in every phase, in thousands of seeded flights."""
