// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramText.h"

#include "OptionText.h"
#include "Text.h"

namespace stipple
{
namespace
{
/// Text as man(7) takes it: nothing in it is a request or an escape, and a hyphen can be copied.
std::string roff(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return escaped.empty() || (escaped[0] != '.' && escaped[0] != '\'') ? escaped : "\\&" + escaped;
}

/// An argument of a request.
std::string quoted(const std::string& text)
{
  std::string escaped;
  for (const char c : roff(text))
  {
    escaped += c == '"' ? "\\(dq" : std::string(1, c);
  }
  return '"' + escaped + '"';
}

}

Status tellAbout(const ProgramDescription& program, const std::string& asked, std::string& text)
{
  if (asked == "help")
  {
    text = helpText(program);
  }
  else if (asked == "help=man")
  {
    text = manualPage(program);
  }
  else if (asked == "help=bash")
  {
    text = bashCompletion(program);
  }
  else if (asked == "help=zsh")
  {
    text = zshCompletion(program);
  }
  else
  {
    return Status::error("--help takes man, bash or zsh, not '" +
      asked.substr(std::min(asked.size(), asked.find('=') + 1)) + "'");
  }
  return Status::success();
}

std::string helpText(const ProgramDescription& program)
{
  std::string text = "usage: " + program.name + " " + program.arguments + "\n\n" + program.text;
  for (const ProgramDescription::Group& group : program.groups)
  {
    text += "\n" + (group.title.empty() ? "" : group.title + ":\n");
    for (const Option& option : group.options)
    {
      const auto entry = optionEntry(option);
      text += helpEntry(entry.first, entry.second);
    }
  }
  if (!program.keys.empty())
  {
    text += "\n" + program.keysTitle + ":\n";
  }
  for (const auto& key : program.keys)
  {
    text += helpEntry(key.first, key.second);
  }
  return text + "\nExit status: " + program.exitStatus;
}

std::string manualPage(const ProgramDescription& program)
{
  std::string page = "."
                     R"(\" Made by )" +
    program.name + " --help=man.\n.TH " + quoted(upperCase(program.name)) + R"( 1 "" )" +
    quoted(program.name + " " + program.version) + " \"User Commands\"\n.SH NAME\n" + program.name +
    R"( \- )" + roff(program.brief) + "\n.SH SYNOPSIS\n.B " + roff(program.name) + "\n" +
    roff(program.arguments) + "\n.SH DESCRIPTION\n" + roff(program.text) + ".SH OPTIONS\n";
  for (const ProgramDescription::Group& group : program.groups)
  {
    page += group.title.empty() ? "" : ".SS " + quoted(group.title) + "\n";
    for (const Option& option : group.options)
    {
      const auto entry = optionEntry(option);
      page += ".TP\n\\fB" + roff(optionNames(option)) + "\\fR" +
        (option.argument.empty() ? "" : " \\fI" + roff(option.argument) + "\\fR") + "\n" +
        roff(entry.second) + "\n";
    }
  }
  if (!program.keys.empty())
  {
    page += ".SH " + quoted(upperCase(program.keysTitle)) + "\n";
  }
  for (const auto& key : program.keys)
  {
    page += ".TP\n\\fB" + roff(key.first) + "\\fR\n" + roff(key.second) + "\n";
  }
  page += ".SH \"EXIT STATUS\"\n" + roff(program.exitStatus);
  if (!program.examples.empty())
  {
    page += ".SH EXAMPLES\n";
  }
  for (const auto& example : program.examples)
  {
    page += ".TP\n\\fB" + roff(example.first) + "\\fR\n" + roff(example.second) + "\n";
  }
  if (!program.seeAlso.empty())
  {
    page += ".SH \"SEE ALSO\"\n";
  }
  for (const std::string& other : program.seeAlso)
  {
    page += ".BR " + roff(other) + " (1)" + (&other == &program.seeAlso.back() ? "\n" : ",\n");
  }
  return page;
}
}
