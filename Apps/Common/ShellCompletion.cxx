// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Completions of shells, as ProgramText.h declares them.
#include "MeshFile.h"
#include "ProgramText.h"
#include "Text.h"

#include <algorithm>

namespace stipple
{
namespace
{
using Kind = Option::Kind;

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (&word == words.data() ? "" : separator) + word;
  }
  return text;
}

/// "stipple_view": part of the names of functions.
std::string identifier(std::string name)
{
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// What can be typed for an option.
std::vector<std::string> flags(const Option& option)
{
  return option.name == "output" ? std::vector<std::string>{ "-o", "--output" }
    : option.name == "help"      ? std::vector<std::string>{ "-h", "--help" }
                                 : std::vector<std::string>{ option.flag() };
}

bool isFile(const Option& option)
{
  return option.kind == Kind::File || option.fromFile;
}

bool isFolder(const Option& option)
{
  return isFile(option) && option.argument == "DIR";
}

/// Words that a value can be.
std::vector<std::string> words(const Option& option)
{
  return option.automaticWord.empty() ? option.choices
                                      : std::vector<std::string>{ option.automaticWord };
}

/// Endings of files, also in capitals.
std::vector<std::string> bothCases(const std::vector<std::string>& endings)
{
  std::vector<std::string> both;
  for (const std::string& ending : endings)
  {
    both.insert(both.end(), { ending, upperCase(ending) });
  }
  return both;
}

/// Text within single quotes, for zsh's _arguments: nothing in it parts or ends it.
std::string zshText(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '\''
      ? "'\\''"
      : (std::string("[]:\\").find(c) != std::string::npos ? "\\" : "") + std::string(1, c);
  }
  return escaped;
}

std::string zshFiles(const std::vector<std::string>& endings)
{
  return endings.empty() ? "_files" : "_files -g \"*(" + joined(bothCases(endings), "|") + ")\"";
}

std::string zshOption(const Option& option)
{
  const std::vector<std::string> typed = flags(option);
  std::string value;
  if (option.kind != Kind::Flag)
  {
    value = ":" + zshText(option.argument) + ":" +
      (isFolder(option)           ? "_files -/"
          : isFile(option)        ? zshFiles(option.endings)
          : words(option).empty() ? " "
                                  : "(" + joined(words(option), " ") + ")");
  }
  std::string names = typed.size() > 1 ? "'(" + joined(typed, " ") + ")'{" : "'";
  for (const std::string& name : typed)
  {
    const bool isLong = name.compare(0, 2, "--") == 0;
    names += (&name == typed.data() ? "" : ",") + name +
      (option.kind == Kind::Flag ? "" : (isLong ? "=" : "+"));
  }
  return "    " + names + (typed.size() > 1 ? "}'" : "") + "[" + zshText(option.help) + "]" +
    value + "' \\\n";
}
}

std::string bashCompletion(const ProgramDescription& program)
{
  const std::string function = "_" + identifier(program.name);
  std::string cases;
  std::vector<std::string> all;
  std::vector<std::string> free; // their values can't be foretold
  for (const ProgramDescription::Group& group : program.groups)
  {
    for (const Option& option : group.options)
    {
      const std::vector<std::string> typed = flags(option);
      all.insert(all.end(), typed.begin(), typed.end());
      if (option.kind == Kind::Flag)
      {
        continue;
      }
      if (!isFile(option) && words(option).empty())
      {
        free.insert(free.end(), typed.begin(), typed.end());
        continue;
      }
      cases += "    " + joined(typed, " | ") + ") ";
      cases += isFolder(option) ? function + "_files /"
        : isFile(option)
        ? function + "_files " + joined(bothCases(option.endings), " ")
        : "COMPREPLY=($(compgen -W '" + joined(words(option), " ") + "' -- \"$cur\"))";
      cases += "; return ;;\n";
    }
  }
  // bash parts words at "=".
  return "# Completion of " + program.name + " for bash; made by " + program.name +
    " --help=bash.\n" + function +
    "_files() # ENDING...: such files and folders; none: all; /: "
    "folders\n{\n"
    "  local ending\n"
    "  compopt -o filenames 2>/dev/null\n"
    "  if [[ $# -eq 0 ]]; then\n"
    "    mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")\n"
    "    return\n"
    "  fi\n"
    "  mapfile -t COMPREPLY < <(\n"
    "    compgen -d -- \"$cur\"\n"
    "    for ending; do\n"
    "      [[ $ending = / ]] || compgen -f -X \"!*$ending\" -- \"$cur\"\n"
    "    done\n"
    "  )\n"
    "}\n\n" +
    function +
    "()\n{\n"
    "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]}\n"
    "  COMPREPLY=()\n"
    "  if [[ $cur = '=' ]]; then\n"
    "    cur=\n"
    "  elif [[ $prev = '=' ]]; then\n"
    "    prev=${COMP_WORDS[COMP_CWORD-2]}\n"
    "  fi\n"
    "  case $prev in\n" +
    cases + "    " + joined(free, " | ") + ") return ;;\n" +
    "  esac\n"
    "  if [[ $cur = -* ]]; then\n"
    "    COMPREPLY=($(compgen -W '" +
    joined(all, " ") +
    "' -- \"$cur\"))\n"
    "    return\n"
    "  fi\n"
    "  " +
    function + "_files " + joined(bothCases(meshFileExtensions()), " ") + "\n}\ncomplete -F " +
    function + " " + program.name + "\n";
}

std::string zshCompletion(const ProgramDescription& program)
{
  std::string text = "#compdef " + program.name + "\n# Made by " + program.name +
    " --help=zsh.\n_" + identifier(program.name) + "() {\n  _arguments -S \\\n";
  for (const ProgramDescription::Group& group : program.groups)
  {
    for (const Option& option : group.options)
    {
      text += zshOption(option);
    }
  }
  return text + "    ':input:" + zshFiles(meshFileExtensions()) + "'\n}\n\n_" +
    identifier(program.name) + " \"$@\"\n";
}
}
