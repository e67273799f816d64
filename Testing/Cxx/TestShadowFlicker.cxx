// SPDX-License-Identifier: BSD-3-Clause
// How much shadows flicker while the camera moves on by a little each frame, and how far they are
// from exact rays meanwhile: with snapping texels stay in place, so that they flicker hardly more
// than those of a map that is fixed in the world.
//
// With the argument `all` every setting is measured, and printed, on the scenes, moves in pixels a
// frame, places on the path, frames at each, and sides of the picture that further arguments name:
// --scenes town,duel --moves 0.1,2 --places 0.125,0.625 --frames 30 --sides 512 --settings
// plain,snapped
#include "rtwScene.h"
#include "rtwTest.h"

#include "rtwCompare.h"
#include "rtwFlicker.h"
#include "rtwReference.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkRTWShadowMapPass.h"
#include "vtkShadowRenderStepsPass.h"
#include "vtkUniformShadowMapPass.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace
{
struct Setting
{
  const char* Name;
  unsigned int Resolution;
  bool IsUniform, Focuses;
  double Blending;
  bool Snaps;
};

constexpr Setting Settings[] = {
  { "uniform", 4096, true, false, 0, false },
  { "focused", 4096, true, true, 0, false },
  { "plain", 1024, false, true, 0, false },
  { "blended-0.5", 1024, false, true, 0.5, false },
  { "blended-0.9", 1024, false, true, 0.9, false },
  { "snapped", 1024, false, true, 0, true },
  { "both-0.5", 1024, false, true, 0.5, true },
  { "both-0.9", 1024, false, true, 0.9, true },
  { "plain", 2048, false, true, 0, false },
  { "blended-0.5", 2048, false, true, 0.5, false },
  { "blended-0.9", 2048, false, true, 0.9, false },
  { "snapped", 2048, false, true, 0, true },
  { "both-0.5", 2048, false, true, 0.5, true },
  { "both-0.9", 2048, false, true, 0.9, true },
};

vtkSmartPointer<vtkAdaptiveShadowMapPass> MakePass(const Setting& setting, int cells)
{
  vtkSmartPointer<vtkAdaptiveShadowMapPass> pass;
  if (setting.IsUniform)
  {
    pass = vtkSmartPointer<vtkUniformShadowMapPass>::New();
  }
  else
  {
    auto warped = vtkSmartPointer<vtkRTWShadowMapPass>::New();
    warped->SetTemporalBlending(setting.Blending);
    warped->SetSnapping(setting.Snaps);
    warped->SetImportanceResolution(cells);
    pass = warped;
  }
  pass->SetFocusOnView(setting.Focuses);
  pass->SetResolution(setting.Resolution);
  pass->CachingOff();
  return pass;
}

struct Outcome
{
  rtw::Flicker Flickering;
  rtw::ShadowErrors Errors;
  int Changes = 0; // of the warp, of so many steps
  int Steps = 0;
};

class Path
{
public:
  Path(const std::string& scene, int side, double pixels, std::vector<double> places, int frames)
    : Pixels(pixels)
    , Places(std::move(places))
    , Scene(rtw::MakeScene(scene))
  {
    this->Scene.Size[0] = this->Scene.Size[1] = side;
    this->Window->SetSize(side, side);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    rtw::AddToRenderer(this->Scene, this->Renderer);
    const rtw::ShadowReference reference(this->Renderer);
    auto* light = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
    for (std::size_t place = 0; place < this->Places.size(); ++place)
    {
      this->Truths.emplace_back();
      for (int frame = 0; frame < frames; ++frame)
      {
        this->MoveTo(place, frame);
        this->Truths.back().push_back(reference.Trace(light, side, side));
        this->Truths.back().back().Depth.clear();
      }
    }
  }

  Outcome Measure(vtkAdaptiveShadowMapPass* pass)
  {
    vtkNew<vtkShadowRenderStepsPass> steps;
    steps->SetShadowMapPass(pass);
    this->Renderer->SetPass(steps);
    Outcome outcome;
    for (std::size_t place = 0; place < this->Places.size(); ++place)
    {
      this->Go(pass, place, outcome);
    }
    steps->ReleaseGraphicsResources(this->Window);
    this->Renderer->SetPass(nullptr);
    return outcome;
  }

private:
  void MoveTo(std::size_t place, int frame)
  {
    rtw::Apply(rtw::CameraOnTinyPath(this->Scene, frame, this->Places[place], this->Pixels),
      this->Renderer->GetActiveCamera());
  }

  void Go(vtkAdaptiveShadowMapPass* pass, std::size_t place, Outcome& outcome)
  {
    outcome.Flickering.StartAnew();
    std::vector<float> last;
    for (std::size_t frame = 0; frame < this->Truths[place].size(); ++frame)
    {
      this->MoveTo(place, static_cast<int>(frame));
      this->Window->Render();
      const std::vector<unsigned char> mask = rtw::MaskOf(pass->GetShadowMask(0));
      outcome.Flickering.Add(mask, this->Truths[place][frame]);
      outcome.Errors += rtw::Compare(mask, this->Truths[place][frame]);
      vtkImageData* image = pass->GetWarpImage(0);
      const auto* values = static_cast<const float*>(image->GetScalarPointer());
      const std::vector<float> warp(values, values + image->GetNumberOfPoints());
      outcome.Changes += frame > 0 && warp != last;
      outcome.Steps += frame > 0;
      last = warp;
    }
  }

  double Pixels;
  std::vector<double> Places;
  rtw::Scene Scene;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  std::vector<std::vector<rtw::Truth>> Truths;
};

Outcome Measure(Path& path, const Setting& setting, const std::string& what, int cells = 512)
{
  const Outcome outcome = path.Measure(MakePass(setting, cells));
  std::printf(
    "%s %-12s %4u: flicker %.4f %%, at most %.4f; wrong %.4f %%; the warp changed in %d of "
    "%d steps\n",
    what.c_str(), setting.Name, setting.Resolution, outcome.Flickering.MeanPercent(),
    outcome.Flickering.GreatestPercent(), outcome.Errors.Percent(outcome.Errors.Wrong()),
    outcome.Changes, outcome.Steps);
  std::fflush(stdout);
  return outcome;
}

std::vector<std::string> Words(int argc, char* argv[], const char* flag, const char* usual)
{
  const std::string given = rtwGetArgument(argc, argv, flag);
  std::istringstream text(given.empty() ? usual : given);
  std::vector<std::string> words;
  for (std::string word; std::getline(text, word, ',');)
  {
    words.push_back(word);
  }
  return words;
}

void MeasureAll(int argc, char* argv[])
{
  const std::vector<std::string> settings = Words(argc, argv, "--settings", "");
  const int frames = std::stoi(Words(argc, argv, "--frames", "24")[0]);
  const int side = std::stoi(Words(argc, argv, "--sides", "512")[0]);
  std::vector<double> places;
  for (const std::string& place : Words(argc, argv, "--places", "0.125,0.625"))
  {
    places.push_back(std::stod(place));
  }
  for (const std::string& scene :
    Words(argc, argv, "--scenes", "town,sandbox,furball,playground,duel,robot"))
  {
    for (const std::string& move : Words(argc, argv, "--moves", "0.1,1,4"))
    {
      Path path(scene, side, std::stod(move), places, frames);
      for (const std::string& cells : Words(argc, argv, "--cells", "512"))
      {
        for (const Setting& setting : Settings)
        {
          const bool asked = settings.empty() ||
            std::find(settings.begin(), settings.end(), setting.Name) != settings.end();
          if (asked && (cells == "512" || !setting.IsUniform))
          {
            Measure(
              path, setting, scene + " " + move + " px " + cells + " cells", std::stoi(cells));
          }
        }
      }
    }
  }
}

const Setting& SettingOf(const std::string& name)
{
  return *std::find_if(std::begin(Settings), std::end(Settings),
    [&](const Setting& setting) { return setting.Name == name; });
}

// What a setting may have, in times what there is without it.
struct Bounds
{
  const char* Setting;
  double Flicker, Wrong, Changes;
};

void TestScene(const char* scene, const std::vector<Bounds>& all)
{
  Path path(scene, 256, 0.1, { 0.125, 0.625 }, 16);
  const Outcome plain = Measure(path, SettingOf("plain"), scene);
  RTW_CHECK(plain.Changes == plain.Steps);
  for (const Bounds& bounds : all)
  {
    const Outcome outcome = Measure(path, SettingOf(bounds.Setting), scene);
    const double flicker = outcome.Flickering.MeanPercent() / plain.Flickering.MeanPercent();
    const double wrong = double(outcome.Errors.Wrong()) / double(plain.Errors.Wrong());
    const double changes = double(outcome.Changes) / plain.Steps;
    std::printf("%s %s: %.2f times the flicker, %.3f times the errors\n", scene, bounds.Setting,
      flicker, wrong);
    RTW_CHECK(flicker <= bounds.Flicker);
    RTW_CHECK(wrong <= bounds.Wrong);
    RTW_CHECK(changes <= bounds.Changes);
  }
}
}

int TestShadowFlicker(int argc, char* argv[])
{
  if (std::find(argv, argv + argc, std::string("all")) != argv + argc)
  {
    MeasureAll(argc, argv);
    return rtwTestResult();
  }
  // Frames that keep texels have their errors too: the mean of all hangs on where those texels lie.
  const std::vector<Bounds> bounds = { { "snapped", 0.82, 1.1, 0.3 },
    { "blended-0.9", 0.92, 1.1, 1 }, { "both-0.9", 0.8, 1.1, 0.3 } };
  TestScene("robot", bounds);
  return rtwTestResult();
}
