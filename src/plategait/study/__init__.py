"""Studies: questions that the dissertation leaves open, answered with numbers and their uncertainty."""
