"""Exact numbers, fields of real numbers, arrays of them, and bounds for floats."""
