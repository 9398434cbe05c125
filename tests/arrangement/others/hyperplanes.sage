(Hyperplane 0*x + y + 0, Hyperplane x - y + 5, Hyperplane x + 0*y + 0, Hyperplane x + y - 1, Hyperplane 12*x - 3*y + 14)
