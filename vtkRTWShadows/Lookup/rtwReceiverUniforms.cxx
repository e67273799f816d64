// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the code that is put into mappers' shaders.
#include "Lookup/rtwReceiverShader.h"

#include "Light/rtwLightUniforms.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace rtw
{
namespace
{
// The lattice of taps stays where it is in the world while the eye, where light-plane coordinates
// begin, moves: but for whole periods, which nobody sees, and which a float doesn't hold.
void PutTaps(
  std::vector<float>& taps, const LightFrame& frame, const LookupOptions& options, double size)
{
  const bool isSpot = frame.Light.Kind == LightKind::Spot;
  const double width = std::min(options.FilterWorld, size); // more makes no difference
  const double spacing = width / (isSpot ? 3 * frame.FarthestDistance : 3.0); // RTW_TAPS_A_RADIUS
  const double period = 5 * 64 * spacing; // RTW_LATTICE_PERIOD, and lattices up to 64 times wider
  for (int axis = 0; axis < 2; ++axis)
  {
    const double place = isSpot ? frame.ConeCentre[axis] : frame.WorldToLight[3][axis];
    taps.push_back(period > 0 && !isSpot ? float(std::fmod(place, period)) : float(place));
  }
  taps.insert(taps.end(), { float(spacing), float(width + options.FilterTexels) });
}
}

ReceiverLights ReceiverLights::Make(const std::vector<LightFrame>& frames, const View& view,
  const LookupOptions& options, double size)
{
  ReceiverLights lights;
  lights.FilterJitter = options.FilterJitter ? 1 : 0;
  lights.Count = static_cast<int>(frames.size());
  lights.Sides = SidesOf(view);
  for (const LightFrame& frame : frames)
  {
    const glm::mat4 toLight(frame.WorldToLight * view.ViewToWorld);
    for (int column = 0; column < 4; ++column)
    {
      for (int row = 0; row < 4; ++row)
      {
        lights.ToLight.push_back(toLight[column][row]);
      }
    }
    lights.Cone.insert(lights.Cone.end(),
      { float(frame.ConeCentre.x), float(frame.ConeCentre.y), float(frame.ConeTangent), 0.f });
    const double depthOfLength = frame.DepthOfLength();
    lights.Tolerance.insert(lights.Tolerance.end(),
      { 4e-7f, float(2e-6 * size * depthOfLength), float(options.Bias * size * depthOfLength),
        frame.Light.Kind == LightKind::Spot ? float(2.5e-7 * size) : 0.f });
    PutTaps(lights.Taps, frame, options, size);
    lights.Attenuation.push_back(float(frame.Light.Attenuation));
    const glm::vec4 beam = BeamOf(frame, view);
    lights.Beams.insert(lights.Beams.end(), { beam.x, beam.y, beam.z, beam.w });
  }
  return lights;
}

void ReceiverUniforms::PlaceView(const glm::ivec4& viewport, const View& view)
{
  this->OriginX = viewport.x + (viewport.z - view.Width) / 2;
  this->OriginY = viewport.y + (viewport.w - view.Height) / 2;
  this->ToClip.z = -this->ToClip.x * float(this->OriginX) - 1;
  this->ToClip.w = -this->ToClip.y * float(this->OriginY) - 1;
}

void ReceiverUniforms::Set(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("rtwPhase"))
  {
    const float depthToSample[] = { this->OwnDepthToSample.x, this->OwnDepthToSample.y };
    program->SetUniformi("rtwPhase", static_cast<int>(this->CurrentPhase));
    program->SetUniformi("rtwLayer", this->Layer);
    program->SetUniformi("rtwLightParallel", this->LightParallel ? 1 : 0);
    program->SetUniform2f("rtwOwnDepthToSample", depthToSample);
    const float rayStep[] = { this->RayStep.x, this->RayStep.y, this->RayStep.z };
    program->SetUniform3f("rtwRayStep", rayStep);
    program->SetUniform3f("rtwSeenFrom", &this->SeenFrom.x);
  }
  if (program->IsUniformUsed("rtwFramed"))
  {
    program->SetUniformi("rtwFramed", this->Framed ? 1 : 0);
  }
  if (program->IsUniformUsed("rtwOfSample"))
  {
    program->SetUniformi("rtwPlacedBy", this->PlacedBy);
    program->SetUniformf("rtwViewBegin", this->ViewBegin);
    program->SetUniform4f("rtwRay", &this->Ray.x);
    program->SetUniform4f("rtwOfSample", &this->OfSample.x);
    program->SetUniform2f("rtwDepthToSample", &this->DepthToSample.x);
    program->SetUniform4f("rtwToClip", &this->ToClip.x);
  }
  if (program->IsUniformUsed("rtwMask"))
  {
    const int origin[] = { this->OriginX, this->OriginY };
    program->SetUniformi("rtwMask", this->MaskUnit);
    program->SetUniform2i("rtwMaskOrigin", origin);
  }
  if (program->IsUniformUsed("rtwSampleBits"))
  {
    const int n = static_cast<int>(this->Points.size());
    program->SetUniformi("rtwSampleBits", this->BitsUnit);
    program->SetUniformi("rtwManySamples", this->ManyUnit);
    program->SetUniformi("rtwSamplesAPixel", n);
    program->SetUniform2fv(
      "rtwOffsets", n, reinterpret_cast<const float(*)[2]>(this->Points.data()));
    program->SetUniformf("rtwHiddenBeyond", this->HiddenBeyond);
  }
  if (program->IsUniformUsed("rtwWarpTable"))
  {
    const int size[] = { this->Cells, this->Resolution };
    program->SetUniformi("rtwWarpTable", this->WarpUnit);
    program->SetUniform2i("rtwWarpSize", size);
    program->SetUniform2i("rtwMapSize", &this->MapSize.x);
    program->SetUniformi("rtwWarpedLayers", this->WarpedLayers);
  }
  if (program->IsUniformUsed("rtwWarpGrid"))
  {
    program->SetUniformi("rtwWarpGrid", this->GridUnit);
  }
  const int n = this->Lights.Count;
  if (n > 0 && program->IsUniformUsed("rtwAttenuation"))
  {
    program->SetUniform1fv("rtwAttenuation", n, this->Lights.Attenuation.data());
  }
  if (n > 0 && program->IsUniformUsed("rtwToLight"))
  {
    program->SetUniformi("rtwDepths", this->DepthUnit);
    program->SetUniformi("rtwGradients", this->GradientUnit);
    program->SetUniformi("rtwFirstLayer", 0);
    program->SetUniformi("rtwOtherLayers", this->OtherLayers);
    program->SetUniformMatrix4x4v(
      "rtwToLight", n, const_cast<float*>(this->Lights.ToLight.data()));
    program->SetUniform4fv(
      "rtwCone", n, reinterpret_cast<const float(*)[4]>(this->Lights.Cone.data()));
    program->SetUniform4fv("rtwTolerance", n,
      reinterpret_cast<const float(*)[4]>(this->Lights.Tolerance.data()));
    if (program->IsUniformUsed("rtwBeams"))
    {
      program->SetUniform4fv(
        "rtwBeams", n, reinterpret_cast<const float(*)[4]>(this->Lights.Beams.data()));
      program->SetUniform4fv(
        "rtwSides", 4, reinterpret_cast<const float(*)[4]>(this->Lights.Sides.data()));
    }
    if (program->IsUniformUsed("rtwTaps"))
    {
      program->SetUniformi("rtwFilterJitter", this->Lights.FilterJitter);
      program->SetUniform4fv(
        "rtwTaps", n, reinterpret_cast<const float(*)[4]>(this->Lights.Taps.data()));
    }
  }
}
}
