// SPDX-License-Identifier: BSD-3-Clause
// The split of texels between s and t that the least error is predicted for, from the shadow edges
// of frames before.
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
  /// Before a frame: what has been found out by now counts from this one on. `viewer` tells apart
  /// those who take turns; they share a split. Where it isn't `used`, or `settings`, a number, has
  /// changed, all is forgotten.
  void Begin(bool used, const void* viewer, std::uint64_t settings);
  /// How many times as many texels along s as along t.
  double GetRatio() const;
  /// Whether nothing has been found out for this viewer yet.
  bool IsUndecided() const;
  /// Whether to ask about a frame with that signature: not while an answer is due, nor what has
  /// been asked before, so that all comes to rest. False where the driver can't.
  bool IsToAsk(std::uint64_t signature, const WarpShape& warp);
  /// Starts to compare splits by a frame's lights, their maps of so many texels a side where they
  /// are square, and its mask.
  void Ask(const std::vector<MapOfLight>& lights, const TurnInput& input, std::uint64_t signature);
  /// Until that is done; then it counts. Whether there is a better split.
  bool Wait();
  void Dispose(Disposal dispose);

private:
  /// Of a viewer.
  struct View
  {
    bool Decided = false;
    std::uint64_t Asked = 0; ///< signature of the frame
    std::int64_t Time = 0;   ///< of its last frame
    std::vector<float> Errors;
    Readback Answer;
  };
  void Take(View& view);
  void Choose();
  void Forget(Disposal dispose);

  TurnStage Edges;
  const char* Warp = nullptr; ///< that is compiled
  Program Comparing;
  Buffer Errors;
  std::map<const void*, View> Views;
  const void* Viewer = nullptr; ///< of this frame
  std::uint64_t Settings = 0;
  std::int64_t Time = 0;
  bool Used = false;
  std::optional<int> Split; ///< none before the first answer
};
}

#endif
