// SPDX-License-Identifier: BSD-3-Clause
// What shadow-benchmark wrote, read again.
#ifndef Results_h
#define Results_h

#include <map>
#include <string>
#include <vector>

/// One setup by one technique. Counters have a value for each lap, "ms" too, which is a lap's
/// median frame.
struct Line
{
  std::string Name;
  std::map<std::string, std::string> Keys; // scene, map, technique, and what the family varies
  std::string Family;
  std::map<std::string, std::vector<double>> Counters;

  std::string Key(const std::string& key) const;
  bool Has(const std::string& counter) const { return this->Counters.count(counter) > 0; }
  /// The middle of the laps, or the mean of ratios of times, which another run comes closer to; 0
  /// if the line has no such counter.
  double Value(const std::string& counter) const;
  /// The standard deviation of a lap, as a share of the mean; 0 with less than two.
  double Noise(const std::string& counter) const;
};

/// A run of the benchmark, on one machine.
struct Results
{
  std::string File; // without its folder
  std::string Date;
  int Cores = 0;
  std::map<std::string, std::string> Context;
  std::vector<Line> Lines;

  const Line* Find(const std::string& name) const; // null if there is none
  std::string Renderer() const;
};

using Selection = std::vector<const Line*>;

Selection OfFamily(const Results& results, const std::string& family);
Selection Select(const Selection& lines, const std::string& key, const std::string& value);

/// The different values of a key, as they first come up.
std::vector<std::string> ValuesOf(const Selection& lines, const std::string& key);

/// The line of such values; null if there is none.
const Line* Pick(const Selection& lines, const std::map<std::string, std::string>& keys);

/// Adds the lines of another run, of other families, unless the two have one in common: then
/// nothing changes, and it returns false.
bool Join(Results& to, const Results& from);

/// Throws rtw::UsageError, with a message that names the file, if it is none of shadow-benchmark's.
Results ReadResults(const std::string& path);

#endif
