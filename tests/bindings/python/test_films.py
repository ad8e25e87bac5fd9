# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import fractions
import pickle

import ehd
import numpy as np
import pytest
from conftest import needs


def test_each_film_is_that_of_a_solve():
    M, L = np.geomspace(2, 200, 4), np.array([[2.5], [10.0]])
    t = ehd.films(M, L, tolerance=1e-4, threads=2)
    assert t.minimum.shape == t.status.shape == (2, 4)
    for i in np.ndindex(2, 4):
        r = ehd.solve(M=t.M[i], L=t.L[i], tolerance=1e-4)
        assert (t.minimum[i], t.minimum_error[i]) == (r.film.minimum.hertz, r.film.minimum.error)
        assert (t.central[i], t.central_error[i]) == (r.film.central.hertz, r.film.central.error)
        assert t.status[i] == r.status


def test_arrays_of_any_order_and_stride_are_read_as_numpy_shows_them():
    M, L = np.geomspace(5, 50, 6).reshape(2, 3), np.array([[0.0], [5.0], [10.0], [15.0]])
    t, t_of_copies = ehd.films(M.T[:, ::-1], L[::2].T), ehd.films(M.T[:, ::-1].copy(), L[::2].T.copy())
    assert t.M.tolist() == M.T[:, ::-1].tolist() and t.L.tolist() == [[0.0, 10.0]] * 3
    assert t.minimum.tolist() == t_of_copies.minimum.tolist()
    assert t.minimum[2, 0] == ehd.films(M[1, 2], 0).minimum  # L = 0: isoviscous


def test_numbers_do_not_depend_on_threads():
    one, three = (ehd.films(np.linspace(5, 50, 30), 10, threads=threads) for threads in (1, 3))
    assert one.minimum.tobytes() == three.minimum.tobytes() and one.central.tobytes() == three.central.tobytes()


def test_the_lubricant_counts():
    oil = {"viscosity": "roelands", "density": "dowson-higginson", "alpha_per_Pa": 2.2e-8, "z": 0.68}
    t = ehd.films(20, 10, **oil)
    assert t.minimum.shape == ()
    assert t.minimum == ehd.solve(M=20, L=10, **oil).film.minimum.hertz != ehd.films(20, 10).minimum


def test_failure_is_a_status_or_on_request_an_exception():
    with pytest.raises(ehd.NotConvergedError, match="2 of 2") as caught:
        ehd.films([20, 30], 10, tolerance=1e-15, raise_on_failure=True)
    t = caught.value.result
    assert list(t.status) == ["tolerance-not-met"] * 2 and (t.minimum_error > 1e-15).all()


def test_arrays_are_read_only_also_in_another_process():
    t = ehd.films([20, 30], 10)
    for films in (t, pickle.loads(pickle.dumps(t))):
        with pytest.raises(ValueError):
            films.minimum[0] = 1.0
    given = np.array([20.0, 30.0])
    ehd.films(given, 10)
    assert t == t and t != ehd.films([20, 30], 10)  # one object is equal to itself alone
    given[0] = 1.0  # the caller's own array is left alone


@pytest.mark.parametrize("arguments, says", [
    ({"M": [20, -1], "L": 10}, "M"),
    ({"M": 20, "L": np.inf}, "L"),
    ({"M": 20, "L": 10, "tolerance": -1.0}, "tolerance"),
    ({"M": 20, "L": 10, "threads": -1}, "threads"),
    ({"M": 20, "L": 10, "viscosity": "roelands"}, "lubricant"),
    ({"M": 20, "L": 10, "oil": "good"}, "oil"),
    ({"M": [], "L": 10}, "M: is empty"),
    ({"M": [20], "L": np.empty((0, 3))}, "L: is empty"),
    ({"M": [20, 30], "L": [5, 10, 15]}, "M, L: have the shapes (2,) and (3,)"),
    ({"M": [[20], [20, 30]], "L": 10}, "M: is no array of numbers"),
    ({"M": "many", "L": 10}, "M: is no array of numbers"),
    ({"M": 20, "L": 1j}, "L: is no array of numbers (it has complex numbers)"),
    ({"M": [20, 30 + 0j], "L": 10}, "M: is no array of numbers (it has complex numbers)"),
    ({"M": np.array([20 + 5j]), "L": 10}, "M: is no array of numbers (it has complex numbers)"),
    ({"M": np.ma.array([20.0, -999.0], mask=[0, 1]), "L": 10}, "M: is no array of numbers (it has masked values)"),
    ({"M": [np.ma.array([20.0, -999.0], mask=[0, 1])], "L": 10}, "M: is no array of numbers (it has masked values)"),
    ({"M": True, "L": 10}, "M: is no array of numbers (it has truth values)"),
    ({"M": [20.0, True], "L": 10}, "M: is no array of numbers (it has truth values)"),
    ({"M": 20, "L": np.array([10, 5]) > 7}, "L: is no array of numbers (it has truth values)"),
    ({"M": ["20"], "L": 10}, "M: is no array of numbers (it has texts)"),
    ({"M": [b"20"], "L": 10}, "M: is no array of numbers (it has texts)"),
    ({"M": np.array([20, "30"], dtype=object), "L": 10}, "M: is no array of numbers (it has texts)"),
    ({"M": np.array(["2020-01-01"], dtype="M8[D]"), "L": 10}, "M: is no array of numbers (it has dates)"),
    ({"M": 10**400, "L": 10}, "M: is no array of numbers"),
    ({"M": 20, "L": 10, "tolerance": True}, "tolerance = True: is no number"),
    ({"M": 20, "L": 10, "threads": True}, "threads = True: is no whole number"),
])
def test_bad_input_is_one_line(arguments, says):
    with pytest.raises(ehd.InputError) as caught:
        ehd.films(**arguments)
    assert says in str(caught.value) and "\n" not in str(caught.value)
    if "is no array" in says:
        assert str(caught.value).endswith("; allowed is a number, or numbers")


@pytest.mark.parametrize("given", [
    np.array([20, 30]), np.array([20, 30], dtype=np.float32), np.array([20.0, fractions.Fraction(30)], dtype=object),
    (20, np.float64(30)), [fractions.Fraction(20), 30], range(20, 31, 10), np.ma.array([20.0, 30.0], mask=[0, 0]),
])
def test_numbers_of_every_kind_are_taken(given):
    assert ehd.films(given, 10).minimum.tolist() == ehd.films([20.0, 30.0], 10).minimum.tolist()


def test_pandas_takes_the_arrays_of_one_dimension():
    pandas = needs("pandas", "python3-pandas")
    t = ehd.films([20, 30], 10)
    table = pandas.DataFrame(dataclasses.asdict(t))
    assert list(table.columns) == [field.name for field in dataclasses.fields(t)]
    assert (table.minimum == t.minimum).all() and list(table.status) == ["converged"] * 2
