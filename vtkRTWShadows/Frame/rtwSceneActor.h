// SPDX-License-Identifier: BSD-3-Clause
// Which actors are plain meshes, and which meshes those are.
#ifndef rtwSceneActor_h
#define rtwSceneActor_h

#include "vtkType.h"

#include <vector>

class vtkActor;
class vtkMapper;
class vtkPolyData;

namespace rtw
{
/// Whether drawing the triangles, lines and vertices of its meshes, opaque, gives the same silhouette and depth as its own
/// mapper does. Imposters, glyphs, cut-out textures, clipping planes, wireframes and shaders with user code don't.
bool IsPlainMeshActor(vtkActor* actor);
/// Whether its own mapper then draws all of those triangles at no other depth: no culled faces, no offsets between coincident
/// primitives.
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
