# SPDX-License-Identifier: GPL-3.0-or-later
"""A JSON object, read by attribute: ``result.film.minimum.hertz``."""

from __future__ import annotations

from typing import Any, Iterator, Mapping


def _read(value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list):
        return tuple(_read(item) for item in value)
    return value


class Record(Mapping[str, Any]):
    """The entries of a JSON object as attributes and as items; it never changes.

    The names are those of the JSON. One that Python keeps for itself takes a ``_`` behind it: ``groups.lambda_``. What
    is unknown, or was not asked for, is absent: ``hasattr(result.film.minimum, "m")`` is false where SI is unknown.

    Examples
    --------
    >>> film = Record({"hertz": 0.07, "error": 1e-4, "lambda": 2})
    >>> film.hertz, film["error"], film.lambda_
    (0.07, 0.0001, 2)
    >>> film.m
    Traceback (most recent call last):
    AttributeError: there is no m; there are hertz, error, lambda
    """

    __slots__ = ("_data",)

    def __init__(self, data: dict[str, Any]) -> None:
        object.__setattr__(self, "_data", data)

    def __getitem__(self, name: str) -> Any:
        return _read(self._data[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_"):
            for key in (name, name.rstrip("_")):
                if key in self._data:
                    return self[key]
        raise AttributeError(f"there is no {name}; there are {', '.join(self.__dir__())}")

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name}: a result does not change")

    def __dir__(self) -> list[str]:
        return list(self._data)

    def __reduce__(self) -> Any:
        return type(self), (self._data,)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(_shown(name, value) for name, value in self._data.items())})"

    def to_dict(self) -> dict[str, Any]:
        """The JSON object itself, to be left as it is.

        Returns
        -------
        dict
            As ``json.loads`` reads it.
        """
        data: dict[str, Any] = self._data
        return data


def _shown(name: str, value: Any) -> str:
    """An entry in one line: of an object or a list the name alone."""
    if isinstance(value, (dict, list)):
        return name
    return f"{name}={value:.6g}" if isinstance(value, float) else f"{name}={value!r}"
