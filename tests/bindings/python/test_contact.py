# SPDX-License-Identifier: GPL-3.0-or-later
import csv
import fractions
import pickle
import re

import ehd
import numpy as np
import pytest
from conftest import SOURCE, without_times


def test_a_case_gives_what_the_program_writes(program_json):
    r = ehd.solve("own-steel-20-10", tolerance=1e-4)
    written = program_json("solve", "own-steel-20-10", "--tolerance", "1e-4")
    assert without_times(r.to_dict()) == without_times(written)
    assert r.film.minimum.hertz == written["film"]["minimum"]["hertz"]
    assert r.groups.lambda_ == written["groups"]["lambda"]


def test_the_fields_are_those_of_the_profile(program, tmp_path):
    assert program("solve", "own-steel-20-10", "--profile", str(tmp_path / "p.csv")).returncode == 0
    with open(tmp_path / "p.csv", encoding="utf-8") as file:
        heading, *rows = csv.reader(file)
    r = ehd.solve("own-steel-20-10")
    assert len(heading) >= 8  # X, P, H, rho, eta, and three in SI
    for name, column in zip(heading, zip(*rows)):
        field = getattr(r, name.split()[0])
        assert field.dtype == np.float64 and not field.flags.writeable
        written = np.array([float(cell) if cell else np.nan for cell in column])
        np.testing.assert_allclose(field, written, rtol=1e-14)  # the profile is written with 15 digits


def test_keywords_state_the_same_contact_as_a_file(program_json):
    lubricant = {"viscosity": "roelands", "density": "dowson-higginson", "alpha_per_Pa": 2.2e-8, "z": 0.68,
                 "p0_Pa": 1.96e8}
    r = ehd.solve(M=20, L=10, inlet=-4.0, id="mine", **lubricant)
    options = ("--viscosity", "roelands", "--density", "dowson-higginson", "--alpha-per-Pa", "2.2e-8", "--z", "0.68",
               "--p0-Pa", "1.96e8", "--inlet", "-4")
    written = program_json("solve", "--M", "20", "--L", "10", *options)
    assert r["case"] == "mine"
    assert r.film.to_dict() == written["film"]


def test_keywords_of_every_kind_state_a_contact(program_json):
    steel = ehd.solve("own-steel-20-10")
    text = (SOURCE / "cases" / "own-steel-20-10.toml").read_text(encoding="utf-8")
    assert ehd.solve(text).film == steel.film
    si = ehd.solve(load_N_per_m=np.float64(1e5), reduced_radius_m=0.01, reduced_modulus_Pa=2.2e11, speed_sum_m_per_s=3,
                   viscosity_Pa_s=0.02, viscosity="roelands", density="dowson-higginson", alpha_per_Pa=2.0e-8)
    written = program_json("solve", str(SOURCE / "examples" / "cylinder-on-plate.toml"))
    assert si.film.to_dict() == written["film"]
    dry = ehd.solve(load_N_per_m=1e5, reduced_radius_m=0.01, reduced_modulus_Pa=2.2e11)
    assert dry.status == "converged" and "minimum" not in dry.film and not hasattr(dry, "rho")
    hertz = ehd.solve(lambda_=0.05, alpha_p_H=5.0, viscosity="barus", density="incompressible")
    assert hertz.groups.lambda_ == pytest.approx(0.05, rel=1e-12)


def test_a_solve_that_did_not_converge_says_so():
    r = ehd.solve(M=20, L=10, solver="fast.uniform", tolerance=1e-13)
    assert r.status == "tolerance-not-met" and r.film.minimum.error > 1e-13
    with pytest.raises(ehd.NotConvergedError, match="tolerance-not-met") as caught:
        ehd.solve(M=20, L=10, solver="fast.uniform", tolerance=1e-13, raise_on_failure=True)
    assert caught.value.result.film == r.film
    assert pickle.loads(pickle.dumps(caught.value)).result.film == r.film


