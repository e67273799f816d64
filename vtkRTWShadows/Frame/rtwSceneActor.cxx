// SPDX-License-Identifier: BSD-3-Clause
#include "rtwSceneActor.h"

#include "rtwSceneSignature.h"
#include "rtwVTKCompatibility.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
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

namespace rtw
{
namespace
{
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

// Of a vtkDataSetMapper the mapper that draws its surface, which exists from its first frame on.
vtkMapper* DrawingMapper(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
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

// Tubes and spheres are made by fragment shaders around lines and vertices.
bool HasRoundPrimitives(vtkActor* actor, const std::vector<vtkPolyData*>& meshes)
{
  const bool tubes = actor->GetProperty()->GetRenderLinesAsTubes();
  const bool spheres = actor->GetProperty()->GetRenderPointsAsSpheres();
  return std::any_of(meshes.begin(), meshes.end(), [&](vtkPolyData* mesh) {
    return (tubes && mesh->GetNumberOfLines() > 0) || (spheres && mesh->GetNumberOfVerts() > 0);
  });
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

// Of an actor with levels of detail this is the finest, whichever is seen: shadows don't change while the view moves.
bool IsPlainMeshActor(vtkActor* actor)
{
  vtkMapper* mapper = DrawingMapper(actor);
  if (!mapper || !(IsMeshMapper(mapper) || IsCompositeMeshMapper(mapper)))
  {
    return false;
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    (planes && planes->GetNumberOfItems() > 0) || HasUserShaders(actor) || HasCutOuts(actor))
  {
    return false;
  }
  return !HasRoundPrimitives(actor, MeshesOf(actor)) && !HasTranslucentScalars(actor, mapper);
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
