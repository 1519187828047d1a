// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ServerManagerXml.h"

#include "BlockOptions.h"
#include "OptionTable.h"
#include "TextNumbers.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace stipple
{
namespace
{
using Element = vtkSmartPointer<vtkXMLDataElement>;
using Attributes = std::vector<std::pair<std::string, std::string>>;

constexpr double LongestSlider = 1000; // beyond, a slider's steps are too coarse to be of use

Element element(const std::string& name, const Attributes& attributes = {})
{
  auto made = Element::New();
  made->SetName(name.c_str());
  for (const auto& [key, value] : attributes)
  {
    made->SetAttribute(key.c_str(), value.c_str());
  }
  return made;
}

std::string attribute(vtkXMLDataElement* of, const char* name)
{
  const char* value = of->GetAttribute(name);
  return value ? value : "";
}

/// "feature_angle" to "FeatureAngle".
std::string camelCase(const std::string& name)
{
  std::string text;
  bool begins = true;
  for (const char c : name)
  {
    text += begins && c != '_' ? static_cast<char>(std::toupper(c)) : c;
    begins = c == '_';
  }
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  return text;
}

/// Whether ParaView has it: what is of the mesh, and has a setter. Files come by input ports.
bool isOffered(const Option& option)
{
  return option.apply && option.in(Option::Session);
}

std::string propertyOf(const Option& option)
{
  const std::vector<Option>& table = optionTable();
  const auto* first = &*std::find_if(table.begin(), table.end(),
    [&option](const Option& other) { return other.property == option.property; });
  return option.kind == Option::Kind::Text || first->name != option.name ? camelCase(option.name)
                                                                         : option.property;
}

std::string documentationOf(const Option& option)
{
  std::string text = option.help;
  text[0] = static_cast<char>(std::toupper(text[0]));
  std::string columns;
  for (const Option::Column& column : option.columns)
  {
    columns += (columns.empty() ? "" : ", ") + column.name;
  }
  text += columns.empty() || option.oneRow ? "" : ". Each row: " + columns;
  text += option.range().empty() ? "" : ". Range: " + option.range();
  text += option.automatic.empty() ? "" : "; 0: " + option.automatic;
  const std::string initial = option.initialText();
  text += initial.empty() ? "" : ". Default: " + (initial == option.automatic ? "0" : initial);
  return text + ". (" + option.flag() + ")";
}

/// A choice's index in the table, which may have more of them than the proxy.
std::string indexOf(const Option& option, const std::string& choice)
{
  const std::vector<std::string>& words = findOption(option.name)->choices;
  return std::to_string(std::find(words.begin(), words.end(), choice) - words.begin());
}

void addDomain(const Option& option, vtkXMLDataElement* place, vtkXMLDataElement* property)
{
  using Kind = Option::Kind;
  if (option.kind == Kind::Flag)
  {
    property->AddNestedElement(element("BooleanDomain", { { "name", "bool" } }));
  }
  else if (option.kind == Kind::Choice)
  {
    Element domain = element("EnumerationDomain", { { "name", "enum" } });
    for (std::size_t i = 0; i < option.choices.size(); ++i)
    {
      domain->AddNestedElement(element("Entry",
        { { "text", option.choices[i] }, { "value", indexOf(option, option.choices[i]) } }));
    }
    property->AddNestedElement(domain);
  }
  else if (option.kind == Kind::Integer || option.kind == Kind::Number)
  {
    // 0 stands for what is automatic, also where the range begins above.
    const bool fromZero = !option.automatic.empty() || option.low < 1e-300;
    Element domain = element(option.kind == Kind::Integer ? "IntRangeDomain" : "DoubleRangeDomain",
      { { "name", "range" } });
    domain->SetAttribute("min", shortestText(fromZero ? 0. : option.low).c_str());
    const std::string most = attribute(place, "max");
    if (!most.empty() || option.high <= LongestSlider)
    {
      domain->SetAttribute("max", (most.empty() ? shortestText(option.high) : most).c_str());
    }
    property->AddNestedElement(domain);
  }
  else if (const std::string arrays = attribute(place, "arrays"); !arrays.empty())
  {
    Element domain = element("ArrayListDomain",
      { { "name", "array_list" }, { "input_domain_name", arrays }, { "none_string", "None" } });
    Element required = element("RequiredProperties");
    required->AddNestedElement(
      element("Property", { { "name", "Input" }, { "function", "Input" } }));
    domain->AddNestedElement(required);
    property->AddNestedElement(domain);
  }
}

/// A curve with ParaView's editor.
Element transferProperty(const std::string& name)
{
  Element property = element("ProxyProperty",
    { { "name", name }, { "command", "SetTransferFunction" },
      { "panel_widget", "transfer_function_editor" } });
  Element groups = element("ProxyGroupDomain", { { "name", "groups" } });
  groups->AddNestedElement(element("Group", { { "name", "piecewise_functions" } }));
  Element proxies = element("ProxyListDomain", { { "name", "proxy_list" } });
  proxies->AddNestedElement(
    element("Proxy", { { "group", "piecewise_functions" }, { "name", "PiecewiseFunction" } }));
  property->AddNestedElement(groups);
  property->AddNestedElement(proxies);
  return property;
}

/// The property of an option, as `place` wants it; null if a class's setters cannot.
Element propertyFor(const Option& option, vtkXMLDataElement* place, bool byName)
{
  using Kind = Option::Kind;
  const std::string name = propertyOf(option);
  Element property;
  if (option.property == "TransferFunction")
  {
    property = transferProperty(name);
  }
  else if (option.kind == Kind::Rows && !option.oneRow && !byName)
  {
    return nullptr;
  }
  else
  {
    const bool whole = std::all_of(option.columns.begin(), option.columns.end(),
      [](const Option::Column& column) { return column.whole; });
    const bool isInt = option.kind == Kind::Flag || option.kind == Kind::Integer ||
      option.kind == Kind::Choice || (option.kind == Kind::Rows && whole);
    property = element(option.kind == Kind::Text ? "StringVectorProperty"
        : isInt                                  ? "IntVectorProperty"
                                                 : "DoubleVectorProperty",
      { { "name", name } });
    property->SetAttribute("command",
      (!byName                          ? "Set" + option.property
          : option.kind == Kind::Text   ? "SetTextOption"
          : option.kind == Kind::Choice ? "SetChoiceOption"
          : option.kind == Kind::Rows   ? "AddRow"
                                        : "SetNumberOption")
        .c_str());
    if (byName)
    {
      property->SetAttribute("initial_string", option.name.c_str());
    }
    const std::string columns = std::to_string(option.columns.size());
    if (option.kind == Kind::Rows && byName)
    {
      property->SetAttribute("clean_command", "ClearRows");
    }
    if (option.kind == Kind::Rows && !option.oneRow)
    {
      property->SetAttribute("repeat_command", "1");
      property->SetAttribute("number_of_elements_per_command", columns.c_str());
      property->SetAttribute("number_of_elements", "0");
    }
    else
    {
      std::string initial;
      if (const auto* row = std::get_if<std::vector<double>>(&option.initial))
      {
        for (const double value : *row)
        {
          initial += (initial.empty() ? "" : " ") + shortestText(value);
        }
      }
      else if (const auto* number = std::get_if<double>(&option.initial))
      {
        initial = shortestText(*number);
      }
      else if (option.kind == Kind::Choice)
      {
        initial = indexOf(option, std::get<std::string>(option.initial));
      }
      property->SetAttribute("number_of_elements", option.oneRow ? columns.c_str() : "1");
      property->SetAttribute(
        "default_values", option.kind == Kind::Text ? "None" : initial.c_str());
    }
    addDomain(option, place, property);
  }
  for (int i = 0; i < place->GetNumberOfAttributes(); ++i)
  {
    const std::string key = place->GetAttributeName(i);
    if (std::set<std::string>{ "name", "max", "arrays", "group", "class" }.count(key) == 0)
    {
      property->SetAttribute(key.c_str(), place->GetAttributeValue(i));
    }
  }
  Element documentation = element("Documentation");
  const std::string text = documentationOf(option);
  documentation->SetCharacterData(text.c_str(), static_cast<int>(text.size()));
  property->AddNestedElement(documentation);
  for (int i = 0; i < place->GetNumberOfNestedElements(); ++i)
  {
    property->AddNestedElement(place->GetNestedElement(i));
  }
  return property;
}

class ProxyMaker
{
public:
  bool ByName = true;
  std::vector<Option> Table;       ///< what the proxy may have
  std::set<std::string> Mentioned; ///< options that the proxy has by name, or has not

  Status remember(vtkXMLDataElement* of)
  {
    for (int i = 0; i < of->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* child = of->GetNestedElement(i);
      const std::string kind = child->GetName();
      const std::string name = attribute(child, kind == "Without" ? "option" : "name");
      if (kind == "Option" || kind == "Without")
      {
        const Option* option = this->find(name);
        if (!option || !isOffered(*option))
        {
          return Status::error("the template names an option '" + name + "' that there is not");
        }
        this->Mentioned.insert(name);
      }
      else if (Status status = this->remember(child); !status.ok())
      {
        return status;
      }
    }
    return Status::success();
  }

  /// What stands for the children of a proxy or group.
  std::vector<Element> made(vtkXMLDataElement* of)
  {
    std::vector<Element> all;
    for (int i = 0; i < of->GetNumberOfNestedElements(); ++i)
    {
      Element child = of->GetNestedElement(i);
      const std::string kind = child->GetName();
      if (kind == "Option")
      {
        all.push_back(propertyFor(*this->find(attribute(child, "name")), child, this->ByName));
      }
      else if (kind == "Rest" || kind == "Stage")
      {
        this->addRest(child, all);
      }
      else if (kind == "Group")
      {
        this->addGroup(child, all);
      }
      else if (kind != "Without")
      {
        all.push_back(child);
      }
    }
    return all;
  }

private:
  const Option* find(const std::string& name) const
  {
    const auto found = std::find_if(this->Table.begin(), this->Table.end(),
      [&name](const Option& option) { return option.name == name; });
    return found == this->Table.end() ? nullptr : &*found;
  }

  void addRest(vtkXMLDataElement* place, std::vector<Element>& all)
  {
    for (const Option& option : this->Table)
    {
      if (!isOffered(option) || this->Mentioned.count(option.name) > 0 ||
        (attribute(place, "group") != groupName(option.group) &&
          (option.stage.empty() || attribute(place, "class") != option.stage)))
      {
        continue;
      }
      if (Element property = propertyFor(option, place, this->ByName))
      {
        property->SetAttribute("panel_visibility", "advanced");
        all.push_back(property);
      }
    }
  }

  void addGroup(vtkXMLDataElement* place, std::vector<Element>& all)
  {
    Element group = element("PropertyGroup");
    for (int i = 0; i < place->GetNumberOfAttributes(); ++i)
    {
      group->SetAttribute(place->GetAttributeName(i), place->GetAttributeValue(i));
    }
    for (const Element& child : this->made(place))
    {
      all.push_back(child);
      group->AddNestedElement(element("Property", { { "name", attribute(child, "name") } }));
    }
    all.push_back(group);
  }
};
}

Status makeServerManagerXml(vtkXMLDataElement* tree)
{
  for (int i = 0; i < tree->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* child = tree->GetNestedElement(i);
    const std::string options = attribute(child, "options");
    if (options.empty())
    {
      if (Status status = makeServerManagerXml(child); !status.ok())
      {
        return status;
      }
      continue;
    }
    ProxyMaker maker;
    maker.ByName = options != "by setter";
    maker.Table = options == "of blocks" ? blockOptions() : optionTable();
    if (Status status = maker.remember(child); !status.ok())
    {
      return status;
    }
    const std::vector<Element> made = maker.made(child);
    child->RemoveAllNestedElements();
    child->RemoveAttribute("options");
    for (const Element& one : made)
    {
      child->AddNestedElement(one);
    }
  }
  return Status::success();
}
}
