"""Claims over very many cases: stored, resumed, in processes, in parts."""
