"""Pages: each one HTML file that needs nothing from outside."""
