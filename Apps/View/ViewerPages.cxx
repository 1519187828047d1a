// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What comes over the window and waits for an answer.
#include "Viewer.h"

#include "FileChooser.h"
#include "ListPage.h"
#include "MeshFile.h"
#include "Question.h"
#include "RecentFiles.h"
#include "SessionEdits.h"
#include "Text.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <filesystem>

namespace stipple
{
namespace
{
/// Files that the start page offers by a digit.
constexpr int MostRecent = 6;
/// What is made by hand, and would have to be made by hand again.
constexpr const char* HandMade[] = { "strokes", "constraints", "feature_edges", "transfer" };

/// Of files that readImage() reads.
const std::vector<std::string>& pictureExtensions()
{
  static const std::vector<std::string> extensions = { ".png", ".jpg", ".jpeg", ".tif", ".tiff",
    ".bmp", ".vti" };
  return extensions;
}
}

void Viewer::show(std::shared_ptr<Page> page)
{
  this->setFocus(nullptr);
  this->Asked = std::move(page);
  this->Window.showOverlay(true);
}

void Viewer::closePage()
{
  this->Asked.reset();
  this->Window.showOverlay(this->View.help);
}

bool Viewer::hasHandMade() const
{
  return std::any_of(std::begin(HandMade), std::end(HandMade),
    [this](const char* name) { return this->Now.list(name) != this->Saved.list(name); });
}

bool Viewer::hasUnsavedWork() const
{
  const bool mayBeInSession = !this->Now.text("model").empty(); // unlike the example's
  return (mayBeInSession && this->hasHandMade()) ||
    (this->Now != this->Saved && this->Now != this->Written);
}

void Viewer::askFirst(const std::string& title, const std::string& answer,
  const std::function<void()>& action, const std::string& opened)
{
  if (this->askToWait(title, answer, action, opened))
  {
    return;
  }
  if (!this->hasUnsavedWork())
  {
    action();
    return;
  }
  const auto save = [this, action] {
    this->closePage();
    this->replaceFirst(this->Files.session, [this, action] {
      if (this->writeSessionFile())
      {
        action();
      }
    });
  };
  const auto leave = [this, action] {
    this->closePage();
    action();
  };
  const bool isExample = this->Now.text("model").empty();
  const char* why = isExample
    ? "The example is in no file that a session could name, but its mesh can be saved."
    : this->hasHandMade()
    ? "Changes of paint, points, edges or the transfer function are in no file yet."
    : "Neither these settings nor their mesh are in a file yet.";
  const Question::Answer stay{ "Stay", "Escape", [this] { this->closePage(); } };
  const Question::Answer doNotSave{ "Do not save", "d", leave };
  // What is to be opened must not be written over before.
  std::error_code error;
  const bool isOpened =
    !opened.empty() && std::filesystem::equivalent(opened, this->Files.session, error);
  this->show(std::make_shared<Question>(title, why,
    isOpened || isExample
      ? std::vector<Question::Answer>{ { "Save as", "Return", [this] { this->saveMeshAs(); } },
          doNotSave, stay }
      : std::vector<Question::Answer>{
          { "Save, then " + answer, "Return", save }, doNotSave, stay }));
}

bool Viewer::askToWait(const std::string& title, const std::string& answer,
  const std::function<void()>& action, const std::string& opened)
{
  if (!this->SaveWhenDone || this->meshIsCurrent())
  {
    return false;
  }
  const auto goOn = [this, title, answer, action, opened] {
    this->askFirst(title, answer, action, opened);
  };
  const auto wait = [this, goOn] {
    this->closePage();
    this->AfterSaving = goOn;
    if (!this->activity().works())
    {
      this->makeMesh();
    }
  };
  const auto leave = [this, goOn] {
    this->closePage();
    this->forgetToSave();
    this->Written = this->Now; // one question about a mesh is enough
    goOn();
  };
  const std::string file = this->meshFile();
  this->show(
    std::make_shared<Question>(file + " is not written yet", "It will be when the mesh is done.",
      std::vector<Question::Answer>{ { "Wait, then " + answer, "Return", wait },
        { "Do not write it", "d", leave }, { "Stay", "Escape", [this] { this->closePage(); } } }));
  return true;
}

void Viewer::forgetToSave()
{
  this->SaveWhenDone = false;
  this->AfterSaving = nullptr;
}

bool Viewer::isOurs(const std::string& file) const
{
  const std::vector<std::string>& ours = this->Files.ours;
  return std::any_of(ours.begin(), ours.end(), [&file](const std::string& other) {
    std::error_code error;
    return file == other || std::filesystem::equivalent(file, other, error);
  });
}

void Viewer::replaceFirst(const std::string& file, const std::function<void()>& write)
{
  const bool isOurs = this->isOurs(file);
  const auto replace = [this, file, write] {
    this->closePage();
    this->Files.ours.push_back(file);
    write();
  };
  std::error_code error;
  if (isOurs || !std::filesystem::exists(file, error))
  {
    isOurs ? write() : replace();
    return;
  }
  const std::filesystem::path path = std::filesystem::absolute(file, error).lexically_normal();
  this->show(std::make_shared<Question>("Replace " + path.filename().string() + "?",
    "It is in " + path.parent_path().string() + " already.",
    std::vector<Question::Answer>{ { "Replace it", "Return", replace },
      { "Leave it", "Escape", [this] {
         this->closePage();
         this->say("It was not replaced; Ctrl+Shift+S saves under another name.");
       } } }));
}

void Viewer::askToQuit()
{
  this->askFirst("Quit without saving the session?", "quit", [this] { this->quit(); });
}

void Viewer::askToOpen(const std::string& file)
{
  this->askFirst(
    "Open another file without saving the session?", "open",
    [this, file] {
      this->closePage();
      this->WantedFile = file;
    },
    file);
}

std::string Viewer::takeWantedFile()
{
  std::string file;
  file.swap(this->WantedFile);
  return file;
}

void Viewer::complain(const std::string& sentence)
{
  if (this->Starts)
  {
    this->showStart(sentence);
    return;
  }
  this->say(sentence, true);
}

void Viewer::showStart(const std::string& problem)
{
  this->Starts = true;
  std::vector<ListPage::Entry> entries;
  entries.push_back({ "Ctrl+O", "Open a file", ".ply .obj .stl .off .vtp .vtk, sessions",
    [this] { this->openFile(); } });
  entries.push_back({ "e", "Try an example", "a ring with waists", [this] {
                       this->Starts = false;
                       this->closePage();
                     } });
  int number = 0;
  for (const std::string& file : recentFiles())
  {
    const std::string key = std::to_string(++number);
    if (number > MostRecent)
    {
      break;
    }
    const std::filesystem::path path(file);
    entries.push_back({ key, path.filename().string(), path.parent_path().string(),
      [this, file] { this->askToOpen(file); } });
  }
  entries.push_back({ "q", "Quit", "", [this] { this->quit(); } });
  this->show(std::make_shared<ListPage>("stipple",
    "Interactive remeshing of triangle surfaces. Drop a file here, or:", std::move(entries),
    problem));
}

void Viewer::openFile()
{
  FileChooser::Wish wish;
  wish.title = "Open a surface or a session";
  wish.endings = meshFileExtensions();
  wish.endings.emplace_back(".json");
  wish.recent = recentFiles();
  const std::string& model = this->Now.text("model");
  wish.begin = !this->Folder.empty() ? this->Folder
    : !model.empty()                 ? std::filesystem::absolute(model).parent_path()
    : !wish.recent.empty()           ? std::filesystem::path(wish.recent.front()).parent_path()
                                     : std::filesystem::path(".");
  this->show(std::make_shared<FileChooser>(
    std::move(wish), [this](const std::string& file) { this->askToOpen(file); },
    [this] { this->Starts ? this->showStart() : this->closePage(); }));
}

void Viewer::saveMeshAs()
{
  FileChooser::Wish wish;
  wish.title = "Save the mesh, or the session (.json), as";
  wish.endings = meshFileExtensions();
  wish.endings.emplace_back(".json");
  wish.saves = true;
  const bool isNamed = this->Folder.empty() || this->isOurs(this->Files.mesh);
  wish.begin =
    isNamed ? std::filesystem::path(this->Files.mesh) : this->Folder / nameOfFile(this->Files.mesh);
  wish.input = this->Now.text("model");
  wish.isOurs = [this](const std::string& file) { return this->isOurs(file); };
  this->show(std::make_shared<FileChooser>(
    std::move(wish),
    [this](const std::string& file) {
      this->closePage();
      this->Files.ours.push_back(file); // the page has asked
      this->Folder = std::filesystem::absolute(file).parent_path();
      const bool isSession = fileExtension(file) == ".json";
      (isSession ? this->Files.session : this->Files.mesh) = file;
      isSession ? this->saveSession() : this->saveMesh();
    },
    [this] { this->closePage(); }));
}

void Viewer::chooseArray(const std::string& option, int points)
{
  const auto choose = [this, option, points](const std::string& array) {
    this->closePage();
    this->edit([&](Session& s) { setArray(s, option, array, points); }, true);
  };
  std::vector<ListPage::Entry> entries;
  entries.push_back({ "0", "none", "", [choose] { choose(""); } });
  const bool takesNames = option == "region_array"; // all else are numbers
  const bool cellsOnly = takesNames || option == "select_array";
  const auto add = [&](vtkDataSetAttributes* data, const char* what) {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (array->GetName() && array->GetNumberOfComponents() == 1 &&
        (takesNames || vtkDataArray::SafeDownCast(array)))
      {
        const std::string name = array->GetName();
        const std::string key = entries.size() < 10 ? std::to_string(entries.size()) : "";
        entries.push_back({ key, name, what, [choose, name] { choose(name); } });
      }
    }
  };
  if (!cellsOnly)
  {
    add(this->Input->GetPointData(), "of points");
  }
  add(this->Input->GetCellData(), "of cells");
  entries.push_back({ "Escape", "Leave it as it is", "", [this] { this->closePage(); } });
  this->show(std::make_shared<ListPage>("Arrays of " + nameOfFile(this->Now.text("model")),
    findOption(option)->help, std::move(entries)));
}

