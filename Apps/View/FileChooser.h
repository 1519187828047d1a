// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_FileChooser_h
#define stipple_FileChooser_h

#include "Page.h"
#include "TypedText.h"

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace stipple
{
/// A folder's files to choose from, or a name to save by. Arrows choose, Return opens, Esc gives
/// up, and so do two buttons; letters filter the list or, where it is saved, are the name. What has
/// a slash, or begins with ~, is a path: the list is that of its folder. The name that is proposed
/// is selected up to its ending. A file that exists is replaced by a second Return only.
class FileChooser : public Page
{
public:
  struct Wish
  {
    std::string title;
    std::vector<std::string> endings; ///< with their dots, lower case; files of others are not
                                      ///< shown
    bool saves = false;
    std::filesystem::path begin;     ///< a folder, or, where it is saved, the file that is proposed
    std::filesystem::path input;     ///< the surface that is open: told before it is replaced
    std::vector<std::string> recent; ///< files that are offered first; nothing else if it saves
    std::function<bool(const std::string&)> isOurs; ///< replaced unasked; none if empty
  };
  using Chosen = std::function<void(const std::string& file)>;

  FileChooser(Wish wish, Chosen chosen, std::function<void()> givenUp);

  void paint(Canvas& canvas, const Rect& window) override;
  void press(const Pointer& pointer) override;
  void key(const KeyStroke& stroke) override;
  void hover(const Pointer& pointer) override;
  void wheel(int notches) override;

private:
  struct Entry
  {
    std::string text;
    std::filesystem::path path;
    bool folder = false;
  };
  void enter(const std::filesystem::path& folder);
  void list();
  void open(const std::filesystem::path& path, bool folder);
  void accept();
  void acceptName();
  /// Where what is typed leads: from the folder, from home, or from the root.
  std::filesystem::path typedPath() const;
  bool typesPath() const;
  std::filesystem::path listed() const; ///< the folder, or that of the path that is typed
  /// Proposes a name.
  void propose(const std::string& name);
  int entryAt(const Pointer& pointer) const;  ///< -1: none
  int buttonAt(const Pointer& pointer) const; ///< -1: none
  /// Both buttons, at the lower right; where what is left of them ends.
  float paintButtons(Canvas& canvas, const Rect& page);
  void giveUp();

  Wish Wanted;
  Chosen OnChosen;
  std::function<void()> OnGivenUp;
  std::filesystem::path Folder;
  TypedText Typed;
  std::string Sentence; ///< what is wrong, or asked
  std::vector<Entry> Entries;
  int Current = 0;
  int First = 0; ///< entry that is seen first
  int Under = -1;
  bool Confirmed = false;      ///< the name exists, and Return was pressed once
  Rect Field;                  ///< of what is typed, as painted last
  std::vector<Rect> Boxes;     ///< of the entries from First on, as painted last
  std::array<Rect, 2> Buttons; ///< accept, give up; as painted last
  int UnderButton = -1;
};
}

#endif
