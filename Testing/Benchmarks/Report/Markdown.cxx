// SPDX-License-Identifier: BSD-3-Clause
#include "Markdown.h"

#include <cstdio>

namespace
{
std::string Row(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (const std::string& cell : cells)
  {
    line += " " + cell + " |";
  }
  return line + "\n";
}

std::string Print(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}
}

MarkdownTable::MarkdownTable(std::vector<std::string> header)
  : Columns(header.size())
  , Lines(Row(header) + "|---|")
{
  for (std::size_t i = 1; i < this->Columns; ++i)
  {
    this->Lines += "---:|";
  }
  this->Lines += "\n";
}

void MarkdownTable::Add(std::vector<std::string> row)
{
  row.resize(this->Columns);
  this->Lines += Row(row);
}

std::string MarkdownTable::Text() const
{
  return this->Lines + "\n";
}

std::string Milliseconds(double value)
{
  return Print(value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : value >= 1 ? "%.2f" : "%.3f", value);
}

std::string Percent(double value)
{
  return Print(value >= 10 ? "%.1f" : value >= 1 ? "%.2f" : "%.3f", value);
}

std::string Times(double value)
{
  return Print("%.2f", value);
}

std::string Mebibytes(double bytes)
{
  return Print("%.1f", bytes / 1048576);
}
