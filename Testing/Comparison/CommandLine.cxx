// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCommandLine.h"

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

const CommandLineOption& Find(
  const std::vector<CommandLineOption>& options, const std::string& name)
{
  for (const CommandLineOption& option : options)
  {
    if (name == option.Name)
    {
      return option;
    }
  }
  throw UsageError(name + ": there is no such option; --help tells all");
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

void ParseCommandLine(int argc, char* argv[], const std::vector<CommandLineOption>& options,
  const std::function<void(const std::string& argument)>& other)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.empty() || argument[0] != '-')
    {
      other(argument);
      continue;
    }
    const size_t equals = argument.find('=');
    const CommandLineOption& option = Find(options, argument.substr(0, equals));
    const bool needsValue = option.Value[0] != '\0';
    if (!needsValue && equals != std::string::npos)
    {
      throw UsageError(std::string(option.Name) + ": no value belongs to it");
    }
    std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
    if (needsValue && equals == std::string::npos && i + 1 < argc)
    {
      value = argv[++i];
    }
    if (needsValue && value.empty())
    {
      throw UsageError(std::string(option.Name) + ": " + option.Value + " is missing");
    }
    option.Read(value);
  }
}

std::string HelpLine(const std::string& left, const std::string& text)
{
  constexpr size_t column = 24;
  std::string lines, start = left;
  for (const std::string& line : Split(text, '\n'))
  {
    lines +=
      start + std::string(column > start.size() ? column - start.size() : 1, ' ') + line + "\n";
    start.clear();
  }
  return lines;
}

std::string OptionsHelp(const std::vector<CommandLineOption>& options)
{
  std::string text;
  for (const CommandLineOption& option : options)
  {
    text += HelpLine(std::string("  ") + option.Name + " " + option.Value, option.Help);
  }
  return text;
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
