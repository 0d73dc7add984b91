"""The paper's figures and claims, made again, with the numbers that it lacks."""
