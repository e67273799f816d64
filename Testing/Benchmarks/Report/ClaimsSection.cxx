// SPDX-License-Identifier: BSD-3-Clause
#include "Sections.h"

#include "Markdown.h"
#include "VariantTable.h"

namespace
{
struct Claims
{
  MarkdownTable Table{ { "claim", "scene", "rtw", "beside it", "factor", "bound", "met" } };

  void Add(const std::string& claim, const std::string& scene, double own, double other,
    double bound, bool mayEqual)
  {
    const double allowed = bound * other;
    const bool isMet = mayEqual ? own <= allowed : own < allowed;
    this->Table.Add({ claim, scene, Percent(own) + " %", Percent(other) + " %",
      other > 0 ? Times(own / other) : "-", (mayEqual ? "≤ " : "< ") + Times(bound),
      isMet ? "yes" : "**no**" });
  }

  void AddMissing(const std::string& claim, const std::string& scene)
  {
    this->Table.Add({ claim, scene, "-", "-", "-", "-", "not measured" });
  }
};

const Line* Find(const Selection& lines, const std::string& claim, const std::string& scene,
  const std::string& technique, const std::string& map)
{
  return Pick(
    lines, { { "claim", claim }, { "scene", scene }, { "technique", technique }, { "map", map } });
}

void AddErrors(const Selection& lines, Claims& claims)
{
  const std::string claim = "error of 512² beside uniform 2048² of the whole scene: less";
  for (const std::string& scene : ValuesOf(lines, "scene"))
  {
    const Line* own = Find(lines, "error", scene, "rtw", "512");
    const Line* other = Find(lines, "error", scene, "uniform", "2048");
    if (own && other)
    {
      claims.Add(
        claim, scene, own->Value("wrong_percent"), other->Value("wrong_percent"), 1, false);
    }
    else
    {
      claims.AddMissing(claim, scene);
    }
  }
}

void AddFlicker(const Selection& lines, Claims& claims)
{
  const std::pair<const char*, const char*> maps[] = { { "1024", "" }, { "1024", "snapping" },
    { "2048", "" } };
  for (const auto& [map, variant] : maps)
  {
    const std::string claim = std::string("flicker of ") + map + "²" +
      (*variant ? std::string(", ") + variant + "," : "") + " beside uniform 4096²";
    for (const std::string& scene : ValuesOf(lines, "scene"))
    {
      const Line* own = Pick(lines,
        { { "claim", "flicker" }, { "scene", scene }, { "technique", "rtw" }, { "map", map },
          { "variant", variant } });
      const Line* other = Find(lines, "flicker", scene, "uniform", "4096");
      if (own && other && own->Has("flicker_percent") && other->Has("flicker_percent"))
      {
        claims.Add(
          claim, scene, own->Value("flicker_percent"), other->Value("flicker_percent"), 1.5, true);
      }
      else
      {
        claims.AddMissing(claim, scene);
      }
    }
  }
}

// Of the GPU's frame.
void AddShares(const Selection& lines, Claims& claims)
{
  const std::vector<std::string> analysis = { "focus", "light images", "warp" };
  std::vector<std::string> withSamples = analysis;
  withSamples.insert(withSamples.end(), { "view samples", "resampling" });
  const std::pair<const char*, std::vector<std::string>> shares[] = {
    { "analysis and warp beside the whole frame, 1024²", analysis },
    { "the same, with the view samples, which the mask needs too", withSamples }
  };
  for (const auto& [claim, stages] : shares)
  {
    const Line* line = Find(lines, "flicker", "town", "rtw", "1024");
    const double frame = line ? line->Value("gpu_ms") : 0;
    if (frame > 0 && StageSum(*line, stages) > 0)
    {
      claims.Add(claim, "town", 100 * StageSum(*line, stages) / frame, 100, 0.15, true);
    }
    else
    {
      claims.AddMissing(claim, "town");
    }
  }
}
}

std::vector<std::string> SectionFamilies()
{
  return { "paper", "functions", "rasterizations", "filters", "view-samples", "claims" };
}

std::string ClaimsTable(const Results& results)
{
  const Selection lines = OfFamily(results, "claims");
  if (lines.empty())
  {
    return "";
  }
  Claims claims;
  AddErrors(lines, claims);
  AddFlicker(lines, claims);
  AddShares(lines, claims);
  return claims.Table.Text();
}

std::string ClaimsSection(const Results& results)
{
  const std::string table = ClaimsTable(results);
  return table.empty() ? ""
                       : "## Claims\n\nOf the technique rtw with its default importance, the "
                         "square root of demand.\n\n" +
      table;
}
