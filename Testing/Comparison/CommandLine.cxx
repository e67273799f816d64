// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCommandLine.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace rtw
{
namespace
{
std::optional<int> ToWhole(const std::string& text, int least, int most)
{
  const std::optional<double> value = ToNumber(text);
  const bool fits = value && *value >= least && *value <= most && *value == std::floor(*value);
  return fits ? std::optional<int>(int(*value)) : std::nullopt;
}
}

void Refuse(const std::string& option, const std::string& value, const std::string& expected)
{
  throw UsageError(option + " " + value + ": expected " + expected);
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

std::string Join(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

std::optional<double> ToNumber(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isAll = !text.empty() && *end == '\0' && std::isfinite(value);
  return isAll ? std::optional<double>(value) : std::nullopt;
}

std::vector<double> ToNumbers(const std::string& text, size_t count)
{
  std::vector<double> numbers;
  for (const std::string& part : Split(text, ','))
  {
    const std::optional<double> number = ToNumber(part);
    if (!number)
    {
      return {};
    }
    numbers.push_back(*number);
  }
  return numbers.size() == count ? numbers : std::vector<double>();
}

int ReadWhole(const std::string& option, const std::string& text, int least, int most)
{
  const std::optional<int> value = ToWhole(text, least, most);
  if (!value)
  {
    Refuse(
      option, text, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return *value;
}

double ReadNumber(const std::string& option, const std::string& text, double least, double most)
{
  const std::optional<double> value = ToNumber(text);
  if (!value || *value < least || *value > most)
  {
    std::ostringstream expected;
    expected << "a number from " << least << " to " << most;
    Refuse(option, text, expected.str());
  }
  return *value;
}

std::vector<int> ReadWholes(const std::string& option, const std::string& text, int least, int most)
{
  std::vector<int> values;
  for (const std::string& part : Split(text, ','))
  {
    values.push_back(ReadWhole(option, part, least, most));
  }
  return values;
}

std::pair<int, int> ReadSize(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = Split(text, 'x');
  const auto width = ToWhole(parts.front(), 16, 16384), height = ToWhole(parts.back(), 16, 16384);
  if (parts.size() != 2 || !width || !height)
  {
    Refuse(option, text, "WIDTHxHEIGHT, each from 16 to 16384");
  }
  return { *width, *height };
}

std::vector<std::string> ReadNames(
  const std::string& option, const std::string& text, const std::vector<std::string>& known)
{
  const std::vector<std::string> names = Split(text, ',');
  for (const std::string& name : names)
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      Refuse(option, text, "some of " + Join(known));
    }
  }
  return names;
}

void AddOption(CLI::App& app, const std::string& name, const std::string& value,
  const std::string& help, const std::function<void(const std::string& value)>& read)
{
  app.add_option_function<std::string>(name, read, help)
    ->type_name(value)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void AddFlag(CLI::App& app, const std::string& name, bool& flag, const std::string& help)
{
  app.add_flag(name, flag, help)->disable_flag_override();
}

bool ParseCommandLine(CLI::App& app, const std::vector<std::string>& words,
  const std::function<void(const std::string& argument)>& other)
{
  app.set_help_flag("--help", "print this");
  app.allow_extras();
  try
  {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  }
  catch (const CLI::CallForHelp&)
  {
    std::fputs(app.help().c_str(), stdout);
    return false;
  }
  catch (const CLI::ParseError& error)
  {
    throw UsageError(error.what());
  }
  for (const std::string& word : app.remaining())
  {
    if (word.size() > 1 && word[0] == '-')
    {
      throw UsageError(word + ": there is no such option; --help tells all");
    }
    other(word);
  }
  return true;
}

bool ParseCommandLine(CLI::App& app, int argc, char* argv[],
  const std::function<void(const std::string& argument)>& other)
{
  return ParseCommandLine(app, std::vector<std::string>(argv + 1, argv + argc), other);
}

std::string HelpLine(const std::string& name, const std::string& text)
{
  constexpr std::size_t column = 30; // as CLI11 has it
  const std::string start = "  " + name;
  return start + std::string(column > start.size() ? column - start.size() : 1, ' ') + text + "\n";
}

int RunProgram(const char* name, const std::function<int()>& run)
{
  try
  {
    return run();
  }
  catch (const UsageError& error)
  {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}
}
