// SPDX-License-Identifier: BSD-3-Clause
// One of the shared scenes in a window, with the exact shadow of each pixel, and how far a pass is
// from it.
#ifndef rtwSceneStage_h
#define rtwSceneStage_h

#include "rtwAliasing.h"
#include "rtwCompare.h"
#include "rtwReference.h"
#include "rtwScene.h"

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkRenderWindow.h"

#include <memory>
#include <string>
#include <vector>

class vtkAdaptiveShadowMapPass;
class vtkLight;

class rtwSceneStage
{
public:
  /// 1024 × 1024 pixels. `sharp` as in rtw::ReferenceOptions.
  explicit rtwSceneStage(const std::string& scene, bool sharp = false);
  explicit rtwSceneStage(const rtw::Scene& scene, bool sharp = false);

  /// Of the last of so many frames, each made anew; what the pass itself says of it, and where
  /// points of the world lie on its map; and its mask.
  rtw::ShadowErrors Measure(vtkAdaptiveShadowMapPass* pass, int frames = 1,
    double* predicted = nullptr, rtw::TexelFunction* texels = nullptr,
    std::vector<unsigned char>* mask = nullptr);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  rtw::Truth Truth;
  std::unique_ptr<rtw::ShadowReference> Reference; ///< that it is by
  vtkLight* Light;                                 ///< of which it tells
  std::string Name;
};

#endif
