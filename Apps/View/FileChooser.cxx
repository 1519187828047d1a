// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FileChooser.h"

#include "MeshFile.h"
#include "OutputFiles.h"
#include "Text.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace stipple
{
namespace
{
namespace fs = std::filesystem;
constexpr std::size_t MostEntries = 5000;
constexpr std::size_t RecentsFirst = 4; ///< before the folder; all of them pass filters
constexpr float RowHeight = 24;         // pixels at scale 1
}

FileChooser::FileChooser(Wish wish, Chosen chosen, std::function<void()> givenUp)
  : Wanted(std::move(wish))
  , OnChosen(std::move(chosen))
  , OnGivenUp(std::move(givenUp))
{
  std::error_code error;
  fs::path begin = fs::absolute(this->Wanted.begin, error);
  if (this->Wanted.saves)
  {
    this->propose(begin.filename().string());
    begin = begin.parent_path();
  }
  this->enter(begin);
}

void FileChooser::enter(const fs::path& folder)
{
  std::error_code error;
  const fs::directory_iterator opened(folder, error); // for its error
  if (error)
  {
    this->Sentence = "The folder cannot be read: " + error.message() + ".";
    return;
  }
  const fs::path left = this->Folder;
  this->Folder = folder.lexically_normal();
  if (!this->Folder.has_filename()) // but a slash at its end
  {
    this->Folder = this->Folder.parent_path();
  }
  this->Sentence.clear();
  if (!this->Wanted.saves)
  {
    this->Typed.set("");
  }
  this->list();
  const auto below = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&left](const Entry& entry) { return entry.text != "../" && entry.path == left; });
  if (below != this->Entries.end()) // where the way up has come from
  {
    this->Current = static_cast<int>(below - this->Entries.begin());
    this->First = std::max(0, this->Current - 2); // with some before it
  }
}

void FileChooser::propose(const std::string& name)
{
  this->Typed.set(name);
  this->Typed.select(0, name.size() - fileExtension(name).size());
}

bool FileChooser::typesPath() const
{
  return this->Typed.text().find('/') != std::string::npos || this->Typed.text() == "~";
}

fs::path FileChooser::typedPath() const
{
  const char* home = std::getenv("HOME");
  const std::string& typed = this->Typed.text();
  const bool fromHome = typed == "~" || typed.compare(0, 2, "~/") == 0;
  const fs::path path = home && fromHome
    ? fs::path(home) / fs::path(typed.substr(std::min<std::size_t>(2, typed.size())))
    : this->Folder / typed;
  return path.lexically_normal();
}

fs::path FileChooser::listed() const
{
  return !this->Wanted.saves && this->typesPath() ? this->typedPath().parent_path() : this->Folder;
}

void FileChooser::list()
{
  this->Entries.clear();
  this->Current = 0;
  this->First = 0;
  this->Under = -1;
  const bool path = !this->Wanted.saves && this->typesPath();
  const fs::path typed = this->typedPath();
  const fs::path folder = this->listed();
  const std::string filter =
    this->Wanted.saves ? "" : upperCase(path ? typed.filename().string() : this->Typed.text());
  const auto passes = [&filter](const std::string& name) {
    return filter.empty() ? name.compare(0, 1, ".") != 0
                          : upperCase(name).find(filter) != std::string::npos;
  };
  std::error_code error;
  for (fs::directory_iterator i(folder, error), end;
       !error && i != end && this->Entries.size() < MostEntries; i.increment(error))
  {
    std::error_code ignored;
    const std::string name = i->path().filename().string();
    const bool below = i->is_directory(ignored);
    const auto& endings = this->Wanted.endings;
    const bool fits =
      below || std::find(endings.begin(), endings.end(), fileExtension(name)) != endings.end();
    if (fits && passes(name))
    {
      this->Entries.push_back({ below ? name + "/" : name, i->path(), below });
    }
  }
  // What begins as it is typed comes first: Return takes it.
  const auto begins = [&filter](const Entry& entry) {
    return upperCase(entry.text).compare(0, filter.size(), filter) == 0;
  };
  std::sort(this->Entries.begin(), this->Entries.end(), [&begins](const Entry& a, const Entry& b) {
    return std::make_tuple(!begins(a), !a.folder, upperCase(a.text), a.text) <
      std::make_tuple(!begins(b), !b.folder, upperCase(b.text), b.text);
  });
  if (!error && folder.parent_path() != folder && filter.empty())
  {
    this->Entries.insert(this->Entries.begin(), { "../", folder.parent_path(), true });
  }
  // Return is not to lead out of the folder at once.
  this->Current = this->Entries.size() > 1 && this->Entries.front().text == "../" ? 1 : 0;
  // Recent ones come first, or last of what passes.
  if (!this->Wanted.saves && !path)
  {
    std::vector<Entry> recent;
    for (const std::string& file : this->Wanted.recent)
    {
      if (passes(nameOfFile(file)) && (!filter.empty() || recent.size() < RecentsFirst))
      {
        recent.push_back({ "recent: " + file, file, false });
      }
    }
    this->Current = filter.empty() && !recent.empty() ? 0 : this->Current;
    this->Entries.insert(
      filter.empty() ? this->Entries.begin() : this->Entries.end(), recent.begin(), recent.end());
  }
}

