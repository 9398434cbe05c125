"""Pictures as TikZ."""
