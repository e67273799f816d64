// SPDX-License-Identifier: BSD-3-Clause
// How each light's plane is turned from frame to frame.
#ifndef rtwLightTurning_h
#define rtwLightTurning_h

#include "Frame/rtwView.h"
#include "GL/rtwReadback.h"
#include "GL/rtwResources.h"
#include "Light/rtwTurnStage.h"

#include <cstdint>
#include <map>
#include <vector>

namespace rtw
{
enum class Turning
{
  Off,
  ViewAligned,
  Automatic,
  MinimalFrustum,
  AlongView, ///< ViewAligned, for a warp that has come to nothing where there is no such turn
  LeastArea  ///< MinimalFrustum, by the area that the view samples take
};

class LightTurning
{
public:
  /// Begins a frame: what has been found out by now counts from it on. `viewer` tells apart viewers
  /// who draw alternately; `minimal` are the turns of the minimal frusta, where they are asked for.
  void Begin(Turning kind, const void* viewer, const std::vector<ShadowLight>& lights,
    const View& view, const std::vector<double>& minimal);
  /// Whether turns are chosen by view samples, and whether by the areas that these take.
  bool IsBySamples() const;
  bool IsByArea() const { return this->Kind == Turning::LeastArea; }
  /// The turn of each light's plane, in radians.
  const std::vector<double>& GetTurns() const { return this->Turns; }
  /// Whether nothing has been found out about these lights yet.
  bool IsUndecided() const;
  /// Whether to ask about a frame with that signature: not while an answer is due, nor what has
  /// been asked before, so that all comes to rest. False where the driver can't.
  bool IsToAsk(std::uint64_t signature);
  /// The turns of a light's plane that are to be compared, in radians.
  const std::vector<double>& GetCandidates(std::size_t light) const
  {
    return this->Candidates[light];
  }
  /// Starts to compare the candidates. `By` of each light are its candidates, less its turn.
  void Ask(const std::vector<TurnedLight>& lights, const TurnInput& input, std::uint64_t signature);
  /// Waits until the comparison is done, whose result then counts. Returns whether there is a
  /// better turn.
  bool Wait();
  void Dispose(Disposal dispose);

private:
  /// What is known of a viewer.
  struct Choice
  {
    std::vector<double> Turns;
    bool Decided = false;
    std::uint64_t Asked = 0; ///< signature of the frame
    std::vector<std::vector<double>> Compared;
    Readback Answer; ///< the errors, or areas, of the candidates in Compared
  };
  void Take(Choice& choice) const;
  void Forget(Disposal dispose);

  TurnStage Stage;
  std::map<const void*, Choice> Choices;
  Turning Kind = Turning::Off;
  const void* Viewer = nullptr; ///< the viewer of this frame
  std::vector<double> Turns;
  std::vector<std::vector<double>> Candidates;
};
}

#endif
