"""How large the study of the source's unknowns is, unless asked otherwise."""

SEEDS = 3
"""Independent searches."""
FIRST, GENERATIONS = 48, 5
"""Evaluations of each seed over the priors, and generations of the evolution strategy from the best of them."""
