# SPDX-License-Identifier: GPL-3.0-or-later
import ehd
import numpy as np
import pytest
from conftest import needs

needs("matplotlib", "python3-matplotlib").use("Agg")


def test_a_contact_is_drawn_with_its_own_numbers(tmp_path):
    r = ehd.solve("own-moes-20-10", tolerance=1e-4)
    left, right = ehd.plot.contact(r)
    (pressure,), (film,) = left.lines, right.lines
    assert np.array_equal(pressure.get_xydata(), np.c_[r.X, r.P]) and np.array_equal(film.get_ydata(), r.H)
    assert left.get_xlabel() == "$X = x/b$" and "p_H" in left.get_ylabel() and "H" in right.get_ylabel()
    left.figure.savefig(tmp_path / "contact.pdf")
    assert (tmp_path / "contact.pdf").stat().st_size > 2000


def test_a_contact_in_SI_is_drawn_in_SI():
    r = ehd.solve("steel-roller", tolerance=1e-2)
    left, right = ehd.plot.contact(r)
    (pressure,), (film,) = left.lines, right.lines
    assert np.array_equal(pressure.get_xydata(), np.c_[1e6 * r.x_m, 1e-6 * r.p_Pa])
    assert np.array_equal(film.get_ydata(), 1e6 * r.h_m)
    assert (left.get_xlabel(), left.get_ylabel(), right.get_ylabel()) == (
        "x [\u03bcm]", "pressure [MPa]", "film [\u03bcm]")
    low, high = left.get_xlim()
    shown = 1e6 * r.x_m[r.P > 0.02 * r.P.max()]
    assert low < shown[0] and shown[-1] < high < 2 * 1e6 * r.groups.half_width_m


@pytest.mark.parametrize("M, L", [(0.01, 0), (0.1, 5), (2, 5), (20, 10), (1000, 10)])
def test_all_of_the_pressure_is_shown_and_little_else(M, L):
    r = ehd.solve(M=M, L=L)
    left, _ = ehd.plot.contact(r)
    low, high = left.get_xlim()
    shown = r.X[r.P > 0.02 * r.P.max()]
    assert low < shown[0] and shown[-1] < high and max(r.X[0], -1.5) >= low and min(r.X[-1], 1.5) <= high
    assert high - low < 1.5 * max(shown[-1] - shown[0], 2.0)


def test_a_spike_that_is_not_resolved_is_said_to_be_so():
    r = ehd.solve("own-steel-20-10", tolerance=1e-1)
    data = r.to_dict()
    for resolved, label in ((True, "pressure"), (False, "pressure (maximum not known)")):
        copy = ehd.Contact({**data, "fields": {**data["fields"], "pressure_resolved": resolved}},
                           {name: getattr(r, name) for name in "XPH"})
        left, _ = ehd.plot.contact(copy)
        assert left.get_legend().get_texts()[0].get_text() == label


def test_a_dry_contact_is_drawn():
    dry = ehd.solve(load_N_per_m=1e5, reduced_radius_m=0.01, reduced_modulus_Pa=2.2e11)
    left, _ = ehd.plot.contact(dry)
    assert len(left.lines[0].get_xdata()) > 10


def test_bearings_are_compared_in_the_same_axes(tmp_path):
    film, dry = ehd.bearing("na4908", law="ehd"), ehd.bearing("na4908", law="hertz")
    axes = ehd.plot.bearing(film)
    assert ehd.plot.bearing(dry, axes) is not None
    assert axes.shape == (2,) and [len(one.lines) for one in axes] == [2, 1]
    forces = axes[0].lines[0]
    assert (np.diff(forces.get_xdata()) > 0).all()
    assert max(forces.get_ydata()) == 1e-3 * film.rollers.inner.force_N.max()
    assert [text.get_text() for text in axes[0].get_legend().get_texts()] == ["ehd", "hertz"]
    assert axes[0].get_ylim()[0] == 0 and axes[0].get_ylim()[1] > 1e-3 * dry.rollers.inner.force_N.max()
    axes[0].figure.savefig(tmp_path / "bearing.pdf")
    assert ehd.plot.bearing(dry, raceway="outer").shape == (1,)


def test_films_of_unloaded_rollers_are_not_drawn():
    b = ehd.bearing("na4908-10um", law="ehd")
    for raceway in ("inner", "outer"):
        (film,) = ehd.plot.bearing(b, raceway=raceway)[1].lines
        shown = np.isfinite(film.get_ydata())
        assert shown.sum() == b.loaded_rollers < len(b.rollers) == len(shown)
        assert film.axes.get_ylim()[0] == 0 and film.axes.get_ylim()[1] < 5


def test_what_is_drawn_elsewhere_is_refused_in_one_line():
    r, b = ehd.solve(M=20, L=10), ehd.bearing("na4908", law="hertz")
    for draw, wrong, says in (
            (ehd.plot.contact, b, "result: is a Bearing; allowed is a Contact, from ehd.solve"),
            (ehd.plot.contact, None, "result: is a NoneType; allowed is a Contact, from ehd.solve"),
            (ehd.plot.bearing, r, "result: is a Contact; allowed is a Bearing, from ehd.bearing"),
            (ehd.plot.bearing, "na4908", "result: is a str; allowed is a Bearing, from ehd.bearing")):
        with pytest.raises(ehd.InputError) as caught:
            draw(wrong)
        assert str(caught.value) == says
    with pytest.raises(ehd.InputError, match="raceway = 'middle': is unknown; allowed is inner, outer"):
        ehd.plot.bearing(b, raceway="middle")
