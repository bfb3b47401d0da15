"""What the table below a vector equation states of each vector: its magnitude and direction."""
