"""Rotations as curved arrows about pivots."""