void Viewer::choosePicture()
{
  FileChooser::Wish wish;
  wish.title = "A picture as the importance";
  wish.endings = pictureExtensions();
  wish.begin = std::filesystem::absolute(this->Files.mesh).parent_path();
  this->show(std::make_shared<FileChooser>(
    std::move(wish), [this](const std::string& file) { this->takePicture(file); },
    [this] { this->closePage(); }));
}

void Viewer::takePicture(const std::string& file)
{
  this->closePage();
  vtkSmartPointer<vtkImageData> image;
  if (const Status status = readImage(file, image); !status.ok())
  {
    this->say(status.message(), true);
    return;
  }
  this->Pictures[file] = image;
  this->edit(
    [&file](Session& s) {
      s.set("importance_image", file);
      s.set("importance", std::string("image"));
    },
    true);
}

void Viewer::takeDropped(const std::string& file)
{
  const std::vector<std::string>& pictures = pictureExtensions();
  const bool isPicture =
    std::find(pictures.begin(), pictures.end(), fileExtension(file)) != pictures.end();
  if (isPicture && !this->Starts)
  {
    this->takePicture(file);
  }
  else
  {
    this->askToOpen(file);
  }
}

void Viewer::quit()
{
  this->closePage();
  this->Interactor->TerminateApp();
}
}
