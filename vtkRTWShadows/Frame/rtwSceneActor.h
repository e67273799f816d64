// SPDX-License-Identifier: BSD-3-Clause
// Which actors are plain meshes, and which meshes those are.
#ifndef rtwSceneActor_h
#define rtwSceneActor_h

#include "Frame/rtwThickLook.h"

#include "vtkType.h"

#include <vector>

class vtkActor;
class vtkMapper;
class vtkPolyData;

namespace rtw
{
/// Whether an actor draws the triangles, lines and vertices of its meshes, opaque, so that these
/// cast its shadow. False for imposters, glyphs, cut-out textures, clipping planes and shaders with
/// user code.
bool IsPlainMeshActor(vtkActor* actor);
/// How an actor draws lines and points.
ThickLook LookOf(vtkActor* actor);
/// Whether any lines or points of an actor are wider than one pixel, or round, or all that is drawn
/// of a surface: then only its own mapper draws what is seen of it.
bool IsThickActor(vtkActor* actor);
/// Whether the mapper of an actor that isn't thick draws all of its triangles at no other depth: no
/// culled faces, no offsets between coincident primitives.
bool DrawsAllAsIs(vtkActor* actor);
/// An actor's mapper; for an actor with levels of detail the mapper of the level that it will draw.
vtkMapper* ChosenMapper(vtkActor* actor);
/// Whether an actor chooses what to draw in each Render; it is taken to draw the level that it would choose now.
bool ChoosesMapper(vtkActor* actor);
/// The meshes of a plain mesh actor, brought up to date; hidden blocks of a composite dataset left
/// out.
std::vector<vtkPolyData*> MeshesOf(vtkActor* actor);
/// When a mesh's geometry last changed.
vtkMTimeType MeshTime(vtkPolyData* mesh);
}

#endif
