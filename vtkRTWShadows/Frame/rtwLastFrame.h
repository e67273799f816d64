// SPDX-License-Identifier: BSD-3-Clause
// The depth of a frame that has been drawn, for the analysis of the next.
#ifndef rtwLastFrame_h
#define rtwLastFrame_h

#include "Frame/rtwView.h"
#include "GL/rtwResources.h"
#include "GL/rtwTexture.h"

#include <cstdint>

namespace rtw
{
class LastFrame
{
public:
  /// Takes the depth of the view's pixels from the framebuffer that is drawn into; none where that
  /// has several samples a pixel. The signature is that of all that it shows.
  void Capture(const View& view, std::uint64_t signature);
  void Forget() { this->Signature = 0; }

  /// Whether it shows about what that view does, as rtw::Resembles().
  bool Resembles(const View& view, double sceneSize) const;
  /// 0 if there is none.
  std::uint64_t GetSignature() const { return this->Signature; }
  const View& GetView() const { return this->Viewed; }
  const Texture& GetDepth() const { return this->Depth; }
  void Dispose(Disposal dispose);

private:
  View Viewed;
  Texture Depth;
  std::uint64_t Signature = 0;
};
}

#endif
