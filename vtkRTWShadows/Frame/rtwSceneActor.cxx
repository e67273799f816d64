// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwSceneActor.h"

#include "Frame/rtwSceneSignature.h"
#include "GL/rtwVTKCompatibility.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMapperCollection.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#if VTK_MODULE_ENABLE_VTK_RenderingLOD
#include "vtkLODActor.h"
#endif

namespace rtw
{
namespace
{
#if VTK_MODULE_ENABLE_VTK_RenderingLOD
// The level that vtkLODActor::Render will choose: by the time that each level took when it was last
// drawn, the untried first. Nothing that the choice depends on changes between here and there.
vtkMapper* ChosenLevel(vtkLODActor* actor)
{
  const float allowed = static_cast<float>(actor->GetAllocatedRenderTime());
  vtkMapper* best = actor->GetMapper();
  float bestTime = static_cast<float>(best->GetTimeToDraw());
  if (bestTime <= allowed)
  {
    return best;
  }
  vtkMapperCollection* levels = actor->GetLODMappers();
  vtkCollectionSimpleIterator it;
  levels->InitTraversal(it);
  for (vtkMapper* level = levels->GetNextMapper(it); level && bestTime != 0;
       level = levels->GetNextMapper(it))
  {
    const float time = static_cast<float>(level->GetTimeToDraw());
    if (time == 0 || (bestTime > allowed && time < bestTime) ||
      (time > bestTime && time < allowed))
    {
      best = level;
      bestTime = time;
    }
  }
  return best;
}
#endif

// Whether VTK draws nothing but what the mapper is given, where the actor's matrix says. An actor of
// any other class may draw something else, as vtkQuadricLODActor does.
bool DrawsItsMapper(vtkActor* actor)
{
  const char* const known[] = { "vtkActor", "vtkFollower", "vtkOpenGLActor",
#if VTK_MODULE_ENABLE_VTK_RenderingLOD
    "vtkLODActor"
#endif
  };
  return std::any_of(std::begin(known), std::end(known),
    [actor](const char* name) { return std::strcmp(actor->GetClassName(), name) == 0; });
}

// Whether a mapper draws what it did when it last set up the mapper of its surface, which it does only to draw.
bool IsSetUp(vtkDataSetMapper* mapper, vtkMapper* surface)
{
  if (mapper->GetNumberOfInputConnections(0) == 0 || surface->GetNumberOfInputConnections(0) == 0 ||
    mapper->GetClippingPlanes() != surface->GetClippingPlanes())
  {
    return false;
  }
  mapper->Update(); // because the surface is cut off from where the data comes from
  vtkAlgorithm* source = surface->GetInputAlgorithm();
  return surface->GetInputConnection(0, 0) == mapper->GetInputConnection(0, 0) ||
    (source->GetNumberOfInputPorts() > 0 && source->GetNumberOfInputConnections(0) > 0 &&
      source->GetInputDataObject(0, 0) == mapper->GetInput());
}

// The mapper that draws an actor: for a vtkDataSetMapper the one of its surface, which exists from
// its first frame on.
vtkMapper* DrawingMapper(vtkActor* actor)
{
  vtkMapper* mapper = ChosenMapper(actor);
  if (!mapper || std::strcmp(mapper->GetClassName(), "vtkDataSetMapper") != 0)
  {
    return mapper;
  }
  auto* whole = vtkDataSetMapper::SafeDownCast(mapper);
  vtkMapper* surface = whole->GetPolyDataMapper();
  return surface && IsSetUp(whole, surface) ? surface : mapper;
}

bool CutsOut(vtkTexture* texture)
{
  if (!texture)
  {
    return false;
  }
  UpdateTexture(texture);
  if (!texture->GetInput())
  {
    return false;
  }
  const int components = texture->GetInput()->GetNumberOfScalarComponents();
  vtkScalarsToColors* colours = texture->GetLookupTable();
  return components == 2 || components == 4 || (colours && !colours->IsOpaque());
}

bool HasCutOuts(vtkActor* actor)
{
  const auto& textures = actor->GetProperty()->GetAllTextures();
  return CutsOut(actor->GetTexture()) ||
    std::any_of(textures.begin(), textures.end(),
      [](const auto& texture) { return texture.first == "albedoTex" && CutsOut(texture.second); });
}

bool HasUserShaders(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
    shaders->HasFragmentShaderCode() || shaders->HasGeometryShaderCode();
}

bool HasTranslucentScalars(vtkActor* actor, vtkMapper* mapper)
{
  return mapper->GetScalarVisibility() && actor->GetProperty()->GetOpacity() >= 1 &&
    actor->HasTranslucentPolygonalGeometry();
}

void CollectBlocks(vtkDataObject* block, bool visible,
  const vtkCompositeDataDisplayAttributes* attributes, std::vector<vtkPolyData*>& meshes)
{
  if (attributes && attributes->HasBlockVisibility(block))
  {
    visible = attributes->GetBlockVisibility(block);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(block))
  {
    vtkSmartPointer<vtkDataObjectTreeIterator> it =
      vtk::TakeSmartPointer(tree->NewTreeIterator());
    it->TraverseSubTreeOff();
    it->VisitOnlyLeavesOff();
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      CollectBlocks(it->GetCurrentDataObject(), visible, attributes, meshes);
    }
  }
  else if (auto* mesh = vtkPolyData::SafeDownCast(block))
  {
    if (visible && mesh->GetNumberOfCells() > 0)
    {
      meshes.push_back(mesh);
    }
  }
}
}

