"""Spin curves become material parameters, with intervals (chapter 5)."""
