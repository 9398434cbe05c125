"""For courses: exercises that are graded, and numbers in print compared with computed ones."""
