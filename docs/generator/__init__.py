"""Writes the reference from the tables that kinegrade itself reads; nothing is typed twice."""