@pytest.mark.parametrize("keywords, says", [
    ({"M": -1, "L": 10}, "M = -1: is negative; allowed is 0.001 to 1e6"),
    ({"M": float("nan"), "L": 10}, "M = nan: is not finite"),
    ({"M": 20}, "L"),
    ({"M": 20, "L": 10, "viskosity": "barus"},
     "viskosity: is an unknown keyword; did you mean viscosity? allowed is solver"),
    ({"M": 20, "L": 10, "viskosity": "barus", "inlett": -4},
     " (and 1 more)"),
    ({"m": 20, "L": 10}, "m: is an unknown keyword; did you mean M? allowed is solver, "),
    ({"M": 20, "L": 10, "inlett": -4}, "inlett: is an unknown keyword; did you mean inlet?"),
    ({"M": 20, "L": 10, "lambda": 3}, "lambda: is an unknown keyword; did you mean lambda_?"),
    ({"M": 20, "L": 10, "viscosity": 'a"b\\\n'}, "viscosity = "),
    ({"M": 20, "L": 10, "inlet": 2.0}, "inlet = 2.0: lies inside"),
    ({"M": 20, "L": 10, "solver": "slow"}, "solver = slow: is unknown"),
    ({"M": 20, "L": 10, "tolerance": 0.0}, "tolerance = 0"),
    ({"M": 20, "L": 10, "load_N_per_m": 1e5}, "conditions"),
    ({"load_N_per_m": 1e5, "reduced_radius_m": 0.01, "reduced_modulus_Pa": 2e11, "viscosity_Pa_s": 0.1},
     "speed_sum_m_per_s: is missing"),
    ({"M": [20, 30], "L": 10}, "M = [20, 30]: is neither a number nor a text; allowed is one of them"),
    ({"M": np.eye(2), "L": 10}, "M = array([[1., 0.], [0., 1.]]): is neither a number nor a text"),
    ({"M": 20, "L": None}, "L = None: is neither a number nor a text"),
    ({"M": 20 + 0j, "L": 10}, "M = (20+0j): is neither a number nor a text"),
    ({"M": np.complex128(20 + 5j), "L": 10}, "M = (20+5j): is neither a number nor a text; allowed is one of them"),
    ({"M": True, "L": 10}, "M = True: is neither a number nor a text; allowed is one of them"),
    ({"M": 20, "L": np.bool_(True)}, "L = True: is neither a number nor a text; allowed is one of them"),
    ({"M": b"20", "L": 10}, "M = b'20': is neither a number nor a text; allowed is one of them"),
    ({"M": np.ma.array(20.0, mask=True), "L": 10}, "is neither a number nor a text; allowed is one of them"),
    ({}, "the contact is missing"),
])
def test_bad_keywords_are_named_in_one_line(keywords, says):
    with pytest.raises(ehd.InputError) as caught:
        ehd.solve(**keywords)
    assert says in str(caught.value) and "\n" not in str(caught.value)
    assert isinstance(caught.value, ValueError)
    assert not str(caught.value).startswith(("keywords", "case"))


def test_a_bad_file_is_named_with_its_line(tmp_path):
    good = (SOURCE / "examples" / "cylinder-on-plate.toml").read_text(encoding="utf-8")
    file = tmp_path / "cylinder-on-plate.toml"
    file.write_text(good.replace("3.0 ", "-3.0 "), encoding="utf-8")
    with pytest.raises(ehd.InputError, match=r"cylinder-on-plate.toml:10: speed_sum_m_per_s = -3") as caught:
        ehd.solve(file)
    assert str(caught.value).startswith(f"{file}:10: ")
    file.write_bytes(good.encode() + b"\0")
    for wrong in (file, tmp_path, tmp_path / "none.toml", "no-such-case", "na4908", ""):
        with pytest.raises(ehd.InputError):
            ehd.solve(wrong)
    with pytest.raises(ehd.InputError, match="exclude each other"):
        ehd.solve("own-steel-20-10", M=20)
    with pytest.raises(ehd.InputError, match="there is no such case"):
        ehd.solve(b"no-such-case")
    with pytest.raises(ehd.InputError, match="own-moes-20-1: there is no such case; did you mean own-moes-20-10\\? "):
        ehd.solve("own-moes-20-1")
    for wrong in (3, {"M": 20}):
        with pytest.raises(ehd.InputError, match="case = .*: is no path; allowed is the path, the id or the text of a"):
            ehd.solve(wrong)


