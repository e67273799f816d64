// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwSceneLeaves.h"

#include "Frame/rtwSceneActor.h"
#include "Frame/rtwView.h"
#include "GL/rtwVTKCompatibility.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>

namespace rtw
{
namespace
{
bool IsOneOf(vtkObject* object, std::initializer_list<const char*> classes)
{
  return std::any_of(
    classes.begin(), classes.end(), [object](const char* name) { return object->IsA(name); });
}

// Whether every draw of a mapper asks the passes in its prop's keys for shader code, and goes where
// it is told to. Others would draw colours into maps; those of surface LIC compose images.
bool AsksPasses(vtkMapper* mapper)
{
  return IsMeshMapper(mapper) ||
    (IsOneOf(mapper,
       { "vtkPolyDataMapper", "vtkCompositePolyDataMapper", "vtkDataSetMapper",
         "vtkGlyph3DMapper", "vtkHyperTreeGridMapper", "vtkMoleculeMapper" }) &&
      !IsOneOf(mapper, { "vtkCompositeSurfaceLICMapper", "vtkSurfaceLICMapper" }));
}

// The sky is no part of the world that light falls on; labels of axes turn in each Render, to
// whatever camera there is.
bool IsAnnotation(vtkProp* prop)
{
  return IsOneOf(prop, { "vtkSkybox", "vtkAxisFollower", "vtkProp3DAxisFollower" });
}

// The actor of the level that VTK chose when it allocated the time for this frame.
vtkActor* ChosenLevel(vtkLODProp3D* levels)
{
  const int chosen = levels->GetLastRenderedLODID();
  if (chosen < 0)
  {
    return nullptr; // VTK hasn't chosen yet, and complains where it is asked for that level
  }
  vtkNew<vtkPropCollection> actors;
  levels->GetActors(actors);
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkProp* prop = actors->GetNextProp(it))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkProperty* property = nullptr;
    vtkMapper* mapper = nullptr;
    levels->GetLODProperty(chosen, &property);
    levels->GetLODMapper(chosen, &mapper);
    if (actor && actor->GetMapper() == mapper && actor->GetProperty() == property)
    {
      return actor;
    }
  }
  return nullptr;
}

const char* KindOf(vtkProp* prop)
{
  if (prop->IsA("vtkVolume"))
  {
    return "volumes are drawn by rays, which know no shadow";
  }
  return prop->IsA("vtkImageSlice") ? "images are drawn as they are, without light" : nullptr;
}

struct Walker
{
  vtkProp* Root;
  SceneLeaves Result;

  void Refuse(vtkProp* part, const std::string& what)
  {
    const std::string whose =
      part == this->Root ? "" : std::string("has a part, a ") + part->GetClassName() + ", that ";
    this->Result.Refusals.push_back(whose + what);
  }

  void AddActor(vtkActor* actor, const glm::dmat4& toWorld, bool isLevel)
  {
    vtkMapper* const mapper = actor->GetMapper();
    if (!mapper || IsAnnotation(actor))
    {
      this->Result.HasOthers = true;
    }
    else if (!AsksPasses(mapper))
    {
      this->Result.HasOthers = true;
      this->Refuse(actor, std::string("neither casts nor receives shadows, because its mapper, a ") +
          mapper->GetClassName() + ", takes no shader code for them");
    }
    else
    {
      if (!IsMeshMapper(mapper) && mapper->IsA("vtkPointGaussianMapper"))
      {
        this->Refuse(actor,
          "casts shadows but receives none, because its mapper, a vtkPointGaussianMapper, lights "
          "nothing");
      }
      const glm::dmat4 own = ToGlm(actor->GetMatrix());
      this->Result.Actors.push_back(
        { actor, toWorld, own != toWorld, isLevel || ChoosesMapper(actor) });
    }
  }

  void AddLeaf(vtkProp* prop, const glm::dmat4& toWorld)
  {
    auto* levels = vtkLODProp3D::SafeDownCast(prop);
    vtkActor* const level = levels ? ChosenLevel(levels) : nullptr;
    if (vtkActor* actor = level ? level : vtkActor::SafeDownCast(prop))
    {
      this->AddActor(actor, toWorld, level != nullptr);
      return;
    }
    this->Result.HasOthers = true;
    if (const char* why = KindOf(prop))
    {
      this->Refuse(prop, std::string("neither casts nor receives shadows, because ") + why);
    }
  }
};

// Whether the paths through a prop lead to what it draws; those of others end at themselves.
bool LeadsToParts(vtkProp* prop)
{
  return IsOneOf(prop, { "vtkActor", "vtkAssembly", "vtkLODProp3D", "vtkProp3DFollower",
                         "vtkPropAssembly" }) &&
    !IsAnnotation(prop);
}
}

SceneLeaves LeavesOf(vtkProp* prop)
{
  Walker walker{ prop, {} };
  if (!std::strcmp(prop->GetClassName(), "vtkOpenGLActor")) // as most are
  {
    walker.AddActor(static_cast<vtkActor*>(prop), ToGlm(prop->GetMatrix()), false);
    return std::move(walker.Result);
  }
  if (!LeadsToParts(prop))
  {
    walker.AddLeaf(prop, glm::dmat4(1));
    return std::move(walker.Result);
  }
  if (prop->IsA("vtkProp3DFollower"))
  {
    prop->GetBounds(); // which turns what follows it
  }
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    vtkProp* leaf = node->GetViewProp();
    // A vtkPropAssembly in another one places nothing.
    vtkMatrix4x4* place = node->GetMatrix() ? node->GetMatrix() : leaf->GetMatrix();
    if (leaf->GetVisibility())
    {
      walker.AddLeaf(leaf, place ? ToGlm(place) : glm::dmat4(1));
    }
  }
  return std::move(walker.Result);
}
}
