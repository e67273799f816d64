// SPDX-License-Identifier: BSD-3-Clause
// What every technique has to stand.
#ifndef rtwEachTechnique_h
#define rtwEachTechnique_h

#include "rtwShadowStage.h"

#include <functional>
#include <string>

struct rtwTechniqueCase
{
  std::string Name;
  std::function<vtkSmartPointer<vtkAdaptiveShadowMapPass>()> MakePass;
  rtwShadowBounds Bounds;
  bool Sharp = false; ///< beside rays that start at the surface
  int Layers = 1;     ///< of a light
};

/// Checks a technique beside exact rays, in both chains: the first frame under a sun and under a
/// spot, several lights, what only VTK's mappers draw, what reaches from behind a lamp into its
/// light, and a scene that was empty.
void rtwCheckTechnique(const rtwTechniqueCase& technique);

/// Fills an empty stage with objects under two suns and a spot, draws it, and checks all three
/// masks.
void rtwCheckLights(rtwShadowStage& stage, const rtwShadowBounds& bounds = {});

/// Fills an empty stage with what VTK's own mappers draw among meshes, under a sun and a spot,
/// draws it, and checks both masks.
void rtwCheckGlyphs(rtwShadowStage& stage);

/// For messages.
const char* rtwNameOf(rtwChain chain);

#endif
