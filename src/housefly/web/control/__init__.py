"""Who flies, what they order, and STOP."""
