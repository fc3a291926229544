"""
Stiffer sheets spin faster, at a higher frequency
=================================================

What reading a material off a spin curve rests on: three sheets that differ in their bending stiffness alone.
"""

import matplotlib.pyplot as plt

import plategait as pg

cheese = pg.preset("cheese").scenario.replace(duration="2 s")
figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
for omega in (3.5, 10, 33):
    stiff = cheese.replace(sheet=cheese.sheet.with_natural_frequency(f"{omega} pi rad/s"))
    curve = pg.spin_curve(stiff, "14:28:2Hz")
    stayed = [not failure for failure in curve.failure]
    axes.plot(curve.frequency_hz[stayed], curve.spin_rate_deg_s[stayed], "o-", label=f"{omega:g} π rad/s")
axes.set(xlabel="plate frequency (Hz)", ylabel="spin rate (deg/s)")
axes.legend(title="natural frequency", loc="upper left", bbox_to_anchor=(1, 1))
