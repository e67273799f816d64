# SPDX-License-Identifier: BSD-3-Clause
"""What can be said of the points of a line."""

import math
from dataclasses import dataclass

_NO_ERROR = 1e-12  # what counts as none in a logarithm


@dataclass
class PowerLaw:
    """y = factor * x ** exponent"""

    factor: float
    exponent: float

    def __call__(self, x):
        return self.factor * x ** self.exponent


def fit(xs, ys):
    """The power law by least squares of the logarithms; None with less than two different x above
    zero."""
    points = [(math.log(x), math.log(y)) for x, y in zip(xs, ys) if x > 0 and y > 0]
    n = len(points)
    x, y = sum(a for a, _ in points), sum(b for _, b in points)
    spread = n * sum(a * a for a, _ in points) - x * x
    if n < 2 or not spread > 1e-9:
        return None
    exponent = (n * sum(a * b for a, b in points) - x * y) / spread
    return PowerLaw(math.exp((y - exponent * x) / n), exponent)


def interpolate(xs, ys, x):
    """The value at x, between the nearest two points, linear in the logarithms; None beyond the
    ends. The points are sorted by x."""
    def log(value):
        return math.log(max(value, _NO_ERROR))

    for (x0, y0), (x1, y1) in zip(zip(xs, ys), zip(xs[1:], ys[1:])):
        if x0 <= x <= x1 and x0 < x1:
            along = (log(x) - log(x0)) / (log(x1) - log(x0))
            return math.exp(log(y0) + along * (log(y1) - log(y0)))
    return None
