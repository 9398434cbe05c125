"""The figures and tables of the paper, each made again and set beside what is printed."""
