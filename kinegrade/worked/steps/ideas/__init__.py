"""The idea of a solution, before its steps: what is known and sought, and why each way serves."""
