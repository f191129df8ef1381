"""Writes tests/data/thermography/radiometry.json: band radiances and apparent temperatures by another route than Bask's.

Usage: make_radiometry_reference.py > tests/data/thermography/radiometry.json

Bask integrates Planck's law over wavelength by Gauss's rule and stores polynomials. Here it is integrated over
ln(wavelength) by the tanh-sinh rule, in steps that are halved until nothing changes, and temperatures are found by
bisection.
"""

import json
import math

H, C, K = 6.62607015e-34, 299792458.0, 1.380649e-23
ZERO = 273.15
BAND = (8e-6, 14e-6)


def planck(wavelength, T):
    return 2.0 * H * C * C / wavelength ** 5 / math.expm1(H * C / (wavelength * K * T))


def planck_slope(wavelength, T):
    """Derivative by the temperature."""
    x = H * C / (wavelength * K * T)
    return planck(wavelength, T) * x / T / -math.expm1(-x)


def tanh_sinh(f, a, b):
    middle, half, step = (a + b) / 2.0, (b - a) / 2.0, 0.5
    last = None
    while True:
        terms = []
        for k in range(-int(4.0 / step), int(4.0 / step) + 1):
            t = k * step
            u = math.pi / 2.0 * math.sinh(t)
            weight = math.pi / 2.0 * math.cosh(t) / math.cosh(u) ** 2
            if weight > 1e-20:
                terms.append(weight * f(middle + half * math.tanh(u)))
        value = half * step * math.fsum(terms)
        if last is not None and abs(value - last) <= 2e-15 * abs(value):
            return value
        last, step = value, step / 2.0
        if step < 1e-3:
            return value


def in_band(law, T, curve):
    """Over a response that is linear between the points of `curve`."""
    parts = []
    for (a, ra), (b, rb) in zip(curve, curve[1:]):
        def integrand(ln, a=a, ra=ra, b=b, rb=rb):
            wavelength = math.exp(ln)
            return wavelength * law(wavelength, T) * (ra + (rb - ra) * (wavelength - a) / (b - a))
        parts.append(tanh_sinh(integrand, math.log(a), math.log(b)))
    return math.fsum(parts)


FLAT = [(BAND[0], 1.0), (BAND[1], 1.0)]
# Made up, in the manner of a microbolometer behind germanium.
BOLOMETER = [(7.2e-6, 0.0), (7.8e-6, 0.45), (8.4e-6, 0.82), (9.6e-6, 0.97), (10.5e-6, 1.0), (11.9e-6, 0.91), (13.1e-6, 0.66),
             (14.4e-6, 0.21), (15.6e-6, 0.0)]


def radiance(T, curve=FLAT):
    return in_band(planck, T, curve)


def temperature(L, curve=FLAT):
    low, high = 100.0, 3000.0
    while high - low > 1e-12 * high:
        middle = (low + high) / 2.0
        if middle in (low, high):
            break
        low, high = (middle, high) if radiance(middle, curve) < L else (low, middle)
    return (low + high) / 2.0


def case(face_degC, emittance, surfaces, room_degC, curve=FLAT):
    room = radiance(room_degC + ZERO, curve)
    falling = room
    for s in surfaces:
        own = s["emittance"] * radiance(s["T_degC"] + ZERO, curve) + (1.0 - s["emittance"]) * room
        falling += s["view_factor"] * (own - room)
    L = emittance * radiance(face_degC + ZERO, curve) + (1.0 - emittance) * falling
    naive = (L - (1.0 - emittance) * room) / emittance  # who takes the room for all that is reflected
    return {"face_degC": face_degC, "emittance": emittance, "surfaces": surfaces, "room_degC": room_degC,
            "curve": "flat" if curve is FLAT else "bolometer",
            "apparent_degC": temperature(L, curve) - ZERO, "naive_error_K": temperature(naive, curve) - ZERO - face_degC}


def source(F, T_degC=200.0, emittance=0.25):
    return {"view_factor": F, "T_degC": T_degC, "emittance": emittance}


cases = [case(40.0, 0.9, [source(0.3)], 25.0), case(40.0, 0.6, [source(0.3)], 25.0), case(40.0, 0.9, [source(0.9)], 25.0),
         case(40.0, 0.95, [source(0.1)], 25.0)]
for curve in (FLAT, BOLOMETER):
    for face in (15.0, 60.0, 140.0):
        for emittance in (0.3, 0.6, 0.95, 1.0):
            cases.append(case(face, emittance, [source(0.25, 300.0, 0.9), source(0.15, 150.0, 0.4), source(0.1, 80.0, 0.95)], 22.0,
                              curve))
cases.append(case(85.0, 0.8, [], 20.0))

values = [{"curve": name, "T_K": T, "radiance": radiance(T, curve), "derivative": in_band(planck_slope, T, curve)}
          for name, curve in (("flat", FLAT), ("bolometer", BOLOMETER))
          for T in (100.0, 153.7, 233.15, 273.15, 298.15, 313.15, 350.01, 473.15, 573.15, 873.9, 1500.0, 3000.0)]

if __name__ == "__main__":
    print(json.dumps({"origin": "tests/engine/thermography/make_radiometry_reference.py", "curves_m": {"flat": FLAT, "bolometer": BOLOMETER},
                      "values": values, "cases": cases}, indent=1))
