"""What every command shares: arguments, progress, processes, files written whole, numbers for
people.
"""
