"""Moorings of equal uniform chains by another route than that of the package.

Closed forms of one line that lies partly on its bed, and Newton's method on the potential energy of
all states at once. Of a line off its bed nothing is worked out: these tests allow no uplift, so
that it fails there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Chain:
    """One uniform line: length (m), weight (N/m), EA (N), friction on the bed, height (m)."""

    length: float
    weight: float
    EA: float
    friction: float
    height: float

    def top(self, H: Floats) -> Floats:
        """Tension at the fairlead: (T - H)/w + (T^2 - H^2)/(2 EA w) = h, solved for T."""
        inside = H + H * H / (2.0 * self.EA) + self.weight * self.height
        return self.EA * (np.sqrt(1.0 + 2.0 * inside / self.EA) - 1.0)

    def lying(self, H: Floats) -> Floats:
        """Length on the bed, m."""
        return self.length - np.sqrt(self.top(H) ** 2 - H * H) / self.weight

    @cached_property
    def lift_off(self) -> float:
        """Force at which nothing lies any more, N: T^2 = H^2 + (w L)^2, found by bisection."""
        low, high = 0.0, 1e12
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.lying(np.array(middle)) > 0.0 else (low, middle)
        return low

    def span(self, H: Floats) -> Floats:
        """Distance from the anchor to the fairlead, m; beyond lift-off any that rises with H."""
        most = self.lift_off
        own = np.minimum(H, most)
        lying = np.maximum(self.lying(own), 0.0)
        hanging = self.length - lying
        grip = self.friction * self.weight
        stretch = own * lying
        if grip > 0.0:
            reach = np.minimum(lying, own / grip)
            stretch = own * reach - 0.5 * grip * reach**2
        span = lying + stretch / self.EA + own * hanging / self.EA
        span += own / self.weight * np.arcsinh(hanging * self.weight / np.maximum(own, 1e-300))
        return span + (H - own) * self.length / self.EA


class Pull:
    """Horizontal force of a chain and its stiffness by the span: a table, made exact by Newton."""

    def __init__(self, chain: Chain) -> None:
        self.chain = chain
        most = chain.lift_off
        self.H = np.concatenate(([1e-9 * most], np.geomspace(1e-6, 1e3, 6000) * most))
        self.S = chain.span(self.H)

        self.slope = np.gradient(self.S, self.H)

    def at(self, span: Floats) -> tuple[Floats, Floats]:
        """Force (N) and stiffness (N/m) at spans."""
        H = np.interp(span, self.S, self.H)
        slope = np.interp(H, self.H, self.slope)
        for _ in range(3):
            H = np.maximum(H - (self.chain.span(H) - span) / slope, 0.0)
        pulls = span > self.S[0]
        return np.where(pulls, H, 0.0), np.where(pulls, 1.0 / slope, 0.0)


@dataclass(frozen=True)
class Checked:
    """Largest offset (m), largest tension intact and with a line out (N), largest pull H (N)."""

    offset: float
    tension: tuple[float, float]
    pull: float
    residual: float


def mooring(
    pull: Pull,
    azimuths: Floats,
    reach: float,
    forces: Floats,
    *,
    line_out: bool,
) -> Checked:
    """Solve every state under every force; `reach` is anchor radius less fairlead radius, m."""
    count = len(azimuths)
    lines = np.ones((1 + count * line_out, count))
    for gone in range(len(lines) - 1):
        lines[1 + gone, gone] = 0.0
    there = np.repeat(lines, len(forces), axis=0)
    load = np.tile(forces, (len(lines), 1))
    anchors = reach * np.stack((np.cos(azimuths), np.sin(azimuths)), axis=1)
    x, H, left = _at_rest(pull, anchors, there, load)
    tension = pull.chain.top(H) * there
    intact = slice(0, len(forces))
    damaged = tension[len(forces) :]
    return Checked(
        offset=float(np.hypot(*x.T).max()),
        tension=(float(tension[intact].max()), float(damaged.max()) if line_out else 0.0),
        pull=float((H * there).max()),
        residual=left,
    )


def _at_rest(
    pull: Pull, anchors: Floats, there: Floats, load: Floats
) -> tuple[Floats, Floats, float]:
    """Minimise the potential energy of all states: steps downhill, halved where they go too far."""
    x = np.zeros((len(load), 2))
    stride = 0.02 * pull.chain.length
    r, K, H = _unbalanced(pull, anchors, there, load, x)
    scale = np.hypot(*load.T).max()
    for _ in range(200):
        if np.hypot(*r.T).max() <= 1e-10 * scale:
            break
        K = K + 1e-9 * scale * np.eye(2)
        step = np.linalg.solve(K, r[:, :, None])[:, :, 0]
        size = np.hypot(*step.T)
        step *= np.minimum(1.0, stride / np.maximum(size, 1e-300))[:, None]
        share = np.ones(len(load))
        slope = (r * step).sum(axis=1)
        for _ in range(40):
            after = _unbalanced(pull, anchors, there, load, x + share[:, None] * step)
            along = (after[0] * step).sum(axis=1)
            is_far = along < -0.5 * slope
            if not is_far.any():
                break
            share = np.where(is_far, 0.5 * share, share)
        x = x + share[:, None] * step
        r, K, H = after
    return x, H, float(np.hypot(*r.T).max() / scale)


def _unbalanced(
    pull: Pull, anchors: Floats, there: Floats, load: Floats, x: Floats
) -> tuple[Floats, Floats, Floats]:
    along = anchors[None] - x[:, None]
    span = np.hypot(along[..., 0], along[..., 1])
    u = along / span[..., None]
    H, k = pull.at(span)
    H, k = H * there, k * there
    r = load + (H[..., None] * u).sum(axis=1)
    across = np.stack((-u[..., 1], u[..., 0]), axis=-1)
    K = np.einsum("sl,sli,slj->sij", k, u, u)
    K += np.einsum("sl,sli,slj->sij", H / span, across, across)
    return r, K, H


def all_round(size: float, direction: float, count: int) -> Floats:
    """List forces of one size from so many sides, N."""
    angles = direction + 2.0 * math.pi * np.arange(count) / count
    return size * np.stack((np.cos(angles), np.sin(angles)), axis=1)
