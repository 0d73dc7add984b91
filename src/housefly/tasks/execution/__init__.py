"""Runs one task: a behavior tree, ticked with what is known, answers with what is to be done."""
