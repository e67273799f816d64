// SPDX-License-Identifier: BSD-3-Clause
#include "rtwFrameScene.h"

#include "rtwSceneActor.h"
#include "rtwSceneSignature.h"
#include "rtwView.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCollection.h"
#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <cmath>
#include <cstring>
#include <utility>

namespace rtw
{
std::uint64_t Mix(std::uint64_t signature, std::uint64_t value)
{
  signature ^= value + 0x9e3779b97f4a7c15ull + (signature << 12) + (signature >> 4);
  return signature * 0xff51afd7ed558ccdull;
}

std::uint64_t Mix(std::uint64_t signature, double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return Mix(signature, bits);
}

std::uint64_t Mix(std::uint64_t signature, const glm::dmat4& matrix)
{
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      signature = Mix(signature, matrix[column][row]);
    }
  }
  return signature;
}

void AddCorners(const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& transform,
  std::vector<glm::dvec3>& corners)
{
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 corner(
      i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z, 1);
    corners.emplace_back(transform * corner);
  }
}

namespace
{
bool Flag(vtkProp* prop, vtkInformationIntegerKey* key)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

// Text that faces the viewer, the sky and the like are no part of the world that light falls on.
bool IsWorldly(vtkProp* prop)
{
  return (prop->IsA("vtkActor") && !prop->IsA("vtkSkybox")) || prop->IsA("vtkAssembly") ||
    prop->IsA("vtkLODProp3D");
}

// Whether props that the cullers leave out can't be seen.
bool KeepsAllInView(vtkRenderer* renderer)
{
  vtkCullerCollection* cullers = renderer->GetCullers();
  vtkCollectionSimpleIterator it;
  cullers->InitTraversal(it);
  while (vtkCuller* culler = cullers->GetNextCuller(it))
  {
    auto* coverage = vtkFrustumCoverageCuller::SafeDownCast(culler);
    if (!coverage || coverage->GetMinimumCoverage() > 0)
    {
      return false;
    }
  }
  return true;
}

struct Collector
{
  FrameScene Result;
  SceneKeys Keys;
  bool OwnDrawing;

  void AddBounds(vtkProp* prop, bool plain, bool unsampledReceiver)
  {
    const double* b = prop->GetBounds();
    if (!b || !(b[0] <= b[1] && b[2] <= b[3] && b[4] <= b[5]))
    {
      return;
    }
    for (int i = 0; i < 6; ++i)
    {
      if (!std::isfinite(b[i]))
      {
        return;
      }
    }
    const glm::dvec3 low(b[0], b[2], b[4]), high(b[1], b[3], b[5]);
    FrameScene& scene = this->Result;
    scene.Low = scene.HasBounds ? glm::min(scene.Low, low) : low;
    scene.High = scene.HasBounds ? glm::max(scene.High, high) : high;
    scene.HasBounds = true;
    if (!plain)
    {
      AddCorners(low, high, glm::dmat4(1), scene.PropCorners);
    }
    if (unsampledReceiver)
    {
      AddCorners(low, high, glm::dmat4(1), scene.UnsampledReceivers);
    }
  }

  // The parts of a prop where each of them is a plain mesh; none otherwise.
  bool CollectMeshes(vtkProp* prop, bool casts, bool receives, std::vector<ScenePart>& parts)
  {
    bool plain = this->OwnDrawing;
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      auto* actor = vtkActor::SafeDownCast(node->GetViewProp());
      plain = plain && actor && IsPlainMeshActor(actor);
      if (!plain)
      {
        continue; // to the end, because the traversal has to be finished
      }
      if (actor->GetVisibility() && actor->GetProperty()->GetOpacity() > 0)
      {
        const glm::dmat4 toWorld = node->GetMatrix() ? ToGlm(node->GetMatrix()) : glm::dmat4(1);
        const bool opaque = actor->GetProperty()->GetOpacity() >= 1;
        this->Result.SamplesAreComplete = this->Result.SamplesAreComplete && DrawsAllAsIs(actor);
        const bool lit = receives && actor->GetProperty()->GetLighting();
        for (vtkPolyData* mesh : MeshesOf(actor))
        {
          parts.push_back({ mesh, toWorld, casts, lit && opaque, !lit && opaque });
        }
      }
    }
    return plain;
  }

  void MixIn(vtkProp* prop, const std::vector<ScenePart>& parts, bool casts, bool receives)
  {
    std::uint64_t& signature = this->Result.Signature;
    signature = Mix(signature, reinterpret_cast<std::uint64_t>(prop));
    signature = Mix(signature, std::uint64_t(casts) | std::uint64_t(receives) << 1);
    if (parts.empty())
    {
      signature = SignProp(signature, prop);
    }
    for (const ScenePart& part : parts)
    {
      signature = SignPart(signature, part);
    }
  }

  void Add(vtkProp* prop)
  {
    if (!prop->GetVisibility() || !IsWorldly(prop))
    {
      return;
    }
    const bool casts = Flag(prop, this->Keys.Casts), receives = Flag(prop, this->Keys.Receives);
    std::vector<ScenePart> parts;
    const bool plain = this->CollectMeshes(prop, casts, receives, parts);
    if (!plain)
    {
      parts.clear();
      this->Result.SamplesAreComplete = false;
      this->Result.Props.push_back(
        { prop, casts, receives, prop->HasTranslucentPolygonalGeometry() != 0 });
    }
    // Bounds need an updated pipeline, which collecting the meshes saw to.
    this->AddBounds(prop, plain, receives && prop->HasTranslucentPolygonalGeometry());
    this->MixIn(prop, parts, casts, receives);
    this->Result.Shaded.push_back(prop);
    this->Result.Parts.insert(this->Result.Parts.end(), parts.begin(), parts.end());
  }
};
}

FrameScene CollectScene(vtkRenderer* renderer, const SceneKeys& keys, bool ownDrawing)
{
  Collector collector{ {}, keys, ownDrawing };
  collector.Result.SamplesAreComplete = KeepsAllInView(renderer);
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    collector.Add(prop);
  }
  return std::move(collector.Result);
}
}