void FileChooser::paint(Canvas& canvas, const Rect& window)
{
  const float s = canvas.scale();
  const float width = std::min(680 * s, window.w - 16 * s);
  const float height = std::min(560 * s, window.h - 16 * s);
  const Rect box = canvas.page(window, width, height);
  const float pad = 22 * s;
  const TextLook title{ 15, shades::Word, Align::Left, true };
  const TextLook quiet{ 11.5F, shades::Quiet };
  const float inner = width - 2 * pad;
  canvas.text(box.x + pad, box.top() - 26 * s, this->Wanted.title, title);
  canvas.text(
    box.x + pad, box.top() - 50 * s, canvas.fitted(this->listed().string(), inner, quiet), quiet);
  const Rect field{ box.x + pad, box.top() - 92 * s, inner, 28 * s };
  canvas.box(field, shades::Card, shades::Accent, 4, 1.5F);
  this->Field = field;
  this->Typed.paint(canvas, field.x + 8 * s, field.y + 0.5F * field.h, inner - 24 * s,
    { 12.5F, shades::Word }, this->Wanted.saves ? "name: " : "filter: ");
  const float row = RowHeight * s;
  const float top = field.y - 10 * s;
  const int rows = std::max(1, static_cast<int>((top - box.y - 54 * s) / row));
  const int last = std::max(0, static_cast<int>(this->Entries.size()) - rows);
  this->First = std::clamp(this->First, 0, last);
  this->Boxes.clear();
  for (int i = this->First;
       i < std::min(this->First + rows, static_cast<int>(this->Entries.size())); ++i)
  {
    const Entry& entry = this->Entries[static_cast<std::size_t>(i)];
    const Rect place{ box.x + pad, top - static_cast<float>(i - this->First + 1) * row, inner,
      row };
    this->Boxes.push_back(place);
    const bool now = i == this->Current && (!this->Wanted.saves || i == this->Under);
    if (now || i == this->Under)
    {
      canvas.fill(place, now ? shades::AccentSoft : shades::Hover);
    }
    const TextLook look{ 12.5F, entry.folder ? shades::Accent : shades::Word };
    canvas.text(place.x + 8 * s, place.y + 0.5F * place.h,
      canvas.fitted(entry.text, inner - 16 * s, look), look);
  }
  if (last > 0)
  {
    // How much of the list is seen, and which part.
    const float whole = row * static_cast<float>(rows);
    const float part = whole / static_cast<float>(this->Entries.size());
    const Rect track{ box.x + pad + inner + 6 * s, top - whole, 5 * s, whole };
    canvas.fill(track, shades::Hover);
    const float length = part * static_cast<float>(rows);
    canvas.fill({ track.x, top - part * static_cast<float>(this->First) - length, track.w, length },
      shades::Faint);
  }
  const std::string help = this->Wanted.saves
    ? "Return saves, Esc gives up; .ply .obj .stl .off .vtp .vtk, a session .json"
    : "Return opens, letters filter or are a path, ../ leads up, Esc gives up";
  const float words = this->paintButtons(canvas, box) - box.x - 2 * pad;
  const TextLook foot{ 11.5F, this->Sentence.empty() ? shades::Quiet : shades::Alarm };
  const std::vector<std::string> lines =
    canvas.lines(this->Sentence.empty() ? help : this->Sentence, words, 2, foot);
  float middle = box.y + (lines.size() > 1 ? 35 : 28) * s;
  for (const std::string& line : lines)
  {
    canvas.text(box.x + pad, middle, line, foot);
    middle -= 15 * s;
  }
}

float FileChooser::paintButtons(Canvas& canvas, const Rect& page)
{
  const float s = canvas.scale();
  const char* const texts[] = { this->Wanted.saves ? "Save" : "Open", "Cancel" };
  float right = page.right() - 22 * s;
  for (const int i : { 1, 0 })
  {
    const Rect button{ right - 84 * s, page.y + 14 * s, 84 * s, 28 * s };
    this->Buttons[static_cast<std::size_t>(i)] = button;
    canvas.button(button, texts[i], i == 0, i == this->UnderButton);
    right = button.x - 10 * s;
  }
  return right;
}

int FileChooser::entryAt(const Pointer& pointer) const
{
  const int box = boxAt(this->Boxes, pointer);
  return box < 0 ? -1 : this->First + box;
}

