"""A room that knows where everything is flies a small drone on errands."""
