"""Answers as learning management systems, forms and spreadsheets give them out, made into the
exam's answer sheet.
"""