void FileChooser::open(const fs::path& path, bool folder)
{
  if (folder)
  {
    this->enter(path);
  }
  else if (this->Wanted.saves)
  {
    this->propose(path.filename().string());
    this->Confirmed = false;
  }
  else
  {
    const Chosen chosen = this->OnChosen; // this page may be gone then
    chosen(path.string());
  }
}

void FileChooser::accept()
{
  std::error_code error;
  const fs::path typed = this->typedPath();
  const bool path = this->typesPath() || this->Typed.text() == "..";
  if (path && fs::is_directory(typed, error))
  {
    this->Typed.set("");
    this->enter(typed);
  }
  else if (path && !fs::is_directory(typed.parent_path(), error))
  {
    this->Sentence = "There is no folder " + typed.parent_path().string() + ".";
  }
  else if (this->Wanted.saves)
  {
    this->acceptName();
  }
  else if (path && fs::exists(typed, error))
  {
    this->open(typed, false);
  }
  else if (this->Current < static_cast<int>(this->Entries.size()))
  {
    const Entry entry = this->Entries[static_cast<std::size_t>(this->Current)];
    this->open(entry.path, entry.folder);
  }
  else
  {
    this->Sentence = path ? "There is no file " + typed.string() + "."
                          : "No name here has \"" + this->Typed.text() + "\" in it.";
  }
}

void FileChooser::acceptName()
{
  const auto& endings = this->Wanted.endings;
  const auto hasEnding = [&endings](const std::string& name) {
    return std::find(endings.begin(), endings.end(), fileExtension(name)) != endings.end();
  };
  // Who types over the stem that is selected types an ending, too, before the one that is there.
  if (const fs::path typed(this->Typed.text());
      hasEnding(typed.string()) && hasEnding(typed.stem().string()))
  {
    this->Typed.set((typed.parent_path() / typed.stem()).string());
  }
  const fs::path file = this->typedPath();
  if (!hasEnding(this->Typed.text()))
  {
    this->Sentence = "The name must end in one of";
    for (const std::string& ending : endings)
    {
      this->Sentence += " " + ending;
    }
    return;
  }
  if (const Status status = OutputFiles::check(file.string()); !status.ok())
  {
    this->Sentence = status.message();
    return;
  }
  const bool isOurs = this->Wanted.isOurs && this->Wanted.isOurs(file.string());
  std::error_code error;
  if (fs::exists(file, error) && !isOurs && !this->Confirmed)
  {
    this->Confirmed = true;
    const bool isInput =
      !this->Wanted.input.empty() && fs::equivalent(file, this->Wanted.input, error);
    this->Sentence = file.filename().string() +
      (isInput ? " is the surface that is open: " : " exists: ") + "Return once more replaces it.";
    return;
  }
  const Chosen chosen = this->OnChosen;
  chosen(file.string());
}

int FileChooser::buttonAt(const Pointer& pointer) const
{
  return boxAt(this->Buttons, pointer);
}

void FileChooser::giveUp()
{
  const std::function<void()> givenUp = this->OnGivenUp; // this page is gone then
  givenUp();
}

void FileChooser::press(const Pointer& pointer)
{
  const int index = this->entryAt(pointer);
  if (index >= 0)
  {
    const Entry entry = this->Entries[static_cast<std::size_t>(index)];
    this->open(entry.path, entry.folder);
  }
  else if (const int button = this->buttonAt(pointer); button >= 0)
  {
    button == 0 ? this->accept() : this->giveUp();
  }
  else if (this->Field.has(pointer.x, pointer.y))
  {
    this->Typed.place(pointer, pointer.shift);
  }
}

void FileChooser::hover(const Pointer& pointer)
{
  this->Under = this->entryAt(pointer);
  this->UnderButton = this->buttonAt(pointer);
}

void FileChooser::wheel(int notches)
{
  this->First = std::max(0, this->First - 3 * notches);
  this->Under = -1;
}

void FileChooser::key(const KeyStroke& stroke)
{
  const std::string& key = stroke.symbol;
  if (key == "Escape")
  {
    this->giveUp();
    return;
  }
  if (key == "Return" || key == "KP_Enter")
  {
    this->accept();
    return;
  }
  this->Sentence.clear();
  this->Confirmed = false;
  if (key == "Up" || key == "Down")
  {
    this->Current = std::clamp(this->Current + (key == "Up" ? -1 : 1), 0,
      std::max(0, static_cast<int>(this->Entries.size()) - 1));
    const int seen = std::max(1, static_cast<int>(this->Boxes.size()));
    this->First = std::clamp(this->First, this->Current - seen + 1, this->Current);
  }
  else if (const std::string before = this->Typed.text(); this->Typed.key(stroke))
  {
    if (!this->Wanted.saves && this->Typed.text() != before)
    {
      this->list();
    }
  }
}
}
