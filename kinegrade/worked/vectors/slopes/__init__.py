"""Directions by named angles: those that the statement gives, and those that a solution derives."""
