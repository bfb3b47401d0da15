"""Figures in words, for those who cannot see them: derived from the template and the numbers of an
instance, as the figure is.
"""
