"""Opening the files that people name."""
