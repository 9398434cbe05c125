"""Records of what was checked, as JSON, text, Markdown and HTML."""
