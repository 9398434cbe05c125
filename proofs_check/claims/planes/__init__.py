"""Claims on arrangements: counts, the dual, the steps as printed, the sphere, families."""
