// SPDX-License-Identifier: BSD-3-Clause
#include "Results.h"

#include "rtwCommandLine.h"
#include "rtwQuantile.h"

#include <vtk_jsoncpp.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>

namespace
{
double Mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

// "family/key:value/key:value", where no value has a slash.
void ReadName(Line& line)
{
  const std::vector<std::string> parts = rtw::Split(line.Name, '/');
  line.Family = parts.front();
  for (const std::string& part : parts)
  {
    const std::size_t colon = part.find(':');
    if (colon != std::string::npos)
    {
      line.Keys[part.substr(0, colon)] = part.substr(colon + 1);
    }
  }
}

void ReadLine(const Json::Value& entry, Results& results)
{
  const std::string name = entry.get("run_name", entry["name"]).asString();
  if (results.Lines.empty() || results.Lines.back().Name != name)
  {
    results.Lines.push_back({ name, {}, {}, {} });
    ReadName(results.Lines.back());
  }
  auto& counters = results.Lines.back().Counters;
  counters["ms"].push_back(entry["real_time"].asDouble());
  for (const std::string& key : entry.getMemberNames())
  {
    static const char* const own[] = { "real_time", "cpu_time", "family_index",
      "per_family_instance_index", "repetitions", "repetition_index", "iterations", "threads" };
    const bool isOwn = std::find(std::begin(own), std::end(own), key) != std::end(own);
    if (!isOwn && entry[key].isNumeric())
    {
      counters[key].push_back(entry[key].asDouble());
    }
  }
}

void ReadContext(const Json::Value& context, Results& results)
{
  results.Date = context.get("date", "").asString();
  results.Cores = context.get("num_cpus", 0).asInt();
  for (const std::string& key : context.getMemberNames())
  {
    if (context[key].isString())
    {
      results.Context[key] = context[key].asString();
    }
  }
}
}

std::string Line::Key(const std::string& key) const
{
  const auto at = this->Keys.find(key);
  return at == this->Keys.end() ? "" : at->second;
}

double Line::Value(const std::string& counter) const
{
  const auto at = this->Counters.find(counter);
  if (at == this->Counters.end())
  {
    return 0;
  }
  return counter.rfind("to_", 0) == 0 ? Mean(at->second) : rtw::Median(at->second);
}

double Line::Noise(const std::string& counter) const
{
  const auto at = this->Counters.find(counter);
  if (at == this->Counters.end() || at->second.size() < 2)
  {
    return 0;
  }
  const std::vector<double>& values = at->second;
  const double mean = Mean(values);
  double sum = 0;
  for (const double value : values)
  {
    sum += (value - mean) * (value - mean);
  }
  return mean > 0 ? std::sqrt(sum / double(values.size() - 1)) / mean : 0;
}

const Line* Results::Find(const std::string& name) const
{
  const auto at = std::find_if(
    this->Lines.begin(), this->Lines.end(), [&](const Line& line) { return line.Name == name; });
  return at == this->Lines.end() ? nullptr : &*at;
}

std::string Results::Renderer() const
{
  return this->Context.at("gl_renderer");
}

Selection OfFamily(const Results& results, const std::string& family)
{
  Selection selection;
  for (const Line& line : results.Lines)
  {
    if (line.Family == family)
    {
      selection.push_back(&line);
    }
  }
  return selection;
}

Selection Select(const Selection& lines, const std::string& key, const std::string& value)
{
  Selection selection;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(selection),
    [&](const Line* line) { return line->Key(key) == value; });
  return selection;
}

std::vector<std::string> ValuesOf(const Selection& lines, const std::string& key)
{
  std::vector<std::string> values;
  for (const Line* line : lines)
  {
    const std::string value = line->Key(key);
    if (!value.empty() && std::find(values.begin(), values.end(), value) == values.end())
    {
      values.push_back(value);
    }
  }
  return values;
}

const Line* Pick(const Selection& lines, const std::map<std::string, std::string>& keys)
{
  const auto at = std::find_if(lines.begin(), lines.end(), [&](const Line* line) {
    return std::all_of(keys.begin(), keys.end(),
      [&](const auto& key) { return line->Key(key.first) == key.second; });
  });
  return at == lines.end() ? nullptr : *at;
}

bool Join(Results& to, const Results& from)
{
  const bool overlaps = std::any_of(from.Lines.begin(), from.Lines.end(),
    [&](const Line& line) { return to.Find(line.Name) != nullptr; });
  if (!overlaps)
  {
    to.File += ", " + from.File;
    to.Lines.insert(to.Lines.end(), from.Lines.begin(), from.Lines.end());
  }
  return !overlaps;
}

Results ReadResults(const std::string& path)
{
  Results results;
  results.File = vtksys::SystemTools::GetFilenameName(path);
  std::ifstream stream(path);
  if (!stream)
  {
    throw rtw::UsageError(path + ": there is no such file");
  }
  Json::Value root;
  std::string errors;
  Json::CharReaderBuilder reader;
  reader["allowSpecialFloats"] = true; // variations of what is zero
  if (!Json::parseFromStream(reader, stream, &root, &errors) || !root.isObject() ||
    !root["benchmarks"].isArray() || !root["context"].isObject())
  {
    throw rtw::UsageError(path + ": expected JSON that shadow-benchmark wrote");
  }
  ReadContext(root["context"], results);
  for (const Json::Value& entry : root["benchmarks"])
  {
    if (entry.isObject() && entry.get("run_type", "").asString() == "iteration" &&
      entry["real_time"].isNumeric())
    {
      ReadLine(entry, results);
    }
  }
  if (results.Lines.empty() || results.Context.count("gl_renderer") == 0)
  {
    throw rtw::UsageError(path + ": expected lines and a \"gl_renderer\" of shadow-benchmark");
  }
  return results;
}
