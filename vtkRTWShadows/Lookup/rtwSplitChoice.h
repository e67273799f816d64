// SPDX-License-Identifier: BSD-3-Clause
// The ratio of texels along s to texels along t that the least error is predicted for, from the
// shadow edges of frames before.
#ifndef rtwSplitChoice_h
#define rtwSplitChoice_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwReadback.h"
#include "GL/rtwResources.h"
#include "Light/rtwTurnStage.h"
#include "Warp/rtwWarpStage.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace rtw
{
struct MapOfLight;

class SplitChoice
{
public:
  /// Begins a frame: what has been found out by now counts from it on. `viewer` tells apart viewers
  /// who draw alternately; they share a ratio. All is forgotten where the choice isn't `used`, or
  /// the number `settings` has changed.
  void Begin(bool used, const void* viewer, std::uint64_t settings);
  /// How many times as many texels along s as along t.
  double GetRatio() const;
  /// Whether nothing has been found out for this viewer yet.
  bool IsUndecided() const;
  /// Whether to ask about a frame with that signature: not while an answer is due, nor what has
  /// been asked before, so that all comes to rest. False where the driver can't.
  bool IsToAsk(std::uint64_t signature, const WarpShape& warp);
  /// Starts to compare splits for a frame: by its lights, its mask, and the texels that a side of a
  /// square map has.
  void Ask(const std::vector<MapOfLight>& lights, const TurnInput& input, std::uint64_t signature);
  /// Waits until the comparison is done, whose result then counts. Returns whether there is a
  /// better ratio.
  bool Wait();
  void Dispose(Disposal dispose);

private:
  /// What is known of a viewer.
  struct View
  {
    bool Decided = false;
    std::uint64_t Asked = 0; ///< signature of the frame
    std::int64_t Time = 0;   ///< number of the viewer's last frame
    std::vector<float> Errors;
    Readback Answer;
  };
  void Take(View& view);
  void Choose();
  void Forget(Disposal dispose);

  TurnStage Edges;
  const char* Warp = nullptr; ///< name of the warp that Comparing is compiled for
  Program Comparing;
  Buffer Errors;
  std::map<const void*, View> Views;
  const void* Viewer = nullptr; ///< the viewer of this frame
  std::uint64_t Settings = 0;
  std::int64_t Time = 0;
  bool Used = false;
  std::optional<int> Split; ///< none before the first answer
};
}

#endif
