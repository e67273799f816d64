# SPDX-License-Identifier: BSD-3-Clause
"""Where our render steps go in a renderer's chain of passes, and how they come out again.

A chain is a tree: passes hold others, as delegates, steps or items of a sequence. Somewhere in it
is what draws the scene, and our steps take that one's place and take its own steps over; what is
around them (SSAO, FXAA, EDL, blur, tone mapping ...) stays.
"""

import warnings

from vtkmodules.vtkRenderingOpenGL2 import (
    vtkDefaultPass,
    vtkDepthPeelingPass,
    vtkHiddenLineRemovalPass,
    vtkOpaquePass,
    vtkOrderIndependentTranslucentPass,
    vtkOverlayPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
    vtkShadowMapBakerPass,
    vtkShadowMapPass,
    vtkTranslucentPass,
    vtkVolumetricPass,
)

_OWN_STEPS = "_rtwshadows_own_steps"
_STEPS = ("LightsPass", "OpaquePass", "TranslucentPass", "VolumetricPass", "OverlayPass",
          "PostProcessPass")
# By these names a pass of any class holds another.
_HELD = ("DelegatePass", "CameraPass", "OpaqueSequence", "CompositeZPass") + _STEPS


class _Slot:
    """A pass that an object holds by a name: renderer.GetPass(), blur.GetDelegatePass()."""

    def __init__(self, holder, name):
        self.holder = holder
        self.name = name

    def get(self):
        return getattr(self.holder, "Get" + self.name)()

    def put(self, render_pass):
        getattr(self.holder, "Set" + self.name)(render_pass)

    def __eq__(self, other):
        return (isinstance(other, _Slot) and self.holder is other.holder
                and self.name == other.name)


class _Item:
    """A pass in a collection, which stays that collection: others may hold it, as PyVista does."""

    def __init__(self, collection, render_pass):
        self.collection = collection
        self.render_pass = render_pass

    def get(self):
        return self.render_pass if self.render_pass in _items(self.collection) else None

    def put(self, render_pass):
        items = [render_pass if item is self.render_pass else item
                 for item in _items(self.collection)]
        _fill(self.collection, [item for item in items if item is not None])
        self.render_pass = render_pass

    def __eq__(self, other):
        return (isinstance(other, _Item) and self.collection is other.collection
                and self.render_pass is other.render_pass)


def _items(collection):
    if collection is None:
        return []
    return [collection.GetItemAsObject(i) for i in range(collection.GetNumberOfItems())]


def _fill(collection, items):
    collection.RemoveAllItems()
    for item in items:
        collection.AddItem(item)


def _places_in(render_pass):
    """All places in a pass that hold another one."""
    places = [_Slot(render_pass, name) for name in _HELD
              if hasattr(render_pass, "Get" + name) and hasattr(render_pass, "Set" + name)]
    if isinstance(render_pass, vtkSequencePass):
        collection = render_pass.GetPasses()
        places += [_Item(collection, item) for item in _items(collection)]
    return places


def _places(place, seen):
    """A place and all below it that hold a pass; `seen` breaks cycles and is kept by the caller."""
    render_pass = place.get()
    if render_pass is None:
        return
    yield place
    if any(render_pass is other for other in seen):
        return
    seen.append(render_pass)
    for inner in _places_in(render_pass):
        yield from _places(inner, seen)


def _last_delegate(render_pass):
    seen = []
    while hasattr(render_pass, "GetDelegatePass") and render_pass not in seen:
        seen.append(render_pass)
        render_pass = render_pass.GetDelegatePass()
    return render_pass


def _is_whole_default(render_pass):
    """A vtkDefaultPass itself, which draws everything; its subclasses draw one step each."""
    return isinstance(render_pass, vtkDefaultPass) and (
        render_pass.GetClassName() == "vtkDefaultPass")


def _draws_opaque(render_pass):
    last = _last_delegate(render_pass)
    return isinstance(last, (vtkOpaquePass, vtkHiddenLineRemovalPass, vtkShadowMapPass)) or (
        _is_whole_default(last))


def _draws_translucent(render_pass):
    return isinstance(_last_delegate(render_pass), (
        vtkTranslucentPass, vtkDepthPeelingPass, vtkOrderIndependentTranslucentPass))


def _flat(render_pass):
    """What a pass draws one after the other: sequences by their items, VTK's own shadows without
    them, everything at once as one step each."""
    if isinstance(render_pass, vtkSequencePass):
        return [one for item in _items(render_pass.GetPasses()) for one in _flat(item)]
    if isinstance(render_pass, vtkShadowMapBakerPass):
        return []
    if isinstance(render_pass, vtkShadowMapPass):
        return _flat(render_pass.GetOpaqueSequence())
    if _is_whole_default(render_pass):
        return [vtkOpaquePass(), vtkTranslucentPass(), vtkVolumetricPass(), vtkOverlayPass()]
    return [] if render_pass is None else [render_pass]


def _sequence(passes):
    collection = vtkRenderPassCollection()
    _fill(collection, passes)
    sequence = vtkSequencePass()
    sequence.SetPasses(collection)
    return sequence


def _joined(passes):
    """One pass that draws these in turn; None for none."""
    if len(passes) > 1:
        return _sequence(passes)
    return passes[0] if passes else None


