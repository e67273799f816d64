// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwFrameScene.h"

#include "Frame/rtwSceneActor.h"
#include "Frame/rtwSceneLeaves.h"
#include "Frame/rtwSceneSignature.h"
#include "Frame/rtwView.h"

#include "vtkActor.h"
#include "vtkCollection.h"
#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
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

vtkInformation* KeysOf(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  return prop->GetPropertyKeys();
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
  struct KnownLeaf
  {
    const vtkObjectBase* Keys;
    const vtkObjectBase* Mapper;
    const vtkObjectBase* Actor;
  };

  FrameScene Result;
  SceneKeys Keys;
  bool OwnDrawing;
  std::vector<KnownLeaf> Leaves;

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

  // Notes how a leaf is shaded, also for the actors that VTK draws in its stead, with its keys.
  void Shade(vtkProp* owner, const SceneLeaf& leaf, const SceneShading& shading, bool mixed)
  {
    const bool isUsual = shading == SceneShading();
    auto& all = this->Result.Shadings;
    const auto add = [&all, &shading](const vtkObjectBase* object) {
      SceneShading& there = all[object];
      there.DrawsItself = there.DrawsItself || shading.DrawsItself;
      there.IsUnsampled = there.IsUnsampled || shading.IsUnsampled;
    };
    if (!isUsual || mixed)
    {
      add(leaf.Actor);
      add(KeysOf(owner));
      add(ChosenMapper(leaf.Actor));
    }
    if (mixed)
    {
      all[KeysOf(owner)].IsMixed = true;
    }
  }

  // With `seen` off they only cast.
  void AddMeshes(const SceneLeaf& leaf, bool casts, bool receives, bool seen, std::vector<ScenePart>& parts)
  {
    vtkActor* actor = leaf.Actor;
    vtkProperty* property = actor->GetProperty();
    if (property->GetOpacity() <= 0)
    {
      return;
    }
    const bool opaque = !actor->HasTranslucentPolygonalGeometry();
    // What is drawn as if it were opaque may still show what is behind it.
    const bool complete =
      DrawsAllAsIs(actor) && !leaf.Level && (!opaque || property->GetOpacity() >= 1);
    this->Result.SamplesAreComplete = this->Result.SamplesAreComplete && complete;
    const bool lit = receives && property->GetLighting();
    for (vtkPolyData* mesh : MeshesOf(actor))
    {
      parts.push_back({ mesh, leaf.ToWorld, casts, seen && lit && opaque, seen && !lit && opaque,
        LookOf(actor) });
    }
  }

  // Facts about all actors of a prop together.
  struct Added
  {
    std::vector<ScenePart> Parts;
    bool Plain = true; ///< all of them are meshes
    bool Translucent = false; ///< some of them are
    std::uint64_t Drawn = 0;  ///< a signature of those that mappers draw, of which there may be others the next time
  };

  Added AddLeaves(vtkProp* owner, const SceneLeaves& leaves, bool casts, bool receives)
  {
    Added added;
    for (const SceneLeaf& leaf : leaves.Actors)
    {
      SceneShading shading;
      // A follower that is a part turns from where its owner places it.
      const bool turns = leaf.Placed && leaf.Actor->IsA("vtkFollower");
      const bool plain = this->OwnDrawing && !turns && IsPlainMeshActor(leaf.Actor);
      // What is wider than its mesh is seen as its mapper draws it, and casts by parts.
      const bool thick = plain && IsThickActor(leaf.Actor);
      shading.DrawsItself = !plain || thick;
      shading.IsUnsampled = leaf.Actor->HasTranslucentPolygonalGeometry() != 0;
      this->Shade(owner, leaf, shading, leaves.HasOthers);
      this->Leaves.push_back({ KeysOf(owner), ChosenMapper(leaf.Actor), leaf.Actor });
      added.Translucent = added.Translucent || shading.IsUnsampled;
      if (plain)
      {
        this->AddMeshes(leaf, casts, receives, !thick, added.Parts);
      }
      if (!shading.DrawsItself)
      {
        continue;
      }
      added.Plain = false;
      added.Drawn = Mix(Mix(added.Drawn, reinterpret_cast<std::uint64_t>(leaf.Actor)), leaf.ToWorld);
      // A prop's own signature doesn't tell of the level of detail that it draws.
      added.Drawn = leaf.Level ? SignActor(added.Drawn, leaf.Actor) : added.Drawn;
      this->Result.SamplesAreComplete = false;
      vtkSmartPointer<vtkMatrix4x4> place;
      if (leaf.Placed)
      {
        place = vtkSmartPointer<vtkMatrix4x4>::New();
        FromGlm(leaf.ToWorld, place);
      }
      this->Result.Props.push_back(
        { leaf.Actor, owner, place, casts && !thick, receives, shading.IsUnsampled });
    }
    return added;
  }

  void MixIn(vtkProp* prop, const Added& added, bool casts, bool receives)
  {
    std::uint64_t& signature = this->Result.Signature;
    signature = Mix(signature, reinterpret_cast<std::uint64_t>(prop));
    signature = Mix(signature, std::uint64_t(casts) | std::uint64_t(receives) << 1);
    if (!added.Plain)
    {
      signature = Mix(SignProp(signature, prop), added.Drawn);
    }
    for (const ScenePart& part : added.Parts)
    {
      signature = SignPart(signature, part);
    }
  }

  void Add(vtkProp* prop)
  {
    if (!prop->GetVisibility())
    {
      return;
    }
    const bool casts = Flag(prop, this->Keys.Casts), receives = Flag(prop, this->Keys.Receives);
    const SceneLeaves leaves = LeavesOf(prop);
    for (const std::string& what : leaves.Refusals)
    {
      if (casts || receives)
      {
        this->Result.Refusals.push_back({ prop, what });
      }
    }
    if (leaves.Actors.empty())
    {
      return;
    }
    const Added added = this->AddLeaves(prop, leaves, casts, receives);
    // Bounds need an updated pipeline, which collecting the meshes saw to.
    this->AddBounds(prop, added.Plain, receives && added.Translucent);
    this->MixIn(prop, added, casts, receives);
    this->Result.Shaded.push_back(prop);
    this->Result.Parts.insert(
      this->Result.Parts.end(), added.Parts.begin(), added.Parts.end());
  }

  // Sorts shadings by keys, once all are known, since actors share mappers.
  void SortKeys()
  {
    FrameScene& scene = this->Result;
    if (scene.Shadings.empty())
    {
      return;
    }
    for (const KnownLeaf& leaf : this->Leaves)
    {
      const SceneShading* const ofKeys = scene.Find(leaf.Keys);
      if (ofKeys || scene.Find(leaf.Mapper))
      {
        KeyShadings& there = scene.Keys[leaf.Keys];
        there.IsMixed = ofKeys && ofKeys->IsMixed;
        if (const auto shading = scene.FindShading(leaf.Mapper, leaf.Actor, leaf.Keys))
        {
          there.Has[shading->DrawsItself][shading->IsUnsampled] = true;
        }
      }
    }
  }
};
}

