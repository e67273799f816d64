// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <vtk_jsoncpp.h>

#include <cstdio>

namespace
{
template <class... Values>
std::string Format(const char* format, Values... values)
{
  char line[512];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

std::string Row(const Result& result)
{
  const rtw::ShadowErrors& errors = result.Errors;
  const std::string ratio = result.ToVtk > 0 ? Format("%.2f", result.ToVtk) : "-";
  const std::string predicted =
    result.Predicted >= 0 ? Format("%.4f", 100 * result.Predicted) : "-";
  return Format("%-10s %6d  %8.4f %9s %8.4f %8.4f %8.4f %8.4f  %9.2f %9.2f %7s %9.1f%s\n",
    result.Technique.c_str(), result.Resolution, errors.Percent(errors.Wrong()), predicted.c_str(),
    errors.Percent(errors.WronglyDark), errors.Percent(errors.WronglyLit),
    errors.Percent(errors.FarFromEdge), errors.Percent(errors.NotComparable),
    result.Milliseconds.Rebuilt, result.Milliseconds.Still, ratio.c_str(),
    double(result.Memory) / 1048576,
    result.CaseText.empty() ? "" : ("  " + result.CaseText).c_str());
}

std::string StageTable(const Result& result)
{
  std::string text;
  if (!result.Milliseconds.Stages.empty())
  {
    text = Format("\n%s %d%s, ms of the GPU a frame\n", result.Technique.c_str(), result.Resolution,
      result.CaseText.empty() ? "" : (" (" + result.CaseText + ")").c_str());
  }
  for (const rtw::Stage& stage : result.Milliseconds.Stages)
  {
    text += Format("  %-28s %9.3f\n", stage.Name.c_str(), stage.Milliseconds);
  }
  return text;
}

Json::Value ToJson(const Result& result)
{
  const rtw::ShadowErrors& errors = result.Errors;
  Json::Value value;
  value["technique"] = result.Technique;
  value["case"] = result.CaseText;
  value["resolution"] = result.Resolution;
  value["wrong_percent"] = errors.Percent(errors.Wrong());
  value["predicted_percent"] =
    result.Predicted >= 0 ? Json::Value(100 * result.Predicted) : Json::Value(Json::nullValue);
  value["wrongly_dark_percent"] = errors.Percent(errors.WronglyDark);
  value["wrongly_lit_percent"] = errors.Percent(errors.WronglyLit);
  value["far_from_edge_percent"] = errors.Percent(errors.FarFromEdge);
  value["undecided_percent"] = errors.Percent(errors.NotComparable);
  value["rebuilt_ms"] = result.Milliseconds.Rebuilt;
  value["still_ms"] = result.Milliseconds.Still;
  value["rebuilt_to_vtk"] =
    result.ToVtk > 0 ? Json::Value(result.ToVtk) : Json::Value(Json::nullValue);
  value["shadow_memory_bytes"] = Json::Int64(result.Memory);
  for (const rtw::Stage& stage : result.Milliseconds.Stages)
  {
    Json::Value entry;
    entry["name"] = stage.Name;
    entry["ms"] = stage.Milliseconds;
    value["stages"].append(entry);
  }
  return value;
}
}

std::string ToTable(const Report& report)
{
  const rtw::ShadowErrors& truth = report.Truth;
  std::string text = Format("%s: %zu triangles, %d x %d pixels, %zu face the light, %.2f %% of "
                            "those in shadow\n",
    report.Scene.Name.c_str(), report.Primitives, report.Scene.Size[0], report.Scene.Size[1],
    truth.LitFacing, truth.Percent(truth.Shadowed));
  text += Format("without shadows: %.2f ms a frame\n\n", report.Baseline.Rebuilt);
  text += "                                 % of the pixels that face the light                  "
          "ms a frame\n";
  text += "technique     res     wrong predicted     dark      lit      far undecided    rebuilt   "
          "  still"
          "  to vtk       MiB\n";
  for (const Result& result : report.Results)
  {
    text += Row(result);
  }
  text +=
    "\npredicted: wrong, by the technique's own account; dark, lit: wrongly so; far: wrong, and "
    "more than two\npixels from a shadow's edge; to vtk: rebuilt, in times VTK's own pass; MiB: of "
    "shadow maps\n";
  for (const Result& result : report.Results)
  {
    text += StageTable(result);
  }
  return text;
}

std::string ToJson(const Report& report)
{
  Json::Value root;
  const rtw::ShadowErrors& truth = report.Truth;
  root["scene"] = report.Scene.Name;
  root["width"] = report.Scene.Size[0];
  root["height"] = report.Scene.Size[1];
  root["triangles"] = Json::UInt64(report.Primitives);
  root["lit_facing_pixels"] = Json::UInt64(truth.LitFacing);
  root["shadowed_percent"] = truth.Percent(truth.Shadowed);
  root["at_edge_percent"] = truth.Percent(truth.AtEdge);
  root["without_shadows_ms"] = report.Baseline.Rebuilt;
  root["results"] = Json::Value(Json::arrayValue);
  for (const Result& result : report.Results)
  {
    root["results"].append(ToJson(result));
  }
  return Json::writeString(Json::StreamWriterBuilder(), root) + "\n";
}
