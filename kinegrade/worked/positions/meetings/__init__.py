"""Where lines and circles meet."""
