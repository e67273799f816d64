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
/// Whether what it draws is the triangles, lines and vertices of its meshes, opaque, so that they cast its shadow. Of imposters,
/// glyphs, cut-out textures, clipping planes and shaders with user code that isn't so.
bool IsPlainMeshActor(vtkActor* actor);
/// How it draws lines and points.
ThickLook LookOf(vtkActor* actor);
/// Whether any of them are wider than one pixel, or round, or all that is drawn of a surface: then only its own mapper draws what
/// is seen of it.
bool IsThickActor(vtkActor* actor);
/// Whether the mapper of one that isn't draws all of its triangles at no other depth: no culled faces, no offsets between
/// coincident primitives.
bool DrawsAllAsIs(vtkActor* actor);
/// An actor's mapper; of one with levels of detail that of the level that it will draw.
vtkMapper* ChosenMapper(vtkActor* actor);
/// Whether an actor chooses what to draw in each Render; it is taken to draw the level that it would choose now.
bool ChoosesMapper(vtkActor* actor);
/// The meshes of such an actor, brought up to date; hidden blocks of a composite dataset left out.
std::vector<vtkPolyData*> MeshesOf(vtkActor* actor);
/// When a mesh's geometry last changed.
vtkMTimeType MeshTime(vtkPolyData* mesh);
}

#endif
