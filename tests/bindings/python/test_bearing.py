# SPDX-License-Identifier: GPL-3.0-or-later
import pickle

import ehd
import numpy as np
import pytest
from conftest import SOURCE, without_times


@pytest.fixture(scope="module")
def film_bearing():
    return ehd.bearing("na4908", law="ehd")


@pytest.mark.parametrize("law", ["hertz", "ehd"])
def test_a_bearing_gives_what_the_program_writes(law, program_json):
    b = ehd.bearing("na4908", law=law)
    written = program_json("bearing", "na4908", "--law", law)
    written.pop("error_budget", None)
    assert without_times(b.to_dict()) == without_times(written)
    assert b["law"] == law


def test_rollers_are_a_table(film_bearing):
    rollers, listed = film_bearing.rollers, film_bearing["rollers"]
    assert rollers.shape == (len(listed),) == (22,)
    assert [roller.inner.force_N for roller in listed] == list(rollers["inner"]["force_N"])
    assert listed[3].azimuth_deg == rollers.azimuth_deg[3]
    # A film is NaN exactly where the JSON has none.
    for roller, row in zip(listed, rollers.outer):
        assert hasattr(roller.outer, "film_minimum_m") == bool(np.isfinite(row["film_minimum_m"]))
    with pytest.raises(ValueError):
        rollers["azimuth_deg"][0] = 1.0
    assert "film_minimum_m" not in ehd.bearing("na4908", law="hertz").rollers.inner.dtype.names


def test_the_law_gives_the_forces_of_the_balance(film_bearing):
    for raceway in ("inner", "outer"):
        rows = film_bearing.rollers[raceway]
        force = film_bearing.law(raceway).force(rows["displacement_m"])
        np.testing.assert_allclose(force, rows["force_N"], rtol=1e-9, atol=1e-9 * rows["force_N"].max())


def test_stiffness_is_the_slope_of_the_force():
    law = ehd.bearing("na4908", law="hertz").law("inner")
    x, h = np.array([[1e-6, 2e-6]]), 1e-9
    slope = (law.force(x + h) - law.force(x - h)) / (2 * h)
    assert law.stiffness(x).shape == (1, 2)
    np.testing.assert_allclose(law.stiffness(x), slope, rtol=1e-5)  # (h/x)^2 = 1e-6


def test_an_array_of_any_order_and_stride_has_its_own_forces(film_bearing):
    law = film_bearing.law("inner")
    approach = np.array([[1e-6, 2e-6, 3e-6], [-1e-6, 1.5e-6, 2.5e-6]])
    each = np.array([[law.force(x) for x in row] for row in approach])
    for given, expected in ((approach.T, each.T), (approach[:, ::2], each[:, ::2]), (approach[::-1], each[::-1])):
        np.testing.assert_array_equal(law.force(given), expected)


def test_a_copy_from_another_process_has_the_same_law(film_bearing):
    copy = pickle.loads(pickle.dumps(film_bearing))
    assert copy == film_bearing
    assert copy.law("inner").force(2e-6) == film_bearing.law("inner").force(2e-6)


def test_forces_outside_the_range_come_with_a_warning(film_bearing):
    with pytest.warns(RuntimeWarning, match="range"):
        force = film_bearing.law("inner").force([2e-6, 1e-4])
    assert np.isfinite(force).all()


def test_bad_input_is_one_line(tmp_path):
    with pytest.raises(ehd.InputError, match="law"):
        ehd.bearing("na4908", law="hooke")
    dry = ehd.bearing("na4908", law="hertz")
    for raceway in ("middle", None, ["inner"]):
        with pytest.raises(ehd.InputError) as caught:
            dry.law(raceway)  # at once, not at the first force
        assert str(caught.value) == f"raceway = {raceway!r}: is unknown; allowed is inner, outer"
    with pytest.raises(ehd.InputError, match="raceway = 'iner': is unknown; did you mean inner\\? allowed is"):
        dry.law("iner")
    with pytest.raises(ehd.InputError, match="case = None: is no path"):
        ehd.bearing(None)
    for wrong, says in (([], "approach_m: is empty"), ("deep", "approach_m: is no array of numbers"),
                        ([[1e-6], [1e-6, 2e-6]], "approach_m: is no array of numbers"), (None, "approach_m"),
                        (True, "approach_m: is no array of numbers"), (["1e-6"], "approach_m: is no array of numbers")):
        with pytest.raises(ehd.InputError, match=says):
            dry.law("inner").force(wrong)
    with pytest.raises(ehd.InputError):
        ehd.bearing("own-moes-20-10")
    text = (SOURCE / "examples" / "roller-bearing.toml").read_text(encoding="utf-8")
    file = tmp_path / "roller-bearing.toml"
    file.write_text(text.replace("rollers = 14", "rollers = 1"), encoding="utf-8")
    with pytest.raises(ehd.InputError, match=r"roller-bearing.toml:7: rollers = 1"):
        ehd.bearing(file, law="hertz")
