"""What instruments add to a reading: white and autocorrelated noise, run offsets, heavy tails, outliers, rounding,
missing cells."""

import numpy as np


class Noise:
    """Shares of the variance of one case; together they make the repeatability."""

    def __init__(self, rng):
        self.rng = rng
        self.run_share = rng.uniform(0.02, 0.15)
        self.slow_share = rng.choice([0.0, rng.uniform(0.1, 0.35)])
        self.slow_length = rng.uniform(2.0, 10.0)
        self.tails = rng.choice([0, 5])          # degrees of freedom of Student's t; 0: normal
        self.outliers = rng.choice([0.0, 0.004, 0.01])
        self.missing = rng.choice([0.0, 0.01, 0.03])
        self.declared = rng.choice([1.0, 1.0, 1.0, 0.8, 1.25, 0.0])  # of the true repeatability; 0: not declared
        self.rounding = rng.choice([0.02, 0.1, 0.4])                 # of sigma

    def _white(self, n):
        if self.tails == 0:
            return self.rng.normal(size=n)
        return self.rng.standard_t(self.tails, size=n) / np.sqrt(self.tails / (self.tails - 2))

    def _slow(self, n):
        keep, out = np.exp(-1 / self.slow_length), np.empty(n)
        value = self.rng.normal()
        for i in range(n):
            value = keep * value + np.sqrt(1 - keep**2) * self.rng.normal()
            out[i] = value
        return out

    def of_run(self, n):
        """Noise of one run of n samples, of unit variance over many runs."""
        white = 1.0 - self.run_share - self.slow_share
        noise = np.sqrt(white) * self._white(n) + np.sqrt(self.slow_share) * self._slow(n)
        noise = noise + np.sqrt(self.run_share) * self.rng.normal()
        hit = self.rng.random(n) < self.outliers
        return noise + hit * self.rng.choice([-1, 1], n) * self.rng.uniform(6, 15, n)

    def resolution(self, sigma):
        """A round step of the display: 1, 2 or 5 times a power of ten."""
        wanted = sigma * self.rounding
        power = 10.0 ** np.floor(np.log10(wanted))
        return float(power * max(k for k in (1, 2, 5) if k * power <= wanted * 1.0001))

    def observe(self, file, column, truth):
        """The readings that the instrument shows; NaN where one is missing."""
        sigma, values = file.sigma_of(column), np.array(truth, float)
        for index in np.unique(file.whole.run_index):
            rows = file.whole.run_index == index
            values[rows] += sigma * self.of_run(int(rows.sum()))
        step = self.resolution(sigma)
        values = np.round(values / step) * step
        values[self.rng.random(len(values)) < self.missing] = np.nan
        return values

    def declared_sigma(self, file, unit):
        return file.sigma[unit] * self.declared if self.declared else None

    def text(self):
        return {key: float(value) for key, value in self.__dict__.items() if key != "rng"}
