"""From a template and values to a mechanism, in any arithmetic."""
