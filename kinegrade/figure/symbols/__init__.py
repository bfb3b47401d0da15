"""The symbols of kinematic diagrams (ISO 3952, GB/T 4460) in millimetres, at a point, in a
direction.
"""
