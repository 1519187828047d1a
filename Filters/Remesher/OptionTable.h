// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// One table of options: the command line, its help, session files, the arguments of the Python
// functions, their stubs and README's table come from it. A new option is one row.
#ifndef stipple_OptionTable_h
#define stipple_OptionTable_h

#include "StippleFiltersRemesherModule.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

class vtkAlgorithm;
class vtkPiecewiseFunction;

namespace stipple
{
/// A number, a word (text, a file's name), or rows of numbers, one behind the other.
using OptionValue = std::variant<double, std::string, std::vector<double>>;

struct STIPPLEFILTERSREMESHER_EXPORT Option
{
  enum class Kind
  {
    Flag,
    Integer,
    Number,
    Choice, ///< a word; the filter's enum has its index
    Text,
    File,
    Rows ///< of numbers
  };
  enum class Group
  {
    Sampling,
    Features,
    Mesh,
    Files,
    General
  };
  enum Place
  {
    CommandLine = 1,
    Session = 2,
    Python = 4
  };
  struct Column
  {
    std::string name;
    double low;
    double high;
    bool whole; ///< numbers only
  };

  Kind kind;
  Group group;
  std::string name;     ///< in sessions and Python: "feature_angle"; "--feature-angle" else
  std::string argument; ///< what stands for the value in help; empty for a flag
  std::string help;     ///< what it means; unit, range and default are added
  std::string unit;
  double low = 0; ///< of an Integer or Number
  double high = 0;
  OptionValue initial;              ///< the default
  std::string automatic;            ///< what 0, outside the range, stands for; empty: nothing
  std::string automaticWord;        ///< says so in place of 0
  std::vector<std::string> choices; ///< of a Choice
  std::vector<std::string> endings; ///< that a File may have, with their dots; empty: any
  std::vector<Column> columns;      ///< of Rows
  bool oneRow = false;              ///< of Rows: not a list of rows, but one
  bool fromFile = false;            ///< of Rows: the command line names a file, a row a line
  int places = CommandLine | Session | Python;
  std::string stage;    ///< the class of the stage that obeys it; empty: not a filter's
  std::string property; ///< the stage's: SetProperty()
  /// Hands a value to the stage, and modifies it if that is another.
  std::function<void(vtkAlgorithm* stage, const Option&, const OptionValue&)> apply;
  /// What is wrong with a row, in words after "needs"; `before` is null for the first. May be
  /// empty.
  std::function<std::string(const double* row, const double* before)> check;

  bool in(Place place) const { return (this->places & place) != 0; }
  std::string flag() const; ///< "--feature-angle"
  /// "0 to 180 degrees", "uniform, mean or array", ...; empty if anything goes.
  std::string range() const;
  /// "40", "auto", ...; empty if there is none.
  std::string initialText() const;
  /// Whether a number is within the range.
  bool allows(double value) const;
  /// "a number from 0 to 180", "auto or a whole number from 16 to 16384"
  std::string wanted() const;
  /// What is wrong with rows of numbers, in words after "needs"; or nothing.
  std::string wrongRows(const std::vector<double>& values) const;
};

/// The table. Rows may be added before it is used.
STIPPLEFILTERSREMESHER_EXPORT std::vector<Option>& optionTable();

/// A row, or null.
STIPPLEFILTERSREMESHER_EXPORT const Option* findOption(const std::string& name);

/// "sampling", "features", ...
STIPPLEFILTERSREMESHER_EXPORT const char* groupName(Option::Group group);

/// A curve as rows of the option transfer: the nodes' places and values, one behind the other. None
/// of null.
STIPPLEFILTERSREMESHER_EXPORT std::vector<double> nodesOf(vtkPiecewiseFunction* function);

/// The table as text for other languages: names of fields, then a row a line, between tabs; lists
/// are parted by bars.
STIPPLEFILTERSREMESHER_EXPORT std::string optionTableText();

/// "a, b or c"
STIPPLEFILTERSREMESHER_EXPORT std::string listed(
  const std::vector<std::string>& words, const std::string& last = " or ");

/// Values of options by their names: a plain value. What was not set is as the table has it.
class STIPPLEFILTERSREMESHER_EXPORT OptionValues
{
public:
  bool has(const std::string& name) const { return this->Values.count(name) > 0; }
  void set(const std::string& name, double value) { this->Values[name] = value; }
  void set(const std::string& name, const std::string& value) { this->Values[name] = value; }
  void setList(const std::string& name, std::vector<double> value)
  {
    this->Values[name] = std::move(value);
  }
  void reset(const std::string& name) { this->Values.erase(name); }
  /// As the others have it, where they have it.
  void setAll(const OptionValues& others);

  const OptionValue& at(const std::string& name) const;
  double number(const std::string& name) const;
  int integer(const std::string& name) const { return static_cast<int>(this->number(name)); }
  bool flag(const std::string& name) const { return this->number(name) != 0; }
  const std::string& text(const std::string& name) const;
  const std::vector<double>& list(const std::string& name) const;

  /// Rows of N numbers.
  template <std::size_t N>
  std::vector<std::array<double, N>> rows(const std::string& name) const
  {
    const std::vector<double>& numbers = this->list(name);
    std::vector<std::array<double, N>> rows(numbers.size() / N);
    for (std::size_t i = 0; i < rows.size() * N; ++i)
    {
      rows[i / N][i % N] = numbers[i];
    }
    return rows;
  }
  template <std::size_t N>
  void setRows(const std::string& name, const std::vector<std::array<double, N>>& rows)
  {
    std::vector<double> numbers;
    for (const auto& row : rows)
    {
      numbers.insert(numbers.end(), row.begin(), row.end());
    }
    this->setList(name, std::move(numbers));
  }

  /// An option that was set to its default equals one that was not set.
  bool operator==(const OptionValues& o) const;
  bool operator!=(const OptionValues& o) const { return !(*this == o); }

  const std::map<std::string, OptionValue>& given() const { return this->Values; }

private:
  std::map<std::string, OptionValue> Values;
};

/// Hands to a stage, or to all stages of a vtkGeometryRemesher, what a session has, and what was
/// set besides. A parameter that does not change does not modify its stage.
STIPPLEFILTERSREMESHER_EXPORT void applyOptions(const OptionValues& values, vtkAlgorithm* to);

/// Whether all that a stage obeys is the same.
STIPPLEFILTERSREMESHER_EXPORT bool sameForStage(
  const OptionValues& a, const OptionValues& b, const std::string& stage);
}

#endif
