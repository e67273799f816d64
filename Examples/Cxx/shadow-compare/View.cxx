// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "rtwProgress.h"
#include "rtwQuantile.h"

#include <vtkRenderer.h>

namespace
{
constexpr int WARM_UP = 3; // frames that build shaders and buffers, and fill what is a frame late

// Of each stage, over the frames.
std::vector<rtw::Stage> Medians(const std::vector<std::vector<rtw::Stage>>& frames)
{
  std::vector<rtw::Stage> medians = frames.empty() ? std::vector<rtw::Stage>() : frames.back();
  for (size_t i = 0; i < medians.size(); ++i)
  {
    std::vector<double> values;
    for (const std::vector<rtw::Stage>& frame : frames)
    {
      if (i < frame.size())
      {
        values.push_back(frame[i].Milliseconds);
      }
    }
    medians[i].Milliseconds = rtw::Median(values);
  }
  return medians;
}

std::unique_ptr<rtw::Technique> MakeShadows(
  const std::string& technique, int resolution, rtw::TechniqueSettings settings)
{
  settings.Resolution = resolution;
  return technique.empty() ? nullptr : rtw::MakeTechnique(technique, settings);
}
}

View::View(const rtw::Scene& scene, const Options& options, const Case& settings,
  std::string technique, int resolution)
  : Technique(std::move(technique))
  , CaseText(settings.Text)
  , Resolution(resolution)
  , Window(
      scene.Size[0], scene.Size[1],
      [&](vtkRenderer* renderer) {
        rtw::AddToRenderer(scene, renderer, options.Pieces);
        if (options.Camera)
        {
          renderer->ResetCameraClippingRange();
        }
      },
      MakeShadows(this->Technique, resolution, settings.Settings))
{
}

std::vector<Times> TakeTimes(Views& views, const Options& options)
{
  std::vector<Times> times(views.size());
  for (const bool rebuilding : { true, false })
  {
    std::vector<std::vector<double>> frames(views.size());
    std::vector<std::vector<std::vector<rtw::Stage>>> stages(views.size());
    rtw::Progress progress(rebuilding ? "frames with new shadow maps" : "frames at rest");
    for (int frame = -WARM_UP; frame < options.Frames; ++frame)
    {
      for (size_t i = 0; i < views.size(); ++i)
      {
        views[i]->Window.SetRebuilding(rebuilding);
        const double milliseconds = views[i]->Window.Render().Wall;
        if (frame >= 0)
        {
          frames[i].push_back(milliseconds);
          stages[i].push_back(views[i]->Window.GetStages());
        }
      }
      progress.Tell(double(frame + WARM_UP + 1) / (options.Frames + WARM_UP));
    }
    for (size_t i = 0; i < views.size(); ++i)
    {
      (rebuilding ? times[i].Rebuilt : times[i].Still) = rtw::Median(frames[i]);
      if (rebuilding)
      {
        times[i].Stages = Medians(stages[i]);
      }
    }
  }
  return times;
}
