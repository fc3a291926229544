"""Bench recordings become joint parameters (section 3.3)."""
