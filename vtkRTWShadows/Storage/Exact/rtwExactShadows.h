// SPDX-License-Identifier: BSD-3-Clause
// Exact hard shadows: the mask from view samples on warped grids, each tested against each triangle
// that could shadow it.
#ifndef rtwExactShadows_h
#define rtwExactShadows_h

#include "GL/rtwConditional.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwProgram.h"
#include "Storage/Exact/rtwExactCasting.h"
#include "Storage/Exact/rtwSampleGrid.h"
#include "Storage/rtwMaskSource.h"

#include <vector>

namespace rtw
{
class ExactShadows : public MaskSource
{
public:
  bool Build(const MaskJob& job) override;
  std::string GetLog() const override;
  bool Render(const MaskJob& job, MaskStage& masking, StageTimers& timers) override;
  bool PaintLists(const MaskJob& job, int light, double rounding) override;
  void WhereIncomplete(const std::function<void()>& draw) override;
  bool WasIncomplete() override;
  std::uint64_t GetSignature() const override;
  CasterCounts ReadCounts(int light) const override { return this->Casting.ReadCounts(light); }
  std::size_t GetMemory() const override;
  void Dispose(Disposal dispose) override;

  void SetSamplesAPixel(int samples) { this->SamplesAPixel = samples; }
  /// The most memory that the queue may take, in bytes.
  void SetMemoryBound(std::size_t bytes);
  std::size_t GetMemoryBound() const;
  /// Whether the lengths of the lists of each light's grid are kept: they are read in the frame,
  /// since lights use the same memory one after another.
  void KeepLengths(bool keep) { this->KeepsLengths = keep; }
  const std::vector<ListLengths>& GetLengths() const { return this->Lengths; }

private:
  bool BuildDrawing(const MaskJob& job, const ReceiverShape& one);
  bool Draw(const MaskJob& job, MaskStage& masking, int light);
  void Resolve(const Program& program, const MaskJob& job, int light);

  int SamplesAPixel = 1;
  bool KeepsLengths = false;
  std::vector<ListLengths> Lengths;
  ReceiverShape Shape;
  bool HasOthers = false; ///< whether there are casters that only VTK's mappers draw
  SampleGrid Grid;
  ExactCasting Casting;
  Program Resolving, Separating, Failing, Painting;
  Conditional Incomplete;
  ScreenTriangle Triangle;
};
}

#endif
