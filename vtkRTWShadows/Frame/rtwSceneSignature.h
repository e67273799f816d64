// SPDX-License-Identifier: BSD-3-Clause
// Signatures, by which a frame is recognised as being like the one before: numbers that change
// whenever something does that shadows depend on.
#ifndef rtwSceneSignature_h
#define rtwSceneSignature_h

#include "vtkType.h"

#include <cstdint>

class vtkActor;
class vtkMapper;
class vtkProp;
class vtkTexture;

namespace rtw
{
struct ScenePart;

/// The signature of a mesh that is drawn from buffers of our own: its geometry and its place, and
/// nothing of how it looks.
std::uint64_t SignPart(std::uint64_t signature, const ScenePart& part);

/// The signature of a prop that VTK's mappers draw: all that may change its silhouette or what it
/// cuts out, and in doubt more than that. What its bounds depend on has to be up to date.
std::uint64_t SignProp(std::uint64_t signature, vtkProp* prop);

/// The signature of one actor, for props that hold mappers in ways of their own.
std::uint64_t SignActor(std::uint64_t signature, vtkActor* actor);
std::uint64_t SignMapper(std::uint64_t signature, vtkMapper* mapper);
std::uint64_t SignTexture(std::uint64_t signature, vtkTexture* texture);

/// Brings the images of a texture up to date, as drawing it does.
void UpdateTexture(vtkTexture* texture);
}

#endif