const SceneShading* FrameScene::Find(const vtkObjectBase* object) const
{
  const auto found = this->Shadings.find(object);
  return found == this->Shadings.end() ? nullptr : &found->second;
}

std::optional<SceneShading> FrameScene::FindShading(
  const vtkObjectBase* mapper, const vtkObjectBase* actor, const vtkObjectBase* keys) const
{
  const SceneShading* const shared = this->Find(keys);
  const SceneShading* const ofMapper = this->Find(mapper);
  const SceneShading* own = this->Find(actor);
  if (!own && !ofMapper && shared && shared->IsMixed)
  {
    return std::nullopt;
  }
  own = own ? own : shared;
  SceneShading shading = own ? *own : SceneShading();
  // A mapper keeps one program, whichever of its actors it draws.
  if (ofMapper)
  {
    shading.DrawsItself = shading.DrawsItself || ofMapper->DrawsItself;
    shading.IsUnsampled = shading.IsUnsampled || ofMapper->IsUnsampled;
  }
  return shading;
}

std::optional<SceneShading> FrameScene::FindShading(
  const vtkObjectBase* mapper, vtkProp* prop) const
{
  return this->FindShading(mapper, prop, prop->GetPropertyKeys());
}

FrameScene CollectScene(vtkRenderer* renderer, const SceneKeys& keys, bool ownDrawing)
{
  Collector collector{ {}, keys, ownDrawing, {} };
  collector.Result.SamplesAreComplete = KeepsAllInView(renderer);
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    collector.Add(prop);
  }
  collector.SortKeys();
  return std::move(collector.Result);
}
}
