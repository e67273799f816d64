// SPDX-License-Identifier: BSD-3-Clause
// Makes tables and plots of what shadow-benchmark measured.
#include "Page.h"
#include "ReportOptions.h"
#include "Sections.h"

#include "rtwCommandLine.h"

#include <vtkRTWEGLRenderWindow.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

namespace
{
// "llvmpipe (LLVM 15.0.6, 256 bits)" becomes "llvmpipe", "NVIDIA H200/PCIe/SSE2" "nvidia-h200".
std::string ShortName(const std::string& renderer)
{
  std::string name;
  for (const char c : renderer.substr(0, renderer.find_first_of("(/,")))
  {
    if (std::isalnum(static_cast<unsigned char>(c)))
    {
      name += char(std::tolower(static_cast<unsigned char>(c)));
    }
    else if (!name.empty() && name.back() != '-')
    {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-')
  {
    name.pop_back();
  }
  return name.empty() ? "unknown" : name;
}

struct Renderer
{
  std::string Name; // in the OpenGL driver's words
  std::string ShortName;
  std::vector<Results> Runs;
};

// Never two renderers under one name, even if they are shortened alike.
std::vector<Renderer> Sort(const std::vector<std::string>& files)
{
  std::vector<Renderer> renderers;
  std::map<std::string, int> used;
  for (const std::string& file : files)
  {
    Results results = ReadResults(file);
    const std::string name = results.Renderer();
    auto at = std::find_if(renderers.begin(), renderers.end(),
      [&](const Renderer& renderer) { return renderer.Name == name; });
    if (at == renderers.end())
    {
      std::string brief = ShortName(name);
      const int number = ++used[brief];
      brief += number > 1 ? "-" + std::to_string(number) : "";
      at = renderers.insert(renderers.end(), { name, brief, {} });
    }
    if (at->Runs.empty() || !Join(at->Runs.back(), results))
    {
      at->Runs.push_back(std::move(results));
    }
  }
  return renderers;
}

void Write(const std::string& path, const std::string& text)
{
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  if (!stream.flush())
  {
    throw std::runtime_error(path + ": cannot be written");
  }
}

std::vector<Change> Changes(const Renderer& renderer)
{
  std::vector<Change> changes;
  if (renderer.Runs.size() > 1)
  {
    const Results &first = renderer.Runs.front(), &last = renderer.Runs.back();
    changes.push_back({ first.File, Compare(first, last) });
  }
  return changes;
}

// By which the runs that are shown are made again.
std::string Commands(const std::vector<Renderer>& renderers)
{
  std::set<std::string> shown;
  for (const Renderer& renderer : renderers)
  {
    for (const Line& line : renderer.Runs.back().Lines)
    {
      shown.insert(line.Family);
    }
  }
  std::string named;
  for (const std::string& family : SectionFamilies())
  {
    if (shown.erase(family) > 0)
    {
      named += (named.empty() ? "" : ",") + family;
    }
  }
  std::string measure, files;
  if (!shown.empty())
  {
    measure += "    shadow-benchmark --benchmark_out results.json\n";
    files += " results.json";
  }
  if (!named.empty())
  {
    measure += "    shadow-benchmark --family " + named + " --benchmark_out tables.json\n";
    files += " tables.json";
  }
  return measure + "    shadow-report" + files + " --out Testing/Benchmarks\n\n";
}

int Run(const ReportOptions& options)
{
  const std::vector<Renderer> renderers = Sort(options.Files);
  std::string index =
    "# Results\n\nBy `shadow-report`, from what `shadow-benchmark` measured; a page for "
    "each OpenGL renderer. The tables here are at 1024 × 1024 texels, camera moving.\n\n" +
    Commands(renderers);
  bool isWorse = false;
  for (const Renderer& renderer : renderers)
  {
    const std::string plots = "plots-" + renderer.ShortName;
    if (!vtksys::SystemTools::MakeDirectory(options.OutputFolder + "/" + plots))
    {
      throw rtw::UsageError("--out " + options.OutputFolder + ": the folder cannot be made");
    }
    const std::vector<Change> changes = Changes(renderer);
    for (const Change& change : changes)
    {
      std::printf(
        "%s, since %s:\n%s", renderer.Name.c_str(), change.File.c_str(), Tell(change).c_str());
      isWorse = isWorse || !change.Found.Flags.empty();
    }
    const std::string page = "RESULTS-" + renderer.ShortName + ".md";
    const Results& results = renderer.Runs.back();
    Write(
      options.OutputFolder + "/" + page, WritePage(results, changes, options.OutputFolder, plots));
    index +=
      "## [" + renderer.Name + "](" + page + ")\n\n" + Summary(results) + ClaimsTable(results);
  }
  Write(options.OutputFolder + "/RESULTS.md", index);
  return options.Check && isWorse ? 3 : 0;
}
}

int main(int argc, char* argv[])
{
  return rtw::RunProgram("shadow-report", [&] {
    const ReportOptions options = ParseOptions(argc, argv);
    if (options.Help)
    {
      std::fputs(HelpText().c_str(), stdout);
      return 0;
    }
    vtkRTWEGLRenderWindow::InstallAsDefault(false);
    return Run(options);
  });
}
