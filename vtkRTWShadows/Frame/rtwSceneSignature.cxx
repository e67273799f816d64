// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwSceneSignature.h"

#include "Frame/rtwFrameScene.h"
#include "Frame/rtwSceneActor.h"
#include "Frame/rtwView.h"
#include "GL/rtwVTKCompatibility.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUniforms.h"
#include "vtkUnsignedCharArray.h"

namespace rtw
{
namespace
{
std::uint64_t MixAddress(std::uint64_t signature, const void* object)
{
  return Mix(signature, reinterpret_cast<std::uint64_t>(object));
}

// Mixes in which object it is, because one that takes another's place may be older.
std::uint64_t MixObject(std::uint64_t signature, vtkObject* object)
{
  return Mix(MixAddress(signature, object), std::uint64_t(object ? object->GetMTime() : 0));
}

// Data that is modified in place tells of it by its own time, and by those of its arrays.
std::uint64_t SignData(std::uint64_t signature, vtkDataObject* data)
{
  signature = MixObject(signature, data);
  if (!data)
  {
    return signature;
  }
  signature = Mix(signature, std::uint64_t(data->GetUpdateTime()));
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      signature = MixObject(signature, it->GetCurrentDataObject());
    }
  }
  return signature;
}

// Signs the inputs of every port, because a glyph has a source, and a cube map six images.
std::uint64_t SignInputs(std::uint64_t signature, vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      signature = SignData(signature, algorithm->GetInputDataObject(port, i));
    }
  }
  return signature;
}

// Colours decide which parts of a surface are translucent.
std::uint64_t SignColours(std::uint64_t signature, vtkScalarsToColors* colours)
{
  signature = MixObject(signature, colours);
  auto* table = vtkLookupTable::SafeDownCast(colours);
  return table ? MixObject(signature, table->GetTable()) : signature;
}

// No plane's time is among those of the collection that holds it.
std::uint64_t SignPlanes(std::uint64_t signature, vtkPlaneCollection* planes)
{
  if (!planes)
  {
    return signature;
  }
  vtkCollectionSimpleIterator it;
  planes->InitTraversal(it);
  while (vtkPlane* plane = planes->GetNextPlane(it))
  {
    signature = MixObject(signature, plane);
  }
  return signature;
}

// Setting these offsets modifies nothing.
std::uint64_t SignCoincidence(std::uint64_t signature, vtkMapper* mapper)
{
  double v[10];
  mapper->GetRelativeCoincidentTopologyPolygonOffsetParameters(v[0], v[1]);
  mapper->GetRelativeCoincidentTopologyLineOffsetParameters(v[2], v[3]);
  mapper->GetRelativeCoincidentTopologyPointOffsetParameter(v[4]);
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(v[5], v[6]);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(v[7], v[8]);
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(v[9]);
  for (const double value : v)
  {
    signature = Mix(signature, value);
  }
  return Mix(signature,
    std::uint64_t(vtkMapper::GetResolveCoincidentTopology()) |
      std::uint64_t(vtkMapper::GetResolveCoincidentTopologyPolygonOffsetFaces()) << 8);
}

// User code moves vertices and cuts holes, by uniforms too.
std::uint64_t SignShaders(std::uint64_t signature, vtkShaderProperty* shaders)
{
  signature = Mix(signature, std::uint64_t(shaders->GetShaderMTime()));
  for (vtkUniforms* uniforms : { shaders->GetVertexCustomUniforms(),
         shaders->GetFragmentCustomUniforms(), shaders->GetGeometryCustomUniforms() })
  {
    signature = MixObject(signature, uniforms);
  }
  return signature;
}

std::uint64_t SignProperty(std::uint64_t signature, vtkProperty* property)
{
  signature = MixObject(signature, property);
  if (property)
  {
    for (const auto& texture : property->GetAllTextures())
    {
      signature = SignTexture(signature, texture.second);
    }
  }
  return signature;
}

