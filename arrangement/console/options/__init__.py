"""Options of commands: how values are written, what functions say of theirs, and the parser."""
