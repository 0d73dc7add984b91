"""The frame check: a person carries the drone, and tracking is held against what was asked."""
