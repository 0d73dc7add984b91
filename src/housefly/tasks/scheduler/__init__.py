"""What flies when: a queue with priorities as a pure value, and its file that survives a crash."""
