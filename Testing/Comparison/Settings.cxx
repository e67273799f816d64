// SPDX-License-Identifier: BSD-3-Clause
#include "rtwTechniqueSettings.h"

#include "rtwCommandLine.h"

#include <vtkCascadedShadowMapPass.h>
#include <vtkExactShadowMapPass.h>
#include <vtkIdentityShadowMapWarp.h>
#include <vtkNew.h>
#include <vtkNonOrthogonalShadowMapWarp.h>
#include <vtkPerspectiveShadowMapWarp.h>
#include <vtkRectilinearShadowMapWarp.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace rtw
{
namespace
{
using Pass = vtkAdaptiveShadowMapPass;
using Common = vtkConfigurableShadowMapPass;
using Cascades = vtkCascadedShadowMapPass;
using Rectilinear = vtkRectilinearShadowMapWarp;
using Grid = vtkNonOrthogonalShadowMapWarp;
using Perspective = vtkPerspectiveShadowMapWarp;
using Words = std::vector<std::pair<std::string, int>>;

// What of a pass is of that class: itself or its warp; null where neither is.
template <class Owner>
Owner* OwnerIn(Pass* pass)
{
  if constexpr (std::is_base_of_v<vtkShadowMapWarp, Owner>)
  {
    return Owner::SafeDownCast(pass->GetWarp());
  }
  else
  {
    return Owner::SafeDownCast(pass);
  }
}

template <class Owner, class Value>
Setting::Action Call(void (Owner::*set)(Value), Value value)
{
  return [=](Pass* pass) {
    if (auto* owner = OwnerIn<Owner>(pass))
    {
      (owner->*set)(value);
    }
  };
}

template <class Owner>
auto Number(void (Owner::*set)(double), double least, double most)
{
  return [=](const std::string& option, const std::string& text) {
    return Call(set, ReadNumber(option, text, least, most));
  };
}

template <class Owner>
auto Whole(void (Owner::*set)(int), int least, int most)
{
  return [=](const std::string& option, const std::string& text) {
    return Call(set, ReadWhole(option, text, least, most));
  };
}

std::vector<std::string> NamesOf(const Words& words)
{
  std::vector<std::string> names;
  for (const auto& word : words)
  {
    names.push_back(word.first);
  }
  return names;
}

template <class Owner, class Value>
Setting OneOf(const char* name, const char* value, const char* help, void (Owner::*set)(Value),
  const Words& words)
{
  return { name, value, help,
    [=](const std::string& option, const std::string& text) {
      return Call(set, static_cast<Value>(Choose(option, text, words)));
    },
    NamesOf(words) };
}

template <class Owner, class Value>
Setting Switch(const char* name, const char* help, void (Owner::*set)(Value))
{
  return OneOf(name, "on|off", help, set, { { "on", 1 }, { "off", 0 } });
}

const Words& ImportanceWords()
{
  static const Words words = { { "desired-view", Rectilinear::DESIRED_VIEW },
    { "distance", Rectilinear::DISTANCE_TO_EYE }, { "normal", Rectilinear::SURFACE_NORMAL },
    { "sqrt-demand", Rectilinear::SQRT_DEMAND }, { "edges", Rectilinear::SHADOW_EDGE },
    { "interest", Rectilinear::CENTRE_OF_INTEREST }, { "user", Rectilinear::USER_FUNCTION },
    { "footprint", Rectilinear::FOOTPRINT }, { "count", Rectilinear::SAMPLE_COUNT } };
  return words;
}

// Functions with a plus between them, where "published" stands for the first three.
Setting::Action ReadImportance(const std::string& option, const std::string& text)
{
  int functions = 0;
  for (const std::string& part : Split(text, '+'))
  {
    functions |= part == "published"
      ? Rectilinear::DESIRED_VIEW | Rectilinear::DISTANCE_TO_EYE | Rectilinear::SURFACE_NORMAL
      : Choose(option, part, ImportanceWords());
  }
  return [functions](Pass* pass) {
    if (auto* warp = OwnerIn<Rectilinear>(pass))
    {
      warp->SetImportance(functions);
    }
    auto* grid = OwnerIn<Grid>(pass);
    if (grid && (functions & Rectilinear::SAMPLE_COUNT))
    {
      grid->SetWeightsToCount();
    }
  };
}

Setting::Action ReadInterest(const std::string& option, const std::string& text)
{
  const std::vector<double> n = ToNumbers(text, 4);
  if (n.empty() || !(n[3] > 0))
  {
    Refuse(option, text, "X,Y,Z,R with R above 0");
  }
  return [n](Pass* pass) {
    if (auto* warp = OwnerIn<Rectilinear>(pass))
    {
      warp->SetInterestToSphere();
      warp->SetInterestCentre(n[0], n[1], n[2]);
      warp->SetInterestRadius(n[3]);
    }
  };
}

Setting::Action ReadUserFunction(const std::string&, const std::string& text)
{
  return [text](Pass* pass) {
    if (auto* warp = OwnerIn<Rectilinear>(pass))
    {
      warp->SetUserFunction(text.c_str());
    }
  };
}

Setting::Action ReadSmoothing(const std::string& option, const std::string& text)
{
  const double smoothing = ReadNumber(option, text, 0, 1);
  return [smoothing](Pass* pass) {
    if (auto* warp = OwnerIn<Grid>(pass))
    {
      warp->AutomaticSmoothingOff();
      warp->SetSmoothing(smoothing);
    }
  };
}

// A word, or a number within bounds.
template <class Owner>
auto WordOr(void (Owner::*byWord)(int), const Words& words, void (Owner::*byNumber)(double),
  double least, double most, const char* expected)
{
  return [=](const std::string& option, const std::string& text) {
    const std::optional<double> number = ToNumber(text);
    if (number && *number >= least && *number <= most)
    {
      return Call(byNumber, *number);
    }
    const auto is = [&](const auto& word) { return word.first == text; };
    const auto at = std::find_if(words.begin(), words.end(), is);
    if (at == words.end())
    {
      Refuse(option, text, expected);
    }
    return Call(byWord, at->second);
  };
}

enum WarpOfLayers
{
  IDENTITY,
  PERSPECTIVE,
  RECTILINEAR,
  NON_ORTHOGONAL
};

vtkSmartPointer<vtkShadowMapWarp> MakeWarp(int kind)
{
  switch (kind)
  {
    case PERSPECTIVE:
      return vtk::TakeSmartPointer<vtkShadowMapWarp>(Perspective::New());
    case RECTILINEAR:
      return vtk::TakeSmartPointer<vtkShadowMapWarp>(Rectilinear::New());
    case NON_ORTHOGONAL:
      return vtk::TakeSmartPointer<vtkShadowMapWarp>(Grid::New());
    default:
      return vtk::TakeSmartPointer<vtkShadowMapWarp>(vtkIdentityShadowMapWarp::New());
  }
}

// The warp of a technique that goes with several.
template <class Owner>
Setting WarpFor(const char* name, const char* help, const Words& words)
{
  return { name, "W", help,
    [=](const std::string& option, const std::string& text) -> Setting::Action {
      const int kind = Choose(option, text, words);
      return [kind](Pass* pass) {
        if (Owner::SafeDownCast(pass))
        {
          pass->SetWarp(MakeWarp(kind));
        }
      };
    },
    NamesOf(words) };
}

// Those that replace the warp come before those of the warp.
std::vector<Setting> MakeSettings()
{
  return {
    WarpFor<vtkExactShadowMapPass>("grid",
      "of exact: the warp of its grid, identity, rectilinear or non-orthogonal",
      { { "identity", IDENTITY }, { "rectilinear", RECTILINEAR },
        { "non-orthogonal", NON_ORTHOGONAL } }),
    WarpFor<Cascades>("warp", "of each cascade: identity, perspective, rtw or notw",
      { { "identity", IDENTITY }, { "perspective", PERSPECTIVE }, { "rtw", RECTILINEAR },
        { "notw", NON_ORTHOGONAL } }),
    OneOf("filter", "F", "nearest, bilinear, pcf or soft", &Common::SetFilter,
      { { "nearest", Pass::NEAREST }, { "bilinear", Pass::BILINEAR }, { "pcf", Pass::PCF },
        { "soft", Pass::SOFT } }),
    { "filter-radius", "R", "texels of pcf, 0 to 8; world units of soft; default 2",
      Number(&Common::SetFilterRadius, 0, 1e30), {} },
    Switch("filter-jitter", "whether pcf and soft displace their taps from pixel to pixel",
      &Common::SetFilterJitter),
    OneOf("rasterization", "R", "linear, tessellated, exact or automatic",
      &Common::SetRasterization,
      { { "linear", Pass::LINEAR }, { "tessellated", Pass::TESSELLATED }, { "exact", Pass::EXACT },
        { "automatic", Pass::AUTOMATIC } }),
    { "edge-length", "L", "of tessellated triangles at most, of the map's side; default 0.025",
      Number(&Common::SetMaximumEdgeLength, 0.001, 1), {} },
    OneOf("light-plane-turn", "T", "off, view-aligned, automatic or minimal-frustum",
      &Common::SetLightPlaneTurn,
      { { "off", Pass::TURN_OFF }, { "view-aligned", Pass::TURN_VIEW_ALIGNED },
        { "automatic", Pass::TURN_AUTOMATIC }, { "minimal-frustum", Pass::TURN_MINIMAL_FRUSTUM } }),
    OneOf("view-samples", "S", "prepass or previous-frame", &Common::SetViewSampleSource,
      { { "prepass", Pass::PREPASS }, { "previous-frame", Pass::PREVIOUS_FRAME } }),
    { "sample-stride", "N",
      "pixels a side of a square that gives a view sample, 1 to 64; default 2",
      Whole(&Common::SetViewSampleStride, 1, 64), {} },
    Switch("cull-casters", "whether what can shadow nothing in a layer is left out of it",
      &Common::SetCullCasters),
    OneOf("depth-test", "T", "dual, receiver-plane or constant-bias", &Common::SetDepthTest,
      { { "dual", Pass::DUAL }, { "receiver-plane", Pass::RECEIVER_PLANE },
        { "constant-bias", Pass::CONSTANT_BIAS } }),
    Switch("focus", "whether maps are fitted to what the camera sees", &Common::SetFocusOnView),
    { "importance", "I+...",
      "of rtw, multiplied: desired-view, distance, normal, sqrt-demand, edges, interest, user, "
      "footprint, count; published stands for the first three",
      ReadImportance, NamesOf(ImportanceWords()) },
    OneOf("analysis", "A", "of rtw: forward, backward or hybrid", &Rectilinear::SetAnalysis,
      { { "forward", Rectilinear::FORWARD }, { "backward", Rectilinear::BACKWARD },
        { "hybrid", Rectilinear::HYBRID } }),
    { "light-image", "N", "texels a side of the depth image of a forward or hybrid analysis",
      Whole(&Rectilinear::SetLightImageResolution, 16, 8192), {} },
    { "edge-threshold", "S", "least step of depth at an edge, as a share of the scene's diagonal",
      Number(&Rectilinear::SetEdgeThreshold, 0, 1), {} },
    { "interest", "X,Y,Z,R",
      "centre and radius of the sphere of interest; default the view's centre", ReadInterest, {} },
    { "user-function", "GLSL", "the user's own importance function", ReadUserFunction, {} },
    Switch("cull-empty-cells",
      "whether rtw gives columns and rows in which nothing is seen next to no texels",
      &Rectilinear::SetCullEmptyCells),
    { "blending", "B", "share of the last frame's warping functions that rtw keeps, 0 to 0.99",
      Number(&Rectilinear::SetTemporalBlending, 0, 0.99), {} },
    Switch("snapping", "whether rtw keeps texels in place while the camera moves a little",
      &Rectilinear::SetSnapping),
    { "smoothing", "S",
      "of notw: how far neighbouring lines are averaged, a share of the focus, 0 to 1; default: "
      "chosen by what least error is predicted for",
      ReadSmoothing, {} },
    { "cells", "N", "a side of the grid of notw, 64 to 2048; default 512",
      Whole(&Grid::SetImportanceResolution, 64, 2048), {} },
    { "perspective", "P",
      "of perspective, and of cascades warped so: psm, lispsm, tsm, none, or n' itself in world "
      "units; default lispsm",
      WordOr(&Perspective::SetParameterization,
        { { "psm", Perspective::PSM }, { "lispsm", Perspective::LISPSM },
          { "tsm", Perspective::TSM }, { "none", Perspective::UNWARPED } },
        &Perspective::SetNearDistance, 1e-300, 1e300, "psm, lispsm, tsm, none, or n' above 0"),
      {} },
    { "eta", "E", "likewise, instead: -1, no warp, over 0, LiSPSM, to 1, PSM",
      Number(&Perspective::SetEta, -1, 1), {} },
    { "resolution-split", "S",
      "of perspective, between s and t: square, critical (Lloyd et al. 2006, equations 13, 14), "
      "automatic (least predicted error) or texels along s over those along t",
      WordOr(&Perspective::SetResolutionSplit,
        { { "square", Perspective::SPLIT_SQUARE }, { "critical", Perspective::SPLIT_CRITICAL },
          { "automatic", Perspective::SPLIT_AUTOMATIC } },
        &Perspective::SetResolutionRatio, 1.0 / 16, 16,
        "square, critical, automatic, or a ratio from 1/16 to 16"),
      {} },
    { "focus-point", "F",
      "of tsm, what 80 % of the map lie before, 0.001 to 1 of what is seen; default 0.1",
      Number(&Perspective::SetFocusPoint, 0.001, 1), {} },
    OneOf("pixel-samples", "N", "of exact: points of a pixel that are tested, 1, 4 or 8; default 1",
      &vtkExactShadowMapPass::SetSamplesPerPixel, { { "1", 1 }, { "4", 4 }, { "8", 8 } }),
    { "layers", "N", "of cascades, 1 to 8; default 4", Whole(&Cascades::SetNumberOfLayers, 1, 8),
      {} },
    OneOf("splits", "S", "of cascades: uniform, logarithmic, practical or sample-distribution",
      &Cascades::SetSplitScheme,
      { { "uniform", Cascades::UNIFORM }, { "logarithmic", Cascades::LOGARITHMIC },
        { "practical", Cascades::PRACTICAL },
        { "sample-distribution", Cascades::SAMPLE_DISTRIBUTION } }),
    { "lambda", "L", "of practical splits, from 0, uniform, to 1, logarithmic; default 0.5",
      Number(&Cascades::SetLambda, 0, 1), {} },
    { "blend-width", "B", "of the band where a cascade gives way to the next, of its depths",
      Number(&Cascades::SetBlendWidth, 0, 1), {} },
    Switch("faces", "whether cascades are divided among the sides of the view frustum",
      &Cascades::SetSplitFaces),
    Switch("stable", "whether cascades keep texels in place while the camera moves",
      &Cascades::SetStable),
  };
}
}

const std::vector<Setting>& AllSettings()
{
  static const std::vector<Setting> settings = MakeSettings();
  return settings;
}

const Setting& FindSetting(const std::string& name)
{
  const auto is = [&](const Setting& setting) { return setting.Name == name; };
  const auto at = std::find_if(AllSettings().begin(), AllSettings().end(), is);
  if (at == AllSettings().end())
  {
    throw std::invalid_argument(name + ": there is no such setting");
  }
  return *at;
}

void TechniqueSettings::Set(const std::string& name, const std::string& text)
{
  FindSetting(name).Read("--" + name, text);
  this->Texts[name] = text;
}

std::string TechniqueSettings::Get(const std::string& name) const
{
  const auto at = this->Texts.find(name);
  return at == this->Texts.end() ? std::string() : at->second;
}

void TechniqueSettings::Apply(vtkAdaptiveShadowMapPass* pass) const
{
  pass->SetResolution(static_cast<unsigned int>(this->Resolution));
  pass->SetTimeStages(this->Stages);
  for (const Setting& setting : AllSettings())
  {
    const auto at = this->Texts.find(setting.Name);
    if (at != this->Texts.end())
    {
      setting.Read("--" + setting.Name, at->second)(pass);
    }
  }
}
}
