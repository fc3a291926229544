"""One function for each figure and table of the dissertation."""
