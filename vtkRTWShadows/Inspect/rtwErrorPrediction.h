// SPDX-License-Identifier: BSD-3-Clause
// The error of a frame's shadows, predicted from the widths of texels and pixels at their edges.
#ifndef rtwErrorPrediction_h
#define rtwErrorPrediction_h

#include "GL/rtwFramebuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "GL/rtwTexture.h"
#include "Inspect/rtwDebugStage.h"
#include "Lookup/rtwMaskStage.h"

#include <string>

namespace rtw
{
/// A frame that has been drawn: its shadows, and what they were looked up by and from.
struct DrawnShadows
{
  MapOfLight Map;
  const Texture& Mask; ///< the shadow mask of the frame's samples, a layer for each light
  const ReceiverLights& Lights;
  const DenseLayers& Layers;
};

class ErrorPrediction
{
public:
  /// The share of the pixels that face a light whose shadow is wrong; 0 where none does. Waits for
  /// the GPU. Negative where the driver can't.
  double Predict(const DrawnShadows& shadows, const ReceiverShape& shape);
  void Dispose(Disposal dispose);

private:
  bool Build(const WarpShape& warp);
  bool DrawOwnMask(const DrawnShadows& shadows, const ReceiverShape& shape);
  bool Draw(const DrawnShadows& shadows);
  double Sum() const;

  std::string Warp; ///< name of the warp that the program is compiled for
  Program Adding;
  MaskStage Own;
  Texture Sums; ///< a texel for each square of pixels
  Framebuffer Target;
  ScreenTriangle Triangle;
};
}

#endif
