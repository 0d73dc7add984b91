"""What can be asked of the tasks, what they answer, and the JSON of both."""
