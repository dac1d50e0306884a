# The Gaussian process of the sheet's Python base code, written from its description; it shares no line with ours.
# The covariance is Sobolev's of smoothness 1.4, the noise 0.01; z is a mean over 50,000 random directions, and the
# weights are z times the inverse of Q. Standard input has a direction "x y z" in each line.
import math
import random
import sys
from types import SimpleNamespace


def k(a, b):
    return 2**1.8 / 1.4 - math.dist((a.x, a.y, a.z), (b.x, b.y, b.z)) ** 0.8


def direction(x, y, z):
    return SimpleNamespace(x=x, y=y, z=z)


def random_direction():
    y, angle = random.random(), 2 * math.pi * random.random()
    return direction(math.sqrt(1 - y * y) * math.cos(angle), y, math.sqrt(1 - y * y) * math.sin(angle))


def inverse(matrix):  # by Gauss and Jordan's elimination
    n = len(matrix)
    rows = [row + [float(i == j) for j in range(n)] for i, row in enumerate(matrix)]
    for p in range(n):
        rows[p] = [element / rows[p][p] for element in rows[p]]
        for i in range(n):
            if i != p:
                rows[i] = [a - rows[i][p] * b for a, b in zip(rows[i], rows[p])]
    return [row[n:] for row in rows]


random.seed(1)
samples = [direction(*map(float, line.split())) for line in sys.stdin]
around = [random_direction() for _ in range(50000)]
Q = [[k(a, b) + (0.01**2 if a is b else 0) for b in samples] for a in samples]
z = [2 * math.pi / 50000 * sum(k(a, b) for b in around) for a in samples]
invQ = inverse(Q)
weights = [sum(a * b for a, b in zip(row, z)) for row in invQ]
gp = SimpleNamespace(samples_pos=samples, Q=Q, invQ=invQ, z=z, weights=weights)
