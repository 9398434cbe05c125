"""Claims of users: their files, how they are tried, how a counterexample is made small."""
