"""
A sheet of your own: outline, material, modes
=============================================

A polygon of silicone, by modulus, thickness and mass, and how it rings without a plate.
"""

import math

import plategait as pg

corners = (("0 mm", "0 mm"), ("80 mm", "0 mm"), ("60 mm", "60 mm"), ("10 mm", "50 mm"))
silicone = pg.Sheet.from_material(
    pg.Polygon(corners=corners), "0.5 MPa", thickness="1 mm", mass="5 g", poisson_ratio=0.5, loss_factor=0.1,
    pitch="5 mm",
)  # fmt: skip
print(f"natural frequency {silicone.natural_frequency / math.pi:.2f} pi rad/s")

# %%
# The modes, softest first.

from plategait.plots.figures import plot_modes  # noqa: E402

figure = plot_modes(silicone)
