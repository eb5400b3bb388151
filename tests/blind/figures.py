"""Counts with exact intervals, and plain order statistics."""

import math


def _log_term(n, k, p):
    if p <= 0.0 or p >= 1.0:
        certain = (p <= 0.0 and k == 0) or (p >= 1.0 and k == n)
        return 0.0 if certain else -math.inf
    choose = math.lgamma(n + 1) - math.lgamma(k + 1) - math.lgamma(n - k + 1)
    return choose + k * math.log(p) + (n - k) * math.log1p(-p)


def at_most(n, k, p):
    """Probability of k or fewer of n."""
    return min(1.0, sum(math.exp(_log_term(n, i, p)) for i in range(k + 1)))


def _solve(is_low):
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return (low + high) / 2


def interval(k, n, level=0.95):
    """Clopper and Pearson's exact interval of a share."""
    if n == 0:
        return 0.0, 1.0
    tail = (1 - level) / 2
    low = 0.0 if k == 0 else _solve(lambda p: 1 - at_most(n, k - 1, p) < tail)
    high = 1.0 if k == n else _solve(lambda p: at_most(n, k, p) > tail)
    return low, high


def quantile(values, share):
    """Linear between order statistics; None of nothing."""
    if not values:
        return None
    ordered = sorted(values)
    place = share * (len(ordered) - 1)
    left = int(math.floor(place))
    right = min(left + 1, len(ordered) - 1)
    return ordered[left] + (place - left) * (ordered[right] - ordered[left])


def mean(values):
    return sum(values) / len(values) if values else None
