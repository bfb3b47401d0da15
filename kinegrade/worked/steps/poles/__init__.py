"""The velocity pole of a body in a worked solution: how it is found, and what follows from it."""
