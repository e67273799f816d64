// SPDX-License-Identifier: BSD-3-Clause
// What can be set of a technique, by the names and texts that command lines and results have for it.
#ifndef rtwTechniqueSettings_h
#define rtwTechniqueSettings_h

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkAdaptiveShadowMapPass;

namespace rtw
{
/// One property of a pass, of its warp, or of both.
struct Setting
{
  using Action = std::function<void(vtkAdaptiveShadowMapPass* pass)>;

  std::string Name;  ///< without dashes
  std::string Value; ///< what follows it on a command line
  std::string Help;
  /// What a text sets of a pass; of one that has no such property, nothing. Throws UsageError, with
  /// the option's name, for a text that says nothing.
  std::function<Action(const std::string& option, const std::string& text)> Read;
  std::vector<std::string> Choices; ///< the words that it takes; none where it takes others too
};

/// All there are: a setting is one line of Settings.cxx.
const std::vector<Setting>& AllSettings();
/// Throws std::invalid_argument for a name that there isn't.
const Setting& FindSetting(const std::string& name);

/// Settings that are not given stay what the technique has by itself.
class TechniqueSettings
{
public:
  int Resolution = 1024; ///< texels a side of a shadow map
  bool Stages = false;   ///< whether to time the stages on the GPU

  /// Throws UsageError for a text that the setting doesn't take.
  void Set(const std::string& name, const std::string& text);
  /// The text that was set last; empty where none was.
  std::string Get(const std::string& name) const;
  void Apply(vtkAdaptiveShadowMapPass* pass) const;

private:
  std::map<std::string, std::string> Texts;
};
}

#endif
