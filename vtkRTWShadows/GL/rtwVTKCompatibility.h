// SPDX-License-Identifier: BSD-3-Clause
// The one place that knows how the supported versions of VTK differ, but for the OpenGL loader (rtwOpenGL.h).
#ifndef rtwVTKCompatibility_h
#define rtwVTKCompatibility_h

#include <string>

class vtkAbstractMapper;
class vtkCompositeDataDisplayAttributes;
class vtkMapper;
class vtkObject;
class vtkOpenGLVertexArrayObject;
class vtkRenderer;

namespace rtw
{
/// Whether a mapper draws each leaf of a composite dataset as a plain mesh.
bool IsCompositeMeshMapper(vtkMapper* mapper);
/// Which blocks such a mapper shows; null where it has no such thing.
vtkCompositeDataDisplayAttributes* CompositeAttributesOf(vtkMapper* mapper);
/// Whether a mapper draws one mesh, as it is; false for its subclasses, such as the imposters.
bool IsMeshMapper(vtkMapper* mapper);
/// An object's class and address, and the name that somebody gave it, where VTK has such names
/// (from 9.2 on).
std::string NameOf(vtkObject* object);
/// Whether a renderer without depth peeling blends translucent props whatever their order: until 9.5 each does.
bool BlendsInAnyOrder(vtkRenderer* renderer);

/// The kinds of primitives that a mesh mapper keeps apart.
enum class MeshPrimitive
{
  Points,
  Lines,
  Others
};
/// The kind of primitives that a mapper draws from an array; Others also where the array is none of
/// a mesh mapper's.
MeshPrimitive PrimitiveOf(vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* array);
}

#endif
