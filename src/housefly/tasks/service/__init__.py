"""Who is asked: requests, sentences, notices, and every question to the tasks."""
