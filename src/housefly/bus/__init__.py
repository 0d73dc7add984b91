"""Topics and queries between processes."""
