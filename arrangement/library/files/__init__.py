"""Files of arrangements: the own documents, and the formats of others."""
