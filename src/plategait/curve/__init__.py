"""Spin curves: how they are measured, their peak, their Lorentz fit."""
