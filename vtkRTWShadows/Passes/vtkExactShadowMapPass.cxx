// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExactShadowMapPass.h"

#include "Storage/Exact/rtwExactShadows.h"

#include "vtkObjectFactory.h"
#include "vtkRectilinearShadowMapWarp.h"

#include <algorithm>

vtkStandardNewMacro(vtkExactShadowMapPass);

namespace
{
constexpr std::size_t Kilobyte = 1024;
}

class vtkExactShadowMapPass::Exact : public rtw::ExactShadows
{
public:
  rtw::ListLengths LengthsOf(int light) const
  {
    const std::vector<rtw::ListLengths>& all = this->GetLengths();
    return light >= 0 && light < static_cast<int>(all.size()) ? all[light] : rtw::ListLengths();
  }
};

vtkExactShadowMapPass::vtkExactShadowMapPass()
{
  auto shadows = std::make_unique<Exact>();
  this->Source = shadows.get();
  this->Source->SetMemoryBound(this->MemoryBound * Kilobyte);
  this->SetMaskSource(std::move(shadows));
  this->SetWarp(this->Rectilinear);
}

vtkExactShadowMapPass::~vtkExactShadowMapPass() = default;

vtkRectilinearShadowMapWarp* vtkExactShadowMapPass::GetRectilinearWarp()
{
  return this->Rectilinear;
}

void vtkExactShadowMapPass::SetSamplesPerPixel(int samples)
{
  if (samples != 1 && samples != 4 && samples != 8)
  {
    vtkErrorMacro("SetSamplesPerPixel(" << samples << "): expected 1, 4 or 8; keeping "
                                        << this->SamplesPerPixel);
    return;
  }
  if (this->SamplesPerPixel != samples)
  {
    this->SamplesPerPixel = samples;
    this->Source->SetSamplesAPixel(samples);
    this->Modified();
  }
}

void vtkExactShadowMapPass::SetMemoryBound(int kilobytes)
{
  const int bound = std::clamp(kilobytes, 16, 98304);
  if (this->MemoryBound != bound)
  {
    this->MemoryBound = bound;
    this->Source->SetMemoryBound(bound * Kilobyte);
    this->Modified();
  }
}

void vtkExactShadowMapPass::SetCountLists(bool count)
{
  if (this->CountLists != count)
  {
    this->CountLists = count;
    this->Source->KeepLengths(count);
    this->Modified();
  }
}

int vtkExactShadowMapPass::GetLongestList(int light)
{
  return static_cast<int>(this->Source->LengthsOf(light).Longest);
}

int vtkExactShadowMapPass::GetListPercentile99(int light)
{
  return static_cast<int>(this->Source->LengthsOf(light).Percentile99);
}

int vtkExactShadowMapPass::GetNumberOfListedSamples(int light)
{
  return static_cast<int>(this->Source->LengthsOf(light).Samples);
}

void vtkExactShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "MemoryBound: " << this->MemoryBound << "\n";
  os << indent << "CountLists: " << this->CountLists << "\n";
  os << indent << "RectilinearWarp: " << this->Rectilinear.Get() << "\n";
}
