"""What every request passes: bounds, pace, pages, languages."""
