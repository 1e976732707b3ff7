# SPDX-License-Identifier: MIT
"""A linear function of control points as a sum of others, in small parts.

Theorem. Let |row_i . c| <= 1 and |c_j| <= most. Then with any numbers u, |w . c| <= sum |u_i| + most sum |w - sum u_i row_i|. `small_sum` finds
u in doubles for which that is small: least squares of u, weighted again and again by the sizes that u had, tend to the least sum of sizes.
"""
from .conditions import eliminated

ROUNDS = 12
LEAST_WEIGHT = 1e-9  # of the largest: what became small may grow again


def left_of(weights, rows, u):
    left = dict(weights)
    for row, factor in zip(rows, u):
        for j, w in row.items():
            left[j] = left.get(j, 0.0) - factor * w
    return left


def least_squares(weights, rows, squares):
    """u of least sum u_i^2 / squares_i with sum u_i row_i = weights; None: no such u was found."""
    places = {j: i for i, j in enumerate({j for row in rows for j in row} | set(weights))}
    matrix = [[0.0] * len(places) for _ in places]
    for row, square in zip(rows, squares):
        for j, w in row.items():
            line = matrix[places[j]]
            for other, own in row.items():
                line[places[other]] += square * w * own
    found = eliminated([line + [weights.get(j, 0.0)] for line, j in zip(matrix, places)])
    return found and [square * sum(w * found[places[j]][0] for j, w in row.items()) for row, square in zip(rows, squares)]


def small_sum(weights, rows, most):
    """u of the theorem, for functions {control point: weight} in doubles."""
    best, squares = ([0.0] * len(rows), most * sum(map(abs, weights.values()))), [1.0] * len(rows)
    for _ in range(ROUNDS if best[1] else 0):
        u = least_squares(weights, rows, squares)
        if not u:
            break
        size = sum(map(abs, u)) + most * sum(map(abs, left_of(weights, rows, u).values()))
        best = min(best, (u, size), key=lambda own: own[1])
        squares = [abs(own) + LEAST_WEIGHT * max(map(abs, u)) for own in u]
    return best[0]
