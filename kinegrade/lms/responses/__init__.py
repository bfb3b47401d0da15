"""Answers as downloaded from learning management systems, forms and spreadsheets, converted to the
exam's answer sheet.
"""
