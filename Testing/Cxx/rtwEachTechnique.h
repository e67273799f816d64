// SPDX-License-Identifier: BSD-3-Clause
// What the tests of every technique begin with.
#ifndef rtwEachTechnique_h
#define rtwEachTechnique_h

#include "rtwShadowStage.h"

/// Fills an empty stage with objects under two suns and a spot, draws it, and checks all three
/// masks.
void rtwCheckLights(rtwShadowStage& stage, const rtwShadowBounds& bounds = {});

/// Fills an empty stage with what VTK's own mappers draw among meshes, under a sun and a spot,
/// draws it, and checks both masks.
void rtwCheckGlyphs(rtwShadowStage& stage);

/// For messages.
const char* rtwNameOf(rtwChain chain);

#endif
