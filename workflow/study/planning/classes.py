"""What a cell can do in the array, as the solver labels it."""

#: Classes that say what a cell does.
DECIDED = ("displaced", "zigzag")
