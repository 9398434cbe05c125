"""Records of what was checked, as JSON, Markdown, HTML and LaTeX."""