def _find_drawer(place, seen):
    """The place of what draws the scene, in a place or below it; None where none is known to."""
    render_pass = place.get()
    if render_pass is None or isinstance(render_pass, vtkRenderStepsPass):
        return place
    if any(render_pass is other for other in seen):
        return None
    seen.append(render_pass)
    if isinstance(render_pass, vtkSequencePass):
        items = _flat(render_pass)
        whole = any(isinstance(item, vtkRenderStepsPass) for item in items)
        if not whole and any(_draws_opaque(item) for item in items):
            return place
        inner = [_Item(render_pass.GetPasses(), item) for item in _items(render_pass.GetPasses())]
        found = [drawer for item in inner for drawer in [_find_drawer(item, seen)] if drawer]
        return found[0] if found else None
    if hasattr(render_pass, "GetDelegatePass"):
        return _find_drawer(_Slot(render_pass, "DelegatePass"), seen)
    return place if _draws_opaque(render_pass) else None


def _take_over(steps, render_pass):
    """Let our steps draw what a pass draws."""
    _remember_steps(steps)
    if render_pass is None:
        _restore_steps(steps)
        return
    if isinstance(render_pass, vtkRenderStepsPass):
        _copy_steps(render_pass, steps)
        return
    items = _flat(render_pass)
    opaque = next((i for i, item in enumerate(items) if _draws_opaque(item)), None)
    if opaque is None:
        _copy_steps(vtkRenderStepsPass(), steps)
        return
    rest = items[opaque + 1:]
    translucent = next((i for i, item in enumerate(rest) if _draws_translucent(item)), None)
    between = [] if translucent is None else rest[:translucent]
    after = rest if translucent is None else rest[translucent + 1:]
    steps.SetLightsPass(_joined(items[:opaque]))
    steps.SetOpaquePass(_joined([items[opaque]] + between))
    # In a sequence, since a vtkTranslucentPass itself is peeled where the renderer says so.
    steps.SetTranslucentPass(None if translucent is None else _sequence([rest[translucent]]))
    steps.SetVolumetricPass(_joined(after))
    steps.SetOverlayPass(None)
    steps.SetPostProcessPass(None)


# The steps' own follow the renderer's flags, as those that are set do not.
def _remember_steps(steps):
    if not hasattr(steps, _OWN_STEPS):
        setattr(steps, _OWN_STEPS, {name: getattr(steps, "Get" + name)() for name in _STEPS})


def _restore_steps(steps):
    for name, own in getattr(steps, _OWN_STEPS).items():
        getattr(steps, "Set" + name)(own)


def _copy_steps(source, target):
    for name in _STEPS:
        getattr(target, "Set" + name)(getattr(source, "Get" + name)())
    # The camera pass itself is bound to its own steps.
    if source.GetCameraPass() is None:
        target.SetCameraPass(None)
    elif target.GetCameraPass() is not None:
        target.GetCameraPass().SetAspectRatioOverride(
            source.GetCameraPass().GetAspectRatioOverride())


class Graft:
    """Our steps in the chain of a renderer, and what they stand for."""

    def __init__(self, renderer, steps):
        self.steps = steps
        self.left_out = None  # what draws nothing meanwhile
        self._warned = False
        self._put(renderer)

    def _put(self, renderer):
        root = _Slot(renderer, "Pass")
        place = _find_drawer(root, []) or root
        # The renderer remembers this, so that remembering the renderer would keep both for ever.
        self._inside = None if place == root else place
        self.replaced = place.get()
        self._before = self._after = None
        known = self.replaced is None or isinstance(self.replaced, vtkRenderStepsPass) or any(
            _draws_opaque(item) for item in _flat(self.replaced))
        self.left_out = None if known else self.replaced
        if not known and not self._warned:
            self._warned = True
            warnings.warn(
                f"{self.replaced.GetClassName()} draws the scene in a way that shadows can't be "
                "put into; until disable_shadows() it is left out", stacklevel=5)
        _take_over(self.steps, self.replaced)
        if isinstance(place, _Item):
            collection = place.collection
            self._before = _items(collection)
            # VTK's own shadows would be drawn over ours.
            _fill(collection, [item for item in self._before if not isinstance(
                item, (vtkShadowMapPass, vtkShadowMapBakerPass)) or item is self.replaced])
        place.put(self.steps)
        if self._before is not None:
            self._after = _items(place.collection)

    def is_in(self, renderer):
        """Whether the chain of the renderer, as it is now, draws by our steps."""
        return any(place.get() is self.steps for place in _places(_Slot(renderer, "Pass"), []))

    def keep_in(self, renderer):
        """Put our steps back into a chain that has been made anew without them."""
        if not self.is_in(renderer):
            self.remove(renderer)
            self._put(renderer)

    def remove(self, renderer):
        """Take our steps out of the chain as it is now, and nothing else."""
        root = _Slot(renderer, "Pass")
        first = self._inside or root
        places = [place for place in _places(root, []) if place.get() is self.steps]
        if first not in places and first.get() is self.steps:
            places.append(first)
        for place in places:
            if place == first and self._after is not None and (
                    _items(place.collection) == self._after):
                _fill(place.collection, self._before)
            elif place == first or place == root or self.replaced is not None:
                place.put(self.replaced)
            else:
                plain = vtkRenderStepsPass()  # what a pass needs to have something to work on
                _copy_steps(self.steps, plain)
                place.put(plain)
        # They are others' again: ours are released, and a VTK 9.1 vtkDepthPeelingPass that has been
        # released draws no more opaque props.
        _copy_steps(vtkRenderStepsPass(), self.steps)
