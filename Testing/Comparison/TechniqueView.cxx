// SPDX-License-Identifier: BSD-3-Clause
#include "rtwTechniqueView.h"

#include "GL/rtwOpenGL.h"
#include "rtwGpuClock.h"

#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <chrono>
#include <ctime>
#include <stdexcept>
#include <string>

namespace rtw
{
namespace
{
bool RendersInSoftware()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string name = renderer ? renderer : "";
  for (const char* software : { "llvmpipe", "softpipe", "SwiftShader" })
  {
    if (name.find(software) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

double ProcessMilliseconds()
{
  return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

double ThreadMilliseconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
#else
  return ProcessMilliseconds();
#endif
}
}

TechniqueView::TechniqueView(int width, int height,
  const std::function<void(vtkRenderer*)>& populate, std::unique_ptr<Technique> technique)
  : Shadows(std::move(technique))
{
  this->Window->SetShowWindow(false);
  this->Window->SetUseOffScreenBuffers(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  if (!this->Window->SupportsOpenGL())
  {
    throw std::runtime_error("OpenGL does not work here");
  }
  populate(this->Renderer);
  if (this->Shadows)
  {
    this->Shadows->Install(this->Renderer);
  }
  this->Window->MakeCurrent();
  this->IsSoftware = RendersInSoftware();
}

TechniqueView::~TechniqueView()
{
  this->Window->MakeCurrent();
  this->Renderer->SetPass(nullptr);
  if (this->Shadows)
  {
    this->Shadows->ReleaseGraphicsResources(this->Window);
  }
}

void TechniqueView::SetRebuilding(bool rebuilding)
{
  if (this->Shadows)
  {
    this->Shadows->SetRebuilding(rebuilding);
  }
}

FrameTime TechniqueView::Render()
{
  using Clock = std::chrono::steady_clock;
  this->Window->MakeCurrent();
  this->Window->WaitForCompletion();
  GpuClock gpu;
  const double work = ProcessMilliseconds(), cpu = ThreadMilliseconds();
  const Clock::time_point start = Clock::now();
  if (this->Shadows)
  {
    this->Shadows->PrepareFrame();
  }
  this->Window->Render();
  if (this->Shadows)
  {
    this->Shadows->FinishFrame();
  }
  gpu.Stop();
  this->Window->WaitForCompletion();
  FrameTime time;
  time.Wall = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  time.Cpu = ThreadMilliseconds() - cpu;
  time.Work = this->IsSoftware ? ProcessMilliseconds() - work : time.Wall;
  time.Gpu = gpu.GetMilliseconds();
  return time;
}

std::vector<Stage> TechniqueView::GetStages()
{
  return this->Shadows ? this->Shadows->GetStages() : std::vector<Stage>();
}
}