// Programs may set a texture's transform past the texture.
std::uint64_t SignKeys(std::uint64_t signature, vtkInformation* keys)
{
  vtkInformationDoubleVectorKey* const key = vtkProp::GeneralTextureTransform();
  if (keys && keys->Has(key))
  {
    const double* values = keys->Get(key);
    for (int i = 0; i < keys->Length(key); ++i)
    {
      signature = Mix(signature, values[i]);
    }
  }
  return signature;
}
}

void UpdateTexture(vtkTexture* texture)
{
  for (int port = 0; port < texture->GetNumberOfInputPorts(); ++port)
  {
    if (vtkAlgorithm* source = texture->GetInputAlgorithm(port, 0))
    {
      source->UpdateWholeExtent();
    }
  }
}

std::uint64_t SignTexture(std::uint64_t signature, vtkTexture* texture)
{
  signature = MixObject(signature, texture);
  if (!texture)
  {
    return signature;
  }
  UpdateTexture(texture);
  signature = MixObject(signature, texture->GetTransform());
  signature = SignColours(signature, texture->GetLookupTable());
  return SignInputs(signature, texture);
}

std::uint64_t SignMapper(std::uint64_t signature, vtkMapper* mapper)
{
  signature = MixObject(signature, mapper);
  if (!mapper)
  {
    return signature;
  }
  signature = SignPlanes(signature, mapper->GetClippingPlanes());
  signature = SignCoincidence(signature, mapper);
  signature = SignInputs(signature, mapper);
  if (mapper->GetScalarVisibility())
  {
    signature = SignColours(signature, mapper->GetLookupTable());
  }
  if (IsCompositeMeshMapper(mapper))
  {
    signature = MixObject(signature, CompositeAttributesOf(mapper));
  }
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    signature = MixObject(signature, glyphs->GetBlockAttributes());
  }
  if (auto* gaussians = vtkPointGaussianMapper::SafeDownCast(mapper))
  {
    signature = MixObject(signature, gaussians->GetScaleFunction());
    signature = MixObject(signature, gaussians->GetScalarOpacityFunction());
  }
  return signature;
}

std::uint64_t SignActor(std::uint64_t signature, vtkActor* actor)
{
  signature = Mix(signature,
    std::uint64_t(actor->GetVisibility() != 0) | std::uint64_t(actor->GetForceOpaque()) << 1 |
      std::uint64_t(actor->GetForceTranslucent()) << 2);
  signature = SignProperty(signature, actor->GetProperty());
  signature = SignProperty(signature, actor->GetBackfaceProperty());
  signature = SignTexture(signature, actor->GetTexture());
  signature = SignKeys(signature, actor->GetPropertyKeys());
  signature = SignShaders(signature, actor->GetShaderProperty());
  return SignMapper(signature, actor->GetMapper());
}

std::uint64_t SignPart(std::uint64_t signature, const ScenePart& part)
{
  signature = MixAddress(signature, part.Data);
  signature = Mix(signature, std::uint64_t(MeshTime(part.Data)));
  const ThickLook& look = part.Look;
  signature = Mix(Mix(signature, look.LineWidth), look.PointSize);
  signature =
    Mix(signature, std::uint64_t(look.Drawn) << 1 | std::uint64_t(look.AllPoints ? 1 : 0));
  return Mix(Mix(signature, std::uint64_t(part.Receives) | std::uint64_t(part.Hides) << 1),
    part.ToWorld);
}

std::uint64_t SignProp(std::uint64_t signature, vtkProp* prop)
{
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    vtkProp* leaf = node->GetViewProp();
    auto* actor = vtkActor::SafeDownCast(leaf);
    signature = MixAddress(signature, leaf);
    if (node->GetMatrix())
    {
      signature = Mix(signature, ToGlm(node->GetMatrix()));
    }
    // Assemblies move their parts to draw them, which modifies those each time.
    if (leaf == prop || !actor)
    {
      signature = Mix(signature, std::uint64_t(leaf->GetRedrawMTime()));
    }
    if (actor)
    {
      signature = SignActor(signature, actor);
    }
  }
  return signature;
}
}
