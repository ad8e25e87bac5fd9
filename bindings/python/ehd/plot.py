# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a contact and of a bearing, by matplotlib where it is installed."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np

from ._bearing import Bearing, _require_raceway
from ._contact import Contact
from ._result import Array
from .errors import InputError

_MICRO = "\N{GREEK SMALL LETTER MU}"
_FIRST, _SECOND = "#1f4e79", "#b3541e"  # told apart in grey print as well: 30 % and 45 % of white
# As ehd solve --plot: from where the pressure begins to where it has ended, with a margin, and the contact at least.
_FELT, _MARGIN, _LEAST = 0.02, 0.15, 1.5  # of the largest pressure; of the width; X
_FILMS_SHOWN = 4.0  # the film's axis ends at so many central films
_LOADED = 0.01  # bearing::loaded_share: of the largest force at the inner raceway


def _new_axes(count: int) -> Any:
    from matplotlib import pyplot  # not needed before a figure is drawn

    figure, axes = pyplot.subplots(count, 1, sharex=True, figsize=(3.4, 2.3 * count), layout="constrained")
    del figure
    return axes


def _require(result: object, kind: type, origin: str) -> None:
    if not isinstance(result, kind):
        raise InputError(f"result: is a {type(result).__name__}; allowed is a {kind.__name__}, from {origin}")


def _shown_range(x: Array, p: Array, half_width: float) -> Tuple[float, float]:
    under_pressure = x[p > _FELT * p.max()]
    if under_pressure.size == 0:
        return float(x[0]), float(x[-1])
    margin, least = _MARGIN * (under_pressure[-1] - under_pressure[0]), _LEAST * half_width
    return (float(max(x[0], min(under_pressure[0] - margin, -least))),
            float(min(x[-1], max(under_pressure[-1] + margin, least))))


def contact(result: Contact, axes: Optional[Any] = None) -> Any:
    """Pressure and film over x: in SI, as `ehd solve --plot`; over X = x/b where SI is not known.

    Parameters
    ----------
    result
        From `ehd.solve`.
    axes
        matplotlib axes to draw in; else those of a new figure, one column of a paper wide.

    Returns
    -------
    tuple of matplotlib.axes.Axes
        That of the pressure (MPa, or p/p_H), on the left, and that of the film (um, or h R/b^2), on the right.

    Examples
    --------
    >>> import ehd, os
    >>> left, right = ehd.plot.contact(ehd.solve("own-moes-20-10", tolerance=1e-4))
    >>> left.figure.savefig(os.devnull, format="pdf")
    """
    _require(result, Contact, "ehd.solve")
    left = _new_axes(1) if axes is None else axes
    right = left.twinx()
    resolved = result.fields.pressure_resolved
    if hasattr(result, "x_m"):
        x, p, h = 1e6 * result.x_m, 1e-6 * result.p_Pa, 1e6 * result.h_m
        half_width = 1e6 * result.groups.half_width_m
        labels = (f"x [{_MICRO}m]", "pressure [MPa]", f"film [{_MICRO}m]")
    else:
        x, p, h, half_width = result.X, result.P, result.H, 1.0
        labels = ("$X = x/b$", "$p/p_H$", "$H = hR/b^2$")
    pressure, = left.plot(x, p, color=_FIRST, linewidth=1.2,
                          label="pressure" if resolved else "pressure (maximum not known)")
    film, = right.plot(x, h, color=_SECOND, linewidth=1.2, linestyle="--", label="film")
    left.set(xlim=_shown_range(x, p, half_width), ylim=(0, None), xlabel=labels[0], ylabel=labels[1])
    central = float(np.interp(0.0, x, h))
    right.set(ylim=(0, _FILMS_SHOWN * central) if central > 0 else (0, 1), ylabel=labels[2])
    left.legend(handles=[pressure, film], frameon=False, fontsize="small", ncol=2, loc="lower center",
                bbox_to_anchor=(0.5, 1.0))
    return left, right


def bearing(result: Bearing, axes: Optional[Any] = None, *, raceway: str = "inner") -> Any:
    """Contact forces and, where there is oil, smallest films of the loaded rollers over the azimuth.

    A roller is loaded from 1 % of the largest force on, as in the table of `ehd bearing`.

    Parameters
    ----------
    result
        From `ehd.bearing`.
    axes
        Array of two matplotlib axes, for the forces and the films; of a bearing without films the first alone.
        Drawing a second bearing into the same axes compares both.
    raceway
        ``"inner"`` or ``"outer"``.

    Returns
    -------
    array of matplotlib.axes.Axes

    Examples
    --------
    >>> import ehd
    >>> axes = ehd.plot.bearing(ehd.bearing("na4908", law="ehd"))
    >>> axes = ehd.plot.bearing(ehd.bearing("na4908", law="hertz"), axes)
    """
    _require(result, Bearing, "ehd.bearing")
    _require_raceway(raceway)
    # From -180 to 180 degrees, so that the load is in the middle.
    azimuth = (result.rollers["azimuth_deg"] + 180.0) % 360.0 - 180.0
    order = np.argsort(azimuth)
    rows = result.rollers[raceway][order]
    films = "film_minimum_m" in (rows.dtype.names or ())
    axes = np.atleast_1d(_new_axes(2 if films else 1) if axes is None else axes)
    axes[0].plot(azimuth[order], 1e-3 * rows["force_N"], marker="o", markersize=3, linewidth=1, label=result["law"])
    axes[0].set(ylabel=f"force, {raceway} raceway [kN]")
    axes[0].set_ylim(bottom=0, auto=None)  # auto: a second bearing may carry more
    axes[0].legend(frameon=False, fontsize="small")
    if films and axes.size > 1:
        inner = result.rollers["inner"]["force_N"][order]
        loaded = (inner > 0) & (inner >= _LOADED * inner.max())
        films_um = np.where(loaded, 1e6 * rows["film_minimum_m"], np.nan)
        axes[1].plot(azimuth[order], films_um, marker="o", markersize=3, linewidth=1)
        axes[1].set(ylabel=f"smallest film [{_MICRO}m]")
        axes[1].set_ylim(bottom=0, auto=None)
    axes[-1].set(xlabel="azimuth from the load [degrees]", xlim=(-180, 180), xticks=range(-180, 181, 60))
    return axes
