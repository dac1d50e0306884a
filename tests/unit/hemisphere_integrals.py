#!/usr/bin/env python3
"""Prints hemisphere_integrals.txt by mpmath: a quarter of an hour. It shares no formula with the product.

A circle of the angle r around w lies in the hemisphere for the azimuths from -a to a around w, where
cos(a) = -(c / s) cot(r), c and s the cosine and sine of the angle between w and the up axis. So z is an integral over r
alone, and zz is the integral of z over the hemisphere.
"""
from mpmath import acos, asin, cos, cot, exp, mp, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 40
COSINES = "0 1e-12 1e-6 0.001 0.1 0.3 0.5 0.75 0.9 0.999999 1".split()


def covariance(kernel, parameter):
    if kernel == "squared_exponential":
        return lambda r: exp(-((2 * sin(r / 2) / parameter) ** 2) / 2)
    return lambda r: 2 ** (2 * parameter - 1) / parameter - (2 * sin(r / 2)) ** (2 * parameter - 2)


def z(k, c, known_cosine):
    s = sqrt(1 - c * c)

    def over_circle(r):
        a = pi if r <= asin(c) else 0 if r >= pi - asin(c) else acos(max(-1, min(1, -c / s * cot(r))))
        return k(r) * sin(r) * (2 * (a * c * cos(r) + s * sin(r) * sin(a)) if known_cosine else 2 * a)

    # A short length-scale takes pieces in which the covariance changes little.
    pieces = {mpf(0), asin(c), pi / 2, pi - asin(c)} | {mpf(2) ** -i for i in range(7)}
    return quad(over_circle, sorted(p for p in pieces if p <= pi - asin(c)))


print('R"(')  # a literal of C++, which a test includes
print("kernel parameter", *COSINES, "zz")
for kernel, parameters in [
    ("sobolev", "1.01 1.1 1.4 1.5 1.9 1.99"),
    ("squared_exponential", "0.05 0.1 0.5 1 3 100"),
    ("sobolev_cosine", "1.5"),
]:
    for parameter in parameters.split():
        k, known = covariance(kernel, mpf(parameter)), kernel == "sobolev_cosine"
        row = [z(k, mpf(c), known) for c in COSINES]
        mp.dps = 25
        row.append(2 * pi * quad(lambda c: z(k, c, known) * (c if known else 1), [0, 0.01, 0.1, 0.5, 1]))
        mp.dps = 40
        print(kernel, parameter, *(nstr(each, 20) for each in row), flush=True)
print(')"')
