// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "Progress.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace
{
constexpr int WARM_UP = 3; // frames that build shaders and buffers, and fill what is a frame late

double Median(std::vector<double> values)
{
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return values.empty() ? 0 : *middle;
}

// Of each stage, over the frames.
std::vector<Stage> Medians(const std::vector<std::vector<Stage>>& frames)
{
  std::vector<Stage> medians = frames.empty() ? std::vector<Stage>() : frames.back();
  for (size_t i = 0; i < medians.size(); ++i)
  {
    std::vector<double> values;
    for (const std::vector<Stage>& frame : frames)
    {
      if (i < frame.size())
      {
        values.push_back(frame[i].Milliseconds);
      }
    }
    medians[i].Milliseconds = Median(values);
  }
  return medians;
}
}

View::View(const rtw::Scene& scene, const Options& options, std::string technique, int resolution)
  : Name(std::move(technique))
  , Resolution(resolution)
{
  this->Window->SetShowWindow(false);
  this->Window->SetUseOffScreenBuffers(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(scene.Size[0], scene.Size[1]);
  this->Window->AddRenderer(this->Renderer);
  if (!this->Window->SupportsOpenGL())
  {
    throw std::runtime_error("OpenGL does not work here");
  }
  rtw::AddToRenderer(scene, this->Renderer, options.Pieces);
  if (options.Camera)
  {
    this->Renderer->ResetCameraClippingRange();
  }
  if (!this->Name.empty())
  {
    this->Shadows = MakeTechnique(this->Name, resolution, options);
    this->Shadows->Install(this->Renderer);
  }
  this->Window->Render();
}

View::~View()
{
  this->Window->MakeCurrent();
  this->Renderer->SetPass(nullptr);
  if (this->Shadows)
  {
    this->Shadows->ReleaseGraphicsResources(this->Window);
  }
}

void View::SetRebuilding(bool rebuilding)
{
  if (this->Shadows)
  {
    this->Shadows->SetRebuilding(rebuilding);
  }
}

double View::Render()
{
  using Clock = std::chrono::steady_clock;
  this->Window->MakeCurrent();
  this->Window->WaitForCompletion();
  const Clock::time_point start = Clock::now();
  if (this->Shadows)
  {
    this->Shadows->PrepareFrame();
  }
  this->Window->Render();
  this->Window->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<Times> TakeTimes(Views& views, const Options& options)
{
  std::vector<Times> times(views.size());
  for (const bool rebuilding : { true, false })
  {
    std::vector<std::vector<double>> frames(views.size());
    std::vector<std::vector<std::vector<Stage>>> stages(views.size());
    Progress progress(rebuilding ? "frames with new shadow maps" : "frames at rest");
    for (int frame = -WARM_UP; frame < options.Frames; ++frame)
    {
      for (size_t i = 0; i < views.size(); ++i)
      {
        views[i]->SetRebuilding(rebuilding);
        const double milliseconds = views[i]->Render();
        if (frame >= 0)
        {
          frames[i].push_back(milliseconds);
          stages[i].push_back(views[i]->GetTechnique() ? views[i]->GetTechnique()->GetStages()
                                                       : std::vector<Stage>());
        }
      }
      progress.Tell(double(frame + WARM_UP + 1) / (options.Frames + WARM_UP));
    }
    for (size_t i = 0; i < views.size(); ++i)
    {
      (rebuilding ? times[i].Rebuilt : times[i].Still) = Median(frames[i]);
      if (rebuilding)
      {
        times[i].Stages = Medians(stages[i]);
      }
    }
  }
  return times;
}
