"""The methods that the paper compares with, each on its own page, each with a verdict of its own.

Signs follow the package: the grasp resists the wrench w when contact forces c exist with
``sum_i (c_n N_i + c_t T_i) + w = 0``. What differs is which forces a method lets arise.
"""
