// SPDX-License-Identifier: BSD-3-Clause
// What tests of debug views look at.
#ifndef rtwDebugViews_h
#define rtwDebugViews_h

#include "rtwShadowStage.h"

/// A floor with a ball, a box, cones that only VTK's mapper draws, and a translucent ball, under a
/// sun and a spot.
void rtwFillForDebugViews(rtwShadowStage& stage);

/// Checks all debug views of a light, in viewports of one window, against the baseline: in the
/// upper row none, shadow, aliasing error; below importance, warp grid, layers.
void rtwCheckDebugViews(int light, rtwChain chain, int argc, char* argv[]);

#endif
