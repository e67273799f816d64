// SPDX-License-Identifier: BSD-3-Clause
#include "rtwTechniqueNames.h"

#include "rtwCommandLine.h"

namespace rtw
{
const Names<Filter>& FilterNames()
{
  static const Names<Filter> names = { { "nearest", Filter::NEAREST },
    { "bilinear", Filter::BILINEAR }, { "pcf", Filter::PCF }, { "soft", Filter::SOFT } };
  return names;
}

const Names<Rasterization>& RasterizationNames()
{
  static const Names<Rasterization> names = { { "linear", Rasterization::LINEAR },
    { "tessellated", Rasterization::TESSELLATED }, { "exact", Rasterization::EXACT },
    { "automatic", Rasterization::AUTOMATIC } };
  return names;
}

const Names<SampleSource>& SampleSourceNames()
{
  static const Names<SampleSource> names = { { "prepass", SampleSource::PREPASS },
    { "previous-frame", SampleSource::PREVIOUS_FRAME } };
  return names;
}

const Names<LightPlaneTurn>& LightPlaneTurnNames()
{
  static const Names<LightPlaneTurn> names = { { "off", LightPlaneTurn::OFF },
    { "view-aligned", LightPlaneTurn::VIEW_ALIGNED }, { "automatic", LightPlaneTurn::AUTOMATIC },
    { "minimal-frustum", LightPlaneTurn::MINIMAL_FRUSTUM } };
  return names;
}

const Names<Splits>& SplitsNames()
{
  static const Names<Splits> names = { { "uniform", Splits::UNIFORM },
    { "logarithmic", Splits::LOGARITHMIC }, { "practical", Splits::PRACTICAL },
    { "sample-distribution", Splits::SAMPLE_DISTRIBUTION } };
  return names;
}

const Names<LayerWarp>& LayerWarpNames()
{
  static const Names<LayerWarp> names = { { "identity", LayerWarp::IDENTITY },
    { "perspective", LayerWarp::PERSPECTIVE }, { "rtw", LayerWarp::RTW },
    { "notw", LayerWarp::NOTW } };
  return names;
}

const Names<DepthTest>& DepthTestNames()
{
  static const Names<DepthTest> names = { { "dual", DepthTest::DUAL },
    { "receiver-plane", DepthTest::RECEIVER_PLANE },
    { "constant-bias", DepthTest::CONSTANT_BIAS } };
  return names;
}

const Names<Perspective>& PerspectiveNames()
{
  static const Names<Perspective> names = { { "psm", Perspective::PSM },
    { "lispsm", Perspective::LISPSM }, { "tsm", Perspective::TSM },
    { "none", Perspective::UNWARPED } };
  return names;
}

const Names<Analysis>& AnalysisNames()
{
  static const Names<Analysis> names = { { "forward", Analysis::FORWARD },
    { "backward", Analysis::BACKWARD }, { "hybrid", Analysis::HYBRID } };
  return names;
}

const Names<Importance>& ImportanceNames()
{
  using Kind = Importance;
  static const Names<Kind> names = { { "desired-view", Kind::DESIRED_VIEW },
    { "distance", Kind::DISTANCE_TO_EYE }, { "normal", Kind::SURFACE_NORMAL },
    { "sqrt-demand", Kind::SQRT_DEMAND }, { "edges", Kind::SHADOW_EDGE },
    { "interest", Kind::CENTRE_OF_INTEREST }, { "user", Kind::USER_FUNCTION },
    { "footprint", Kind::FOOTPRINT }, { "count", Kind::SAMPLE_COUNT } };
  return names;
}

std::vector<Importance> ReadImportance(const std::string& option, const std::string& text)
{
  std::vector<Importance> kinds;
  for (const std::string& part : Split(text, '+'))
  {
    if (part == "published")
    {
      kinds.insert(kinds.end(),
        { Importance::DESIRED_VIEW, Importance::DISTANCE_TO_EYE, Importance::SURFACE_NORMAL });
    }
    else
    {
      kinds.push_back(Choose(option, part, ImportanceNames()));
    }
  }
  return kinds;
}

void ReadPerspective(
  const std::string& option, const std::string& text, TechniqueSettings& settings)
{
  const std::optional<double> nearDistance = ToNumber(text);
  if (nearDistance && *nearDistance > 0)
  {
    settings.NearDistance = nearDistance;
    return;
  }
  for (const auto& name : PerspectiveNames())
  {
    if (text == name.first)
    {
      settings.Parameterization = name.second;
      return;
    }
  }
  Refuse(option, text, "psm, lispsm, tsm, none, or n' above 0");
}

void ReadResolutionSplit(
  const std::string& option, const std::string& text, TechniqueSettings& settings)
{
  using Split = ResolutionSplit;
  const Names<Split> names = { { "square", Split::SQUARE }, { "critical", Split::CRITICAL },
    { "automatic", Split::AUTOMATIC } };
  const std::optional<double> ratio = ToNumber(text);
  if (ratio && *ratio >= 1.0 / 16 && *ratio <= 16)
  {
    settings.SplitRatio = ratio;
    return;
  }
  for (const auto& name : names)
  {
    if (text == name.first)
    {
      settings.Split = name.second;
      return;
    }
  }
  Refuse(option, text, "square, critical, automatic, or a ratio from 1/16 to 16");
}
}
