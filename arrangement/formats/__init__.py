"""Formats: the own documents, and the languages of others. One module each, one table."""
