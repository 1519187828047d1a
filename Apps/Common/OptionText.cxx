// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionText.h"

#include "MeshFile.h"
#include "TextNumbers.h"

#include <algorithm>
#include <climits>
#include <fstream>
#include <sstream>

namespace stipple
{
namespace
{
/// Number of insertions, deletions, replacements and swaps of neighbours between two words.
int editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
  {
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] =
        std::min({ d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1]) });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

std::vector<std::string> parted(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

/// Appends the numbers of one row; false if they are none, or not as many as there are columns.
bool parseRow(
  const Option& option, const std::vector<std::string>& words, std::vector<double>& values)
{
  bool good = words.size() == option.columns.size();
  for (std::size_t i = 0; good && i < words.size(); ++i)
  {
    values.push_back(0);
    good = parseNumber(words[i], values.back());
  }
  return good;
}

/// "0:1,0.5:0.2,1:1", or one row with commas.
std::string parseRows(const Option& option, const std::string& text, OptionValues& values)
{
  std::vector<std::string> names;
  for (const Option::Column& column : option.columns)
  {
    names.push_back(column.name);
  }
  std::vector<double> numbers;
  const std::vector<std::string> items =
    option.oneRow ? std::vector<std::string>{ text } : parted(text, ',');
  for (const std::string& item : items)
  {
    if (!parseRow(option, parted(item, option.oneRow ? ',' : ':'), numbers))
    {
      return "needs " + option.argument + ", but '" + item + "' is no " +
        listed(names, option.oneRow ? "," : ":");
    }
  }
  if (!option.oneRow && items.size() < 2)
  {
    return "needs at least two points " + option.argument;
  }
  const std::string wrong = option.wrongRows(numbers);
  values.setList(option.name, std::move(numbers));
  return wrong.empty() ? "" : "needs " + wrong;
}

std::string didYouMean(const std::string& typed, const std::vector<std::string>& words)
{
  const std::string near = nearestWord(typed, words);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}
}

std::string parseOption(const Option& option, const std::string& text, OptionValues& values)
{
  using Kind = Option::Kind;
  const std::string quoted = ", not '" + text + "'";
  double number = 1;
  int whole = 0;
  switch (option.kind)
  {
    case Kind::Flag:
      break;
    case Kind::Integer:
    case Kind::Number:
      if (text == option.automaticWord && !text.empty())
      {
        number = 0;
        break;
      }
      // A whole number is written as one: no point, no exponent.
      if (!parseNumber(text, number) || !option.allows(number) ||
        (option.kind == Kind::Integer && !parseInteger(text, INT_MIN, INT_MAX, whole)))
      {
        return "needs " + option.wanted() + quoted;
      }
      break;
    case Kind::Choice:
      values.set(option.name, text);
      return std::find(option.choices.begin(), option.choices.end(), text) != option.choices.end()
        ? ""
        : "is one of " + listed(option.choices, ", ") + quoted + didYouMean(text, option.choices);
    case Kind::Rows:
      if (!option.fromFile)
      {
        return parseRows(option, text, values);
      }
      [[fallthrough]];
    case Kind::Text:
    case Kind::File:
      values.set(option.name, text);
      return text.empty() ? (option.kind == Kind::Text ? "needs a name" : "needs a file name") : "";
  }
  values.set(option.name, number);
  return "";
}

Status readRows(const Option& option, const std::string& file, std::vector<double>& values)
{
  std::ifstream stream(file);
  if (!stream)
  {
    return Status::error("cannot read '" + file + "'");
  }
  values.clear();
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
  {
    std::istringstream text(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; text >> word;)
    {
      words.push_back(word);
    }
    std::vector<double> row;
    const bool good = words.empty() || parseRow(option, words, row);
    const std::string wrong = option.wrongRows(good ? row : std::vector<double>{ 0 });
    if (!wrong.empty())
    {
      return Status::error(file + ":" + std::to_string(number) + ": needs " + wrong);
    }
    values.insert(values.end(), row.begin(), row.end());
  }
  return stream.bad() ? Status::error("cannot read '" + file + "'") : Status::success();
}

Option programOption(Option::Group group, Option::Kind kind, const char* name, const char* argument,
  const char* help, const std::vector<std::string>& endings)
{
  Option option;
  option.kind = kind;
  option.group = group;
  option.name = name;
  option.argument = argument;
  option.help = help;
  option.endings = endings;
  option.initial = std::string();
  option.places = Option::CommandLine;
  return option;
}

