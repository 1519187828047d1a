// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What comes over the window and waits for an answer.
#include "Viewer.h"

#include "Question.h"

#include "vtkRenderWindowInteractor.h"

#include <algorithm>

namespace stipple
{
namespace
{
/// What is made by hand, and would have to be made by hand again.
constexpr const char* HandMade[] = { "strokes", "constraints", "feature_edges", "transfer" };
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

bool Viewer::hasUnsavedWork() const
{
  return std::any_of(std::begin(HandMade), std::end(HandMade),
    [this](const char* name) { return this->Now.list(name) != this->Saved.list(name); });
}

void Viewer::askToQuit()
{
  if (!this->hasUnsavedWork())
  {
    this->quit();
    return;
  }
  const auto save = [this] {
    this->closePage();
    if (this->writeSessionFile())
    {
      this->quit();
    }
  };
  this->show(std::make_shared<Question>("Quit without saving the session?",
    "Paint, picked points, edges or the transfer function are in no file yet.",
    std::vector<Question::Answer>{ { "Save and quit", "Return", save },
      { "Quit", "d", [this] { this->quit(); } },
      { "Stay", "Escape", [this] { this->closePage(); } } }));
}

void Viewer::quit()
{
  this->closePage();
  this->Interactor->TerminateApp();
}
}
