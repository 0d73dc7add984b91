"""Task documents: what a task does, written by people, read and checked."""
