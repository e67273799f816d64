// SPDX-License-Identifier: BSD-3-Clause
// Fits each layer to what the camera sees in the light: the desired view, by reduction on the GPU.
#ifndef rtwFocus_h
#define rtwFocus_h

#include "rtwBuffer.h"
#include "rtwLightFrame.h"
#include "rtwProgram.h"

#include <vector>

namespace rtw
{
class ViewSampler;
class WarpTable;

class FocusStage
{
public:
  bool Build();
  const std::string& GetLog() const;
  /// One frame a layer. `also` are rectangles that each layer must hold too: receivers that aren't sampled. `margin`, a share of its
  /// extent, is added to each side.
  void Reduce(const std::vector<LightFrame>& frames, const std::vector<Rectangle>& also,
    const ViewSampler& samples, int stride, float margin, const WarpTable& table);
  void Release();
  void Abandon();

private:
  Program Reduction, Writing;
  Buffer Bounds;
};
}

#endif
