"""What benchmarks and tests score on the truth: memory, visitor runs, stability of a hover."""
