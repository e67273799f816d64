# SPDX-License-Identifier: BSD-3-Clause
"""Properties of a VTK object by keyword: focus_on_view=True, FocusOnView=True, filter="pcf"."""

import re

from vtkmodules.vtkCommonCore import vtkObject


def _key(name):
    return name.replace("_", "").lower()


def _snake_case(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def _setters(obj):
    """CamelCase names of what can be set, without what every vtkObject has."""
    names = {name[3:] for name in dir(obj) if name.startswith("Set") and len(name) > 3}
    names -= {name[3:] for name in dir(vtkObject) if name.startswith("Set")}
    words = {name for name in names for match in [re.match(r"(.+)To[A-Z0-9]", name)]
             if match and match.group(1) in names}  # SetFilterToPCF beside SetFilter
    return names - words


def _constants(obj):
    """Enumerators and their values, of the class itself and of the enumerations in it."""
    found = {}
    for name in dir(type(obj)):
        value = getattr(type(obj), name)
        if isinstance(value, int) and not isinstance(value, bool) and name.isupper():
            found[name] = value
        elif isinstance(value, type) and issubclass(value, int):
            for inner in dir(value):
                if inner.isupper():
                    found.setdefault(inner, getattr(value, inner))
    return found


def _set_by_word(obj, name, word):
    """SetFilterToBilinear() if there is one, else SetFilter(obj.BILINEAR), else SetFilter(word)."""
    choices = {
        _key(method[len(name) + 5:]): method
        for method in dir(obj)
        if method.startswith(f"Set{name}To")
    }
    if _key(word) in choices:
        getattr(obj, choices[_key(word)])()
        return
    constants = _constants(obj)
    value = {_key(constant): v for constant, v in constants.items()}.get(_key(word))
    try:
        getattr(obj, "Set" + name)(word if value is None else value)
    except TypeError:
        known = sorted(choices) or sorted(constant.lower() for constant in constants)
        raise ValueError(
            f"{_snake_case(name)}={word!r} is not known; among: {', '.join(known)}"
        ) from None


def set_properties(obj, properties):
    """Call SetX(value) for each name; TypeError for a name that there is not, before any is set."""
    setters = {_key(name): name for name in _setters(obj)}
    for name in properties:
        if _key(name) not in setters:
            known = sorted(_snake_case(setter) for setter in setters.values())
            raise TypeError(
                f"{type(obj).__name__} has no property {name!r}; it has: {', '.join(known)}"
            )
    for name, value in properties.items():
        setter = setters[_key(name)]
        if isinstance(value, str):
            _set_by_word(obj, setter, value)
            continue
        try:
            getattr(obj, "Set" + setter)(value)
        except TypeError as error:
            raise TypeError(f"{name}={value!r}: {error}") from None
