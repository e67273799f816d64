// SPDX-License-Identifier: BSD-3-Clause
// What command lines say, beside CLI11.
#ifndef rtwCommandLine_h
#define rtwCommandLine_h

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}

namespace rtw
{
/// A command line that cannot be obeyed. The message is one line.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Throws UsageError: option, value, and what was expected.
[[noreturn]] void Refuse(
  const std::string& option, const std::string& value, const std::string& expected);

std::vector<std::string> Split(const std::string& text, char separator);
std::string Join(const std::vector<std::string>& names);

/// All of a text, or nothing.
std::optional<double> ToNumber(const std::string& text);

/// `count` numbers between commas; empty if they are not that.
std::vector<double> ToNumbers(const std::string& text, size_t count);

/// These throw UsageError where the text is anything else.
int ReadWhole(const std::string& option, const std::string& text, int least, int most);
double ReadNumber(const std::string& option, const std::string& text, double least, double most);
std::vector<int> ReadWholes(
  const std::string& option, const std::string& text, int least, int most);
std::pair<int, int> ReadSize(const std::string& option, const std::string& text); // WxH
std::vector<std::string> ReadNames(
  const std::string& option, const std::string& text, const std::vector<std::string>& known);

template <class Value>
Value Choose(const std::string& option, const std::string& text,
  const std::vector<std::pair<std::string, Value>>& choices)
{
  std::vector<std::string> names;
  for (const auto& [name, value] : choices)
  {
    if (name == text)
    {
      return value;
    }
    names.push_back(name);
  }
  Refuse(option, text, "one of " + Join(names));
}

/// An option with a value, which `read` gets; of several the last counts.
void AddOption(CLI::App& app, const std::string& name, const std::string& value,
  const std::string& help, const std::function<void(const std::string& value)>& read);
void AddFlag(CLI::App& app, const std::string& name, bool& flag, const std::string& help);

/// Reads a command line; what is no option goes to `other`. False, and the help is printed, where
/// that was asked for. Throws UsageError.
bool ParseCommandLine(CLI::App& app, int argc, char* argv[],
  const std::function<void(const std::string& argument)>& other);
bool ParseCommandLine(CLI::App& app, const std::vector<std::string>& words,
  const std::function<void(const std::string& argument)>& other);

/// A line below the options, as theirs.
std::string HelpLine(const std::string& name, const std::string& text);

/// Runs a program: 2 and one line on stderr for a UsageError, 1 and one line for another error.
int RunProgram(const char* name, const std::function<int()>& run);
}

#endif
