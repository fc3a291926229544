"""
A spin curve and its Lorentz fit
================================

Spin rate over the plate's frequency, two starts for each point. Failed runs are left out of the fit.
"""

import plategait as pg

cheese = pg.preset("cheese").scenario.replace(duration="2 s")
curve = pg.spin_curve(cheese, "13:28:1Hz", repeats=2)
assert curve.fit is not None, curve.no_fit
print(f"f0 = {curve.fit.f0_hz:.1f} Hz, {curve.fit.peak:.0f} deg/s")

figure = curve.plot()
