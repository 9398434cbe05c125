"""Certificates of verdicts and their checker, which sees the model and never the solver."""
