# SPDX-License-Identifier: BSD-3-Clause
"""Properties of a VTK object by keyword: focus_on_view=True, FocusOnView=True, filter="pcf"."""

import math
import numbers
import re

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_STRING, vtkObject


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


class _Refusals:
    """While one is open, what an object and its parts say against a value is collected, not
    printed."""

    def __init__(self, obj):
        self._objects = [obj] + _parts(obj)
        self.texts = []

    def __enter__(self):
        @calldata_type(VTK_STRING)
        def note(_object, _event, text):
            self.texts.append(text)

        self._tags = [(one, one.AddObserver("ErrorEvent", note)) for one in self._objects]
        return self

    def __exit__(self, *_):
        for one, tag in self._tags:
            one.RemoveObserver(tag)


_NOTHING = object()


def _parts(obj):
    """The objects to which settings go that are not the object's own: its warp and its partition."""
    parts = [getattr(obj, "Get" + name)() for name in ("Warp", "Partition", "ShadowMapBakerPass")
             if hasattr(obj, "Get" + name)]
    return [part for part in parts if isinstance(part, vtkObject)]


def _get(obj, setter):
    try:
        return getattr(obj, "Get" + setter)()
    except (AttributeError, TypeError):
        return _NOTHING


def _is_same(value, got):
    """Whether a getter gives what was set; True where the two can't be compared."""
    if isinstance(got, bool):
        return not isinstance(value, (bool, int)) or bool(value) == got
    if isinstance(got, (int, float)) and isinstance(value, numbers.Real):
        return math.isclose(value, got, rel_tol=1e-6, abs_tol=1e-30)
    if isinstance(got, tuple) and isinstance(value, (tuple, list)):
        return len(value) == len(got) and all(map(_is_same, value, got))
    return True


def _is_nan(value):
    if isinstance(value, (tuple, list)):
        return any(map(_is_nan, value))
    return isinstance(value, numbers.Real) and math.isnan(value)


def _expectation(texts):
    """What the C++ class says that it expects: "... expected a number from 0 to 1; keeping 2"."""
    for text in texts:
        match = re.search(r"expected (.*?)(?:; keeping|\s*$)", text, re.DOTALL)
        if match:
            return "expected " + match.group(1)
    said = " ".join(" ".join(texts).split())
    return re.sub(r"^ERROR: In .*?\): ", "", said)


def _declared_range(obj, setter):
    for part in [obj] + _parts(obj):
        try:
            low = getattr(part, f"Get{setter}MinValue")()
            high = getattr(part, f"Get{setter}MaxValue")()
        except AttributeError:
            continue
        return f"expected a number from {low:g} to {high:g}"
    return ""


def _tried_range(obj, setter):
    """The values that very small and very large ones are clamped to, on an object that nobody uses."""
    scratch = type(obj)()
    whole = isinstance(_get(scratch, setter), int)
    ends = []
    for extreme in ((-2**31, 2**31 - 1) if whole else (-1e30, 1e30)):
        with _Refusals(scratch) as refusals:
            try:
                getattr(scratch, "Set" + setter)(extreme)
            except (TypeError, OverflowError, ValueError):
                continue
        if refusals.texts:
            return _expectation(refusals.texts)
        ends.append(_get(scratch, setter))
    if len(ends) < 2:
        with _Refusals(scratch) as refusals:
            getattr(scratch, "Set" + setter)(0)
        return _expectation(refusals.texts) if refusals.texts else "expected 0 or a larger number"
    return f"expected a number from {ends[0]:g} to {ends[1]:g}"


def _range(obj, setter, texts):
    if texts:
        return _expectation(texts)
    if isinstance(_get(obj, setter), tuple):
        return "expected finite numbers, within what the class documents"
    return _declared_range(obj, setter) or _tried_range(obj, setter)


def _call(obj, name, setter, value):
    """Set a value; ValueError for one that is refused or would be taken for another."""
    before = _get(obj, setter)
    outside = _is_nan(value)
    with _Refusals(obj) as refusals:
        try:
            if isinstance(value, str):
                _set_by_word(obj, setter, value)
            else:
                getattr(obj, "Set" + setter)(value)
        except TypeError as error:
            if not outside:  # which an integer's setter takes for another type
                raise TypeError(f"{name}={value!r}: {error}") from None
        except OverflowError as error:
            outside = str(error)
        got = _get(obj, setter)
        refused = outside or refusals.texts or (
            not isinstance(value, str) and got is not _NOTHING and not _is_same(value, got))
        if refused and before is not _NOTHING and got != before:
            getattr(obj, "Set" + setter)(before)
    if refused:
        beyond = f" ({outside})" if isinstance(outside, str) else ""
        raise ValueError(
            f"{name}={value!r} is refused: {_range(obj, setter, refusals.texts)}{beyond}")
    return before


def set_properties(obj, properties):
    """Call SetX(value) for each name, and see that the value is taken.

    Names are in either spelling, enumerators may be words: focus_on_view=True, filter="pcf".

    Raises TypeError for a name that there is not and for a value of another type, ValueError,
    with the range, for one that is refused or would be clamped. Then nothing is set: what came
    before it is set back.
    """
    setters = {_key(name): name for name in _setters(obj)}
    for name in properties:
        if _key(name) not in setters:
            known = sorted(_snake_case(setter) for setter in setters.values())
            raise TypeError(
                f"{type(obj).__name__} has no property {name!r}; it has: {', '.join(known)}"
            )
    done = []
    try:
        for name, value in properties.items():
            setter = setters[_key(name)]
            done.append((setter, _call(obj, name, setter, value)))
    except (TypeError, ValueError):
        for setter, before in reversed(done):
            if before is not _NOTHING:
                getattr(obj, "Set" + setter)(before)
        raise
