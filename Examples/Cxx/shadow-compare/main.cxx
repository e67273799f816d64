// SPDX-License-Identifier: BSD-3-Clause
// Compares shadow techniques on a scene: how many pixels are wrong, and how long a frame takes.
#include "Options.h"
#include "Report.h"
#include "View.h"

#include "rtwCompare.h"
#include "rtwPictures.h"
#include "rtwProgress.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkRTWEGLRenderWindow.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <tuple>

namespace
{
bool IsKnown(const std::string& scene)
{
  const std::vector<std::string> names = rtw::SceneNames();
  return std::find(names.begin(), names.end(), scene) != names.end();
}

rtw::Scene OpenScene(const Options& options)
{
  rtw::Scene scene;
  try
  {
    scene = IsKnown(options.Scene) ? rtw::MakeScene(options.Scene, options.Scale)
                                   : rtw::LoadScene(options.Scene);
  }
  catch (const std::runtime_error& error)
  {
    throw rtw::UsageError(error.what());
  }
  if (options.Size)
  {
    std::tie(scene.Size[0], scene.Size[1]) = *options.Size;
  }
  if (options.Light)
  {
    scene.Light = *options.Light;
  }
  if (options.Camera)
  {
    scene.Camera.Position = options.Camera->Position;
    scene.Camera.Focal = options.Camera->Focal;
    scene.Camera.Angle = options.Camera->Angle;
  }
  return scene;
}

// Before anything is drawn, because it is a pity to fail after minutes.
void CheckOutputs(const Options& options)
{
  if (!options.OutputFolder.empty() && !vtksys::SystemTools::MakeDirectory(options.OutputFolder))
  {
    throw rtw::UsageError("--out " + options.OutputFolder + ": the folder cannot be made");
  }
  if (options.OutputFolder.empty() && !options.DebugViews.empty())
  {
    throw rtw::UsageError("--debug-view: --out DIR is missing, where the pictures go");
  }
  if (!options.JsonFile.empty() && !std::ofstream(options.JsonFile, std::ios::app))
  {
    throw rtw::UsageError("--json " + options.JsonFile + ": the file cannot be written");
  }
}

rtw::Truth TraceTruth(
  vtkRenderer* renderer, const rtw::Scene& scene, bool sharp, size_t& primitives)
{
  rtw::Progress progress("exact shadows");
  rtw::ReferenceOptions options;
  options.Sharp = sharp;
  options.Progress = [&progress](double share) { progress.Tell(share); };
  const rtw::ShadowReference reference(renderer, options);
  primitives = reference.NumberOfPrimitives();
  auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
  return reference.Trace(light, scene.Size[0], scene.Size[1]);
}

std::string PicturePath(const Options& options, const rtw::Scene& scene, const std::string& what)
{
  return options.OutputFolder + "/" + scene.Name + "-" + what + ".png";
}

// What the technique's maps look like inside, where it can show that.
void WriteDebugViews(
  View& view, const Options& options, const rtw::Scene& scene, const std::string& name)
{
  rtw::Technique& technique = *view.Window.GetTechnique();
  for (const std::string& what : options.DebugViews)
  {
    if (technique.SetDebugPicture(ToDebugPicture(what)))
    {
      view.Window.Render();
      rtw::WritePng(
        rtw::Grab(view.Window.GetWindow()), PicturePath(options, scene, name + "-" + what));
    }
  }
  technique.SetDebugPicture(rtw::DebugPicture::NONE);
}

// In the names of pictures.
std::string NameOfCase(const Options& options, const std::string& text)
{
  const auto same = [&](const Case& each) { return each.Text == text; };
  const auto at = std::find_if(options.Cases.begin(), options.Cases.end(), same);
  return at == options.Cases.end() ? std::string()
                                   : "-case" + std::to_string(at - options.Cases.begin() + 1);
}

// The picture must be taken before the mask, which may change the props.
Result Examine(View& view, const Options& options, const rtw::Scene& scene, const rtw::Truth& truth)
{
  Result result{ view.Technique, view.CaseText, view.Resolution, {}, {}, 0 };
  result.Memory = view.Window.GetTechnique()->GetMemory();
  const std::string name =
    view.Technique + "-" + std::to_string(view.Resolution) + NameOfCase(options, view.CaseText);
  view.Window.SetRebuilding(true);
  view.Window.Render();
  if (!options.OutputFolder.empty())
  {
    rtw::WritePng(rtw::Grab(view.Window.GetWindow()), PicturePath(options, scene, name));
  }
  const std::vector<unsigned char> mask = view.Window.GetTechnique()->MakeMask();
  result.Errors = rtw::Compare(mask, truth);
  result.Predicted = view.Window.GetTechnique()->GetPredictedError();
  if (!options.OutputFolder.empty())
  {
    rtw::WritePng(
      rtw::MaskImage(mask, truth.Width, truth.Height), PicturePath(options, scene, name + "-mask"));
    rtw::WritePng(rtw::DifferenceImage(mask, truth), PicturePath(options, scene, name + "-difference"));
    WriteDebugViews(view, options, scene, name);
  }
  return result;
}

void CompareWithVtk(std::vector<Result>& results)
{
  for (Result& result : results)
  {
    const auto vtk = std::find_if(results.begin(), results.end(), [&](const Result& other) {
      return other.Technique == "vtk" && other.Resolution == result.Resolution;
    });
    if (vtk != results.end())
    {
      result.ToVtk = result.Milliseconds.Rebuilt / vtk->Milliseconds.Rebuilt;
    }
  }
}

Report Measure(const rtw::Scene& scene, const Options& options)
{
  Views views;
  std::vector<Case> cases{ { "", options.Techniques, options.Resolutions, options.Settings } };
  cases.insert(cases.end(), options.Cases.begin(), options.Cases.end());
  views.push_back(std::make_unique<View>(scene, options, cases[0], "", 0));
  for (const Case& each : cases)
  {
    for (const int resolution : each.Resolutions)
    {
      for (const std::string& technique : each.Techniques)
      {
        views.push_back(std::make_unique<View>(scene, options, each, technique, resolution));
      }
    }
  }
  Report report{ scene, 0, {}, {}, {} };
  const rtw::Truth truth =
    TraceTruth(views[0]->Window.GetRenderer(), scene, options.SharpRays, report.Primitives);
  report.Truth = rtw::Compare(truth.Mask, truth);
  if (!options.OutputFolder.empty())
  {
    rtw::WritePng(
      rtw::MaskImage(truth.Mask, truth.Width, truth.Height), PicturePath(options, scene, "truth"));
    rtw::WritePng(rtw::Grab(views[0]->Window.GetWindow()), PicturePath(options, scene, "none"));
  }
  const std::vector<Times> times = TakeTimes(views, options);
  report.Baseline = times[0];
  for (size_t i = 1; i < views.size(); ++i)
  {
    report.Results.push_back(Examine(*views[i], options, scene, truth));
    report.Results.back().Milliseconds = times[i];
  }
  CompareWithVtk(report.Results);
  return report;
}

void Run(const Options& options)
{
  CheckOutputs(options);
  vtkRTWEGLRenderWindow::InstallAsDefault(false);
  const Report report = Measure(OpenScene(options), options);
  std::fputs(ToTable(report).c_str(), stdout);
  if (!options.JsonFile.empty())
  {
    std::ofstream(options.JsonFile) << ToJson(report);
  }
}
}

int main(int argc, char* argv[])
{
  return rtw::RunProgram("shadow-compare", [&] {
    if (const std::optional<Options> options = ParseOptions(argc, argv))
    {
      Run(*options);
    }
    return 0;
  });
}
