// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwVTKCompatibility.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMapper.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkVersionMacros.h"

#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 3)
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <sstream>

namespace rtw
{
namespace
{
bool IsOneOf(vtkMapper* mapper, std::initializer_list<const char*> names)
{
  return std::any_of(names.begin(), names.end(),
    [mapper](const char* name) { return std::strcmp(mapper->GetClassName(), name) == 0; });
}
}

namespace
{
// Opens a mapper's protected arrays: nothing else tells what is being drawn.
struct OpenMapper : vtkOpenGLPolyDataMapper
{
  static vtkOpenGLVertexArrayObject* ArrayOf(vtkOpenGLPolyDataMapper* mapper, PrimitiveTypes kind)
  {
    return (mapper->*(&OpenMapper::Primitives))[kind].VAO;
  }
};
}

MeshPrimitive PrimitiveOf(vtkAbstractMapper* mapper, vtkOpenGLVertexArrayObject* array)
{
  auto* mesh = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  if (!mesh || !array)
  {
    return MeshPrimitive::Others;
  }
  return array == OpenMapper::ArrayOf(mesh, OpenMapper::PrimitivePoints) ? MeshPrimitive::Points
    : array == OpenMapper::ArrayOf(mesh, OpenMapper::PrimitiveLines)     ? MeshPrimitive::Lines
                                                                         : MeshPrimitive::Others;
}

bool IsCompositeMeshMapper(vtkMapper* mapper)
{
  return IsOneOf(mapper,
    { "vtkCompositePolyDataMapper", "vtkCompositePolyDataMapper2",
      "vtkOpenGLCompositePolyDataMapper" });
}

vtkCompositeDataDisplayAttributes* CompositeAttributesOf(vtkMapper* mapper)
{
  auto* composite = CompositeMapper::SafeDownCast(mapper);
  return composite ? composite->GetCompositeDataDisplayAttributes() : nullptr;
}

std::string NameOf(vtkObject* object)
{
#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 2)
  return object->GetObjectDescription();
#else
  std::ostringstream name;
  name << object->GetClassName() << " (" << object << ")";
  return name.str();
#endif
}

bool IsMeshMapper(vtkMapper* mapper)
{
  return IsOneOf(mapper,
    { "vtkOpenGLPolyDataMapper", "vtkOpenGLPolyDataMapper2", "vtkOpenGLLowMemoryPolyDataMapper" });
}
bool BlendsInAnyOrder([[maybe_unused]] vtkRenderer* renderer)
{
#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 5)
  return renderer->GetUseOIT();
#else
  return true;
#endif
}
}
