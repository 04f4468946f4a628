"""Makes the coefficients of eta_fit.h: a fit, weighted minimax, of the slope of η(θ) over (ρ, f, θ). Needs numpy.

The slope is linear in the coefficients, so Lawson's iteration (least squares with weights that grow where the error is
largest) finds them. Relative to what ρ^(i + 1) leaves of the errors, small ρ count more: most points are like that.
"""
import numpy as np

LARGEST_RHO = 1 / 3  # k' = 1/2
# p_i = f ρ^(i+1) Σ_j ρ^2j (a polynomial in f): the numbers of its coefficients
COUNTS = ((1, 3, 2), (2, 3), (3, 1), (3,), (2,))
TERMS = [(i, j, m) for i, by_j in enumerate(COUNTS) for j, count in enumerate(by_j) for m in range(count)]


def rim_height(rho, f, doubled_eta):
    return f / (1 - f) * np.abs(1 - rho * np.exp(1j * doubled_eta))


def uniform_angle(rho, f, doubled_eta, nodes=256):
    """2θ and dη/dθ at these 2η, exact but for rounding: the midpoint rule converges geometrically."""
    at = 2 * np.pi * (np.arange(nodes) + 0.5) / nodes
    g = 1 / (1 + rim_height(rho, f, at))
    k = np.arange(1, nodes // 4)
    series = 2 * np.mean(g * np.cos(np.outer(k, at)), axis=1) / (k * g.mean())
    return doubled_eta + np.sin(np.outer(doubled_eta, k)) @ series, g.mean() * (1 + rim_height(rho, f, doubled_eta))


def columns(doubled_theta, rho, f):
    """dη/dθ − 1 = cos 2θ P − sin² 2θ P', for each coefficient."""
    x, s2 = np.cos(doubled_theta), np.sin(doubled_theta) ** 2
    return np.stack([f ** (m + 1) * rho ** (i + 1 + 2 * j) * (x ** (i + 1) - (i * s2 * x ** (i - 1) if i else 0))
                     for i, j, m in TERMS], axis=1)


def fit():
    doubled_eta = np.pi * (np.arange(25) + 0.5) / 25
    design, target, weight = [], [], []
    for rho in LARGEST_RHO * np.arange(1, 33) / 32:
        for f in 0.25 * (1 - np.cos(np.pi * (np.arange(16) + 0.5) / 16)):
            doubled_theta, slope = uniform_angle(rho, f, doubled_eta)
            design.append(columns(doubled_theta, rho, f))
            target.append(slope - 1)
            weight.append(np.full(len(slope), (0.03 + rho / LARGEST_RHO) ** -2))
    design, target, weight = np.vstack(design), np.concatenate(target), np.concatenate(weight)
    lawson = np.ones_like(weight)
    best = np.inf
    for _ in range(200):
        root = np.sqrt(lawson) * weight
        found = np.linalg.lstsq(design * root[:, None], target * root, rcond=None)[0]
        error = np.abs(design @ found - target) * weight
        if error.max() < best:
            best, coefficients = error.max(), found
        lawson *= error + 1e-3 * error.max()
        lawson /= lawson.mean()
    return coefficients, np.abs(design @ coefficients - target).max()


if __name__ == "__main__":
    values, largest = fit()
    for (i, j, m), value in zip(TERMS, values):
        print(f"p_{i}: rho^{i + 1 + 2 * j} f^{m + 1}  {value:.9g}")
    print(f"largest error of the slope: {largest:.2g}")
