"""Whose papers are whose: spare ones that are assigned, and papers that change hands."""
