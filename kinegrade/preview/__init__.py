"""`kinegrade preview`: a page in the browser that follows a template or a bank while it is
written.
"""
