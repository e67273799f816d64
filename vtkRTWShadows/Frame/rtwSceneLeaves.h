// SPDX-License-Identifier: BSD-3-Clause
// Which actors a prop consists of, as VTK will draw it in this frame, and what it has beside them.
#ifndef rtwSceneLeaves_h
#define rtwSceneLeaves_h

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkActor;
class vtkProp;

namespace rtw
{
/// An actor that draws by its mapper what light falls on.
struct SceneLeaf
{
  vtkActor* Actor;
  glm::dmat4 ToWorld;
  bool Placed; ///< the prop that it is part of places it elsewhere than it would stand by itself
  bool Level;  ///< is one of several levels of detail
};

struct SceneLeaves
{
  std::vector<SceneLeaf> Actors;
  /// What somebody might expect of the prop and won't get, and why: "neither casts nor receives shadows, because ...".
  std::vector<std::string> Refusals;
  /// Whether VTK draws something of the prop by other means; that gets no shader code of ours, and so stays as it is.
  bool HasOthers = false;
};

/// The parts of assemblies, the level of detail that VTK has chosen, and what followers turn: those
/// that are actors with a mapper whose every draw asks render passes for shader code. Annotations,
/// labels, text, the sky, widgets, images and volumes have none.
SceneLeaves LeavesOf(vtkProp* prop);
}

#endif