Arguments parseArguments(const std::vector<std::string>& arguments,
  const std::vector<Option>& table, const std::string& usage, const InputRule& rule)
{
  Arguments result;
  const auto complainIf = [&result](bool wrong, const std::string& sentence) {
    result.problem = wrong && result.problem.empty() ? sentence : result.problem;
  };
  bool onlyFiles = false; // after "--"
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (onlyFiles || argument.size() < 2 || argument[0] != '-')
    {
      complainIf(result.options.has("model"),
        "two input files, '" + result.options.text("model") + "' and '" + argument + "'");
      result.options.set("model", argument);
      continue;
    }
    if (argument == "--")
    {
      onlyFiles = true;
      continue;
    }
    const bool isShort = argument.compare(0, 2, "-o") == 0; // -oFILE, -o=FILE
    const std::size_t equals = isShort    ? (argument.size() > 2 ? 2 : std::string::npos)
      : argument.compare(0, 2, "--") == 0 ? argument.find('=')
                                          : std::string::npos;
    const bool hasValue = equals != std::string::npos;
    const std::string typed = argument.substr(0, equals);
    const std::string name = typed == "-o" ? "--output" : (typed == "-h" ? "--help" : typed);
    if (name == "--help" || name == "--version")
    {
      result.asked = name.substr(2) + argument.substr(typed.size());
      return result;
    }
    std::vector<std::string> names;
    for (const Option& option : table)
    {
      names.push_back(option.flag());
    }
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
    {
      const std::string near = didYouMean(name, names);
      complainIf(
        true, "unknown option '" + name + "'" + (near.empty() ? "; --help lists them all" : near));
      continue;
    }
    const Option& option = table[found - names.begin()];
    const bool isFlag = option.kind == Option::Kind::Flag;
    complainIf(isFlag && hasValue, typed + " takes no value");
    if (!isFlag && !hasValue && i + 1 == arguments.size())
    {
      complainIf(true, typed + " needs " + option.argument);
      break;
    }
    const std::string value = hasValue ? argument.substr(equals + (argument[equals] == '='))
                                       : (isFlag ? std::string() : arguments[++i]);
    const std::string wrong = parseOption(option, value, result.options);
    complainIf(!wrong.empty(), typed + " " + wrong);
    result.inOrder.emplace_back(option.name, value);
  }
  complainIf(!rule.mayBeMissing && !result.options.has("model") && !result.options.has("session"),
    "no input file; usage: " + usage);
  const auto checkEnding = [&](const std::string& name, const std::string& called,
                             const std::vector<std::string>& endings) {
    const std::string& file = result.options.text(name);
    complainIf(result.options.has(name) && !endings.empty() &&
        std::find(endings.begin(), endings.end(), fileExtension(file)) == endings.end(),
      called + " '" + file + "' must end in " + listed(endings, ", "));
  };
  checkEnding("model", "the input", rule.endings.empty() ? meshFileExtensions() : rule.endings);
  for (const Option& option : table)
  {
    checkEnding(
      option.name, option.name == "output" ? "the output" : option.flag(), option.endings);
  }
  return result;
}

std::string nearestWord(const std::string& typed, const std::vector<std::string>& words)
{
  std::string best;
  int bestDistance = std::max<int>(2, static_cast<int>(typed.size()) / 3) + 1;
  for (const std::string& word : words)
  {
    const bool beginning = typed.size() >= 4 && word.compare(0, typed.size(), typed) == 0;
    const int distance = beginning ? 1 : editDistance(typed, word);
    if (distance < bestDistance)
    {
      bestDistance = distance;
      best = word;
    }
  }
  return best;
}

std::string helpEntry(const std::string& left, const std::string& right)
{
  constexpr std::size_t Indent = 30;
  constexpr std::size_t Width = 90;
  std::string text = "  " + left;
  std::size_t column = text.size();
  const auto newLine = [&] {
    text += "\n" + std::string(Indent, ' ');
    column = Indent;
  };
  if (column + 2 > Indent)
  {
    newLine();
  }
  text += std::string(Indent - column, ' ');
  column = Indent;
  for (const std::string& word : parted(right, ' '))
  {
    if (column > Indent && column + 1 + word.size() > Width)
    {
      newLine();
    }
    text += (column > Indent ? " " : "") + word;
    column += (column > Indent ? 1 : 0) + word.size();
  }
  return text + "\n";
}

std::string optionNames(const Option& option)
{
  return (option.name == "output" ? "-o, " : "") + option.flag();
}

std::pair<std::string, std::string> optionEntry(const Option& option)
{
  std::string columns;
  for (const Option::Column& column : option.columns)
  {
    columns += (columns.empty() ? "; " : " ") + column.name;
  }
  const std::string range = option.range();
  const std::string initial = option.initialText();
  const bool words = option.kind == Option::Kind::Choice;
  return { optionNames(option) + (option.argument.empty() ? "" : " " + option.argument),
    (words ? range + ": " : "") + option.help + (option.fromFile ? columns + " a line" : "") +
      (words || range.empty() ? "" : "; " + range) +
      (initial.empty() ? "" : " (default: " + initial + ")") };
}
}
