// SPDX-License-Identifier: BSD-3-Clause
// Tables in Markdown.
#ifndef Markdown_h
#define Markdown_h

#include <string>
#include <vector>

class MarkdownTable
{
public:
  explicit MarkdownTable(std::vector<std::string> header);
  void Add(std::vector<std::string> row);
  std::string Text() const;

private:
  std::size_t Columns;
  std::string Lines;
};

/// Numbers with as many digits as are worth reading.
std::string Milliseconds(double value);
std::string Percent(double value);
std::string Times(double value);
std::string Mebibytes(double bytes);

#endif