vtkMapper* ChosenMapper(vtkActor* actor)
{
#if VTK_MODULE_ENABLE_VTK_RenderingLOD
  auto* levels = vtkLODActor::SafeDownCast(actor);
  return levels && actor->GetMapper() ? ChosenLevel(levels) : actor->GetMapper();
#else
  return actor->GetMapper();
#endif
}

std::vector<vtkPolyData*> MeshesOf(vtkActor* actor)
{
  vtkMapper* mapper = DrawingMapper(actor);
  if (mapper->GetNumberOfInputConnections(0) == 0)
  {
    return {};
  }
  if (!mapper->GetStatic())
  {
    mapper->Update();
  }
  std::vector<vtkPolyData*> meshes;
  vtkCompositeDataDisplayAttributes* attributes =
    IsCompositeMeshMapper(mapper) ? CompositeAttributesOf(mapper) : nullptr;
  if (vtkDataObject* input = mapper->GetInputDataObject(0, 0))
  {
    CollectBlocks(input, true, attributes, meshes);
  }
  return meshes;
}

bool ChoosesMapper(vtkActor* actor)
{
  return actor->IsA("vtkLODActor");
}

bool IsPlainMeshActor(vtkActor* actor)
{
  vtkMapper* mapper = DrawingMapper(actor);
  if (!DrawsItsMapper(actor) || !mapper || !(IsMeshMapper(mapper) || IsCompositeMeshMapper(mapper)))
  {
    return false;
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  if ((planes && planes->GetNumberOfItems() > 0) || HasUserShaders(actor) || HasCutOuts(actor))
  {
    return false;
  }
  MeshesOf(actor); // so that scalars are looked at as they will be drawn
  return !HasTranslucentScalars(actor, mapper);
}

ThickLook LookOf(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  const int representation = property->GetRepresentation();
  ThickLook look;
  look.Drawn = representation == VTK_SURFACE ? ThickLook::Shape::Surface
    : representation == VTK_WIREFRAME        ? ThickLook::Shape::Edges
                                             : ThickLook::Shape::Points;
  // Flat points lie on the surface; only spheres stand out of it.
  look.AllPoints = property->GetVertexVisibility() && property->GetRenderPointsAsSpheres();
  look.LineWidth = property->GetLineWidth();
  look.PointSize = property->GetPointSize();
  return look;
}

bool IsThickActor(vtkActor* actor)
{
  const ThickLook look = LookOf(actor);
  const bool lines = look.LineWidth > 1;
  const bool points = look.PointSize > 1 || actor->GetProperty()->GetRenderPointsAsSpheres();
  if (look.Drawn != ThickLook::Shape::Surface || look.AllPoints)
  {
    return true;
  }
  const std::vector<vtkPolyData*> meshes = MeshesOf(actor);
  return std::any_of(meshes.begin(), meshes.end(), [&](vtkPolyData* mesh) {
    return (lines && mesh->GetNumberOfLines() > 0) || (points && mesh->GetNumberOfVerts() > 0);
  });
}

bool DrawsAllAsIs(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  const std::vector<vtkPolyData*> meshes = MeshesOf(actor);
  return !property->GetBackfaceCulling() && !property->GetFrontfaceCulling() &&
    !property->GetEdgeVisibility() && !property->GetVertexVisibility() &&
    vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_OFF &&
    std::all_of(meshes.begin(), meshes.end(), [](vtkPolyData* mesh) {
      return mesh->GetNumberOfLines() == 0 && mesh->GetNumberOfVerts() == 0;
    });
}

vtkMTimeType MeshTime(vtkPolyData* mesh)
{
  vtkMTimeType time = mesh->GetPoints() ? mesh->GetPoints()->GetMTime() : 0;
  for (vtkCellArray* cells :
    { mesh->GetPolys(), mesh->GetStrips(), mesh->GetLines(), mesh->GetVerts() })
  {
    time = std::max(time, cells ? cells->GetMTime() : 0);
  }
  return std::max(time, mesh->vtkDataObject::GetMTime());
}
}