@pytest.mark.parametrize(("wrong", "says"), [
    ("", "^'': there is no such case"),
    ("*", r"^\*: there is no such case"),  # a pattern would find a case of the atlas
    ("x\0y", r"^x\\x00y: there is no such case"),
    ("x" * 100000, r"^x{60}\.\.\.: there is no such case"),
    ("/" + "x" * 100000, r"^/x{399}\.\.\.: File name too long"),
    ("/dev/zero", "^/dev/zero: is not a regular file"),
])
def test_a_hostile_name_of_a_case_is_one_line(wrong, says):
    with pytest.raises(ehd.InputError, match=says) as caught:
        ehd.solve(wrong)
    assert "\n" not in str(caught.value)


def test_a_large_file_is_not_read_to_its_end(tmp_path):
    file = tmp_path / "large.toml"
    with file.open("wb") as stream:
        stream.truncate(2**40)  # a hole: it takes no room on the disk
        stream.seek(0)
        stream.write(b"#" * (64 * 1024 + 1))
    with pytest.raises(ehd.InputError, match="is larger than 64 KiB"):
        ehd.solve(file)


def test_a_result_does_not_change_and_names_what_is_there():
    r = ehd.solve(M=20, L=10)
    with pytest.raises(AttributeError):
        r.status = "diverged"
    with pytest.raises(ValueError):
        r.P[0] = 1.0
    with pytest.raises(AttributeError, match="there is no m; there are hertz, moes"):
        r.film.minimum.m
    assert {"film", "status", "X", "P", "H"} <= set(dir(r))
    assert r.plan.run[0] and repr(r.film) == "Record(minimum, central, couette, offset)"


def test_a_result_is_the_same_in_another_process():
    r = ehd.solve("own-steel-20-10")
    copy = pickle.loads(pickle.dumps(r))
    assert copy == r and copy.to_dict() == r.to_dict()
    assert copy.P.tobytes() == r.P.tobytes() and not copy.P.flags.writeable


@pytest.mark.parametrize("keywords, message", [
    ({"tolerance": "x"}, "tolerance = 'x': is no number"),
    ({"tolerance": None}, "tolerance = None: is no number"),
    ({"solver": 3}, "solver = 3: is no name"),
    ({"tolerence": 1e-3}, "tolerence: is an unknown keyword; did you mean tolerance?"),
])
def test_a_wrong_argument_is_named(keywords, message):
    with pytest.raises(ehd.InputError, match=re.escape(message)):
        ehd.solve(M=20, L=10, **keywords)


def test_what_no_double_and_no_text_of_c_holds_is_named():
    with pytest.raises(ehd.InputError, match="threads: is out of range"):
        ehd.films(M=20, L=10, threads=10**5000)
    for huge in (10**400, 10**5000, fractions.Fraction(10**400)):
        with pytest.raises(ehd.InputError, match="tolerance: is out of range"):
            ehd.solve(M=20, L=10, tolerance=huge)
    for huge in (10**5000, fractions.Fraction(10**400)):
        with pytest.raises(ehd.InputError, match="M: is out of range"):
            ehd.solve(M=huge, L=10)
    with pytest.raises(ehd.InputError, match="solver = .* is no name"):
        ehd.solve(M=20, L=10, solver="fast\0er")
    for half in ({"M": 20, "L": 10, "title": "\ud800"}, {"case": "id = 'a'\n\ud800"}):
        with pytest.raises(ehd.InputError, match="is no Unicode"):
            ehd.solve(**half)


def test_a_wrong_argument_of_films_and_of_a_bearing_is_named():
    with pytest.raises(ehd.InputError, match="thread: is an unknown keyword; did you mean threads?"):
        ehd.films(M=[5], L=[5], thread=2)
    with pytest.raises(ehd.InputError, match="threads = 4294967298: is out of range"):
        ehd.films(M=[5], L=[5], threads=2**32 + 2)
    with pytest.raises(ehd.InputError, match="threads = 1.5: is no whole number"):
        ehd.films(M=[5], L=[5], threads=1.5)
    with pytest.raises(ehd.InputError, match="law = 3: is no name"):
        ehd.bearing("na4908", law=3)
