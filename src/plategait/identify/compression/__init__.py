"""A link that is pressed."""
