// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The viewer's life: opening, the loop, preview and mesh.
#include "Viewer.h"

#include "CameraMoves.h"
#include "HelpText.h"
#include "ListPage.h"
#include "OutputFiles.h"
#include "SceneActors.h"
#include "SessionEdits.h"
#include "Text.h"
#include "ViewOptions.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPNGWriter.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <filesystem>
#include <thread>
#include <utility>

namespace stipple
{
namespace
{
constexpr int CurveBars = 48;
/// A slider that is held still rests after this.
constexpr std::chrono::milliseconds RestTime(300);
/// The control map and the curve are drawn this often while a slider moves.
constexpr std::chrono::milliseconds StripTime(120);
/// The status line tells of samples that take longer, in seconds.
constexpr double SamplingTime = 0.3;
/// Controls that changed are drawn with the new samples, or without them after so many seconds.
constexpr double OwnFrameTime = 0.06;
/// Lines become smooth when nothing has moved for this long.
constexpr std::chrono::milliseconds CalmTime(150);

Panel::Choosable choosableOf(vtkPolyData* input)
{
  Panel::Choosable choosable;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(input->GetPointData()),
         static_cast<vtkDataSetAttributes*>(input->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const bool isChoosable = array && array->GetName() && array->GetNumberOfComponents() == 1;
      const bool hasNumbers = isChoosable && vtkDataArray::SafeDownCast(array);
      const bool isOfCells = data == input->GetCellData();
      choosable.arrays = choosable.arrays || hasNumbers;
      choosable.regions = choosable.regions || (isChoosable && isOfCells);
      choosable.selections = choosable.selections || (hasNumbers && isOfCells);
    }
  }
  choosable.textures = input->GetPointData()->GetTCoords() != nullptr;
  return choosable;
}
}

Viewer::Viewer(
  ViewerWindow& window, vtkRenderWindowInteractor* interactor, const Document& document)
  : Input(document.input)
  , Diagonal(document.input->GetLength())
  , Solid(document.solid)
  , Area(document.area)
  , Now(document.session)
  , Saved(document.session)
  , Written(document.session)
  , Files(document.files)
  , Window(window)
  , Interactor(interactor)
  , BeforeSide(this->Window.renderer(ViewerWindow::Before), document.input, this->Solid)
  , AfterSide(this->Window.renderer(ViewerWindow::After), this->Solid)
  , Picker(document.picker)
  , Controls(*this, nameOfFile(document.session.text("model")), choosableOf(document.input))
  , Sheet([this](const std::vector<Vec3>& positions, bool begins, bool rests) {
    if (rests)
    {
      this->edit([](Session&) {}, true);
    }
    else
    {
      this->paint(positions, begins);
    }
  })
  , Curve([this](const CurveEditor::Points& points, bool rests) {
    this->edit(
      [&points](Session& s) {
        // The straight line is no curve: what was added and removed again is no work to be saved.
        points == CurveEditor::straight() ? s.reset("transfer") : s.setRows("transfer", points);
      },
      rests);
  })
  , AgreedPoints(std::max({ static_cast<double>(MostSliderPoints), pointsOfLength(Now, Area),
      pointsOfLevels(Now, Area) }))
  , MeshAt(Clock::now())
  , Sampler(CurveBars)
  , Worker(document.input)
{
  this->Pictures[this->Now.text("importance_image")] = document.image;
  this->usePicture();
  this->Sheet.setHint("Where samples go, unfolded; the brush paints here too.");
  this->Curve.setHint(
    "Blue: importance in, importance out; orange: with gamma; bars: how much of the "
    "surface. Left adds and drags, right removes.");
  this->Figures.setHint("Grey while it is that of an older mesh. g goes to the smallest angle, "
                        "Shift+G to a lost feature edge of the input, violet in the views.");
  this->Window.renderer(ViewerWindow::Before)->AddActor(this->AfterSide.lost());
  if (this->isInSession())
  {
    this->Folder = std::filesystem::absolute(this->Files.session).parent_path();
  }
  this->renewTitle();
  this->connect();
  this->showSession();
}

Viewer::~Viewer()
{
  for (const unsigned long observer : this->Observers)
  {
    this->Interactor->RemoveObserver(observer);
  }
  this->Interactor->SetInteractorStyle(nullptr);
}

void Viewer::connect()
{
  this->Interactor->SetInteractorStyle(this->Style);
  this->Style->SetHandler(this);
  this->Style->AutoAdjustCameraClippingRangeOff(); // the window does
  const auto observe = [this](unsigned long event,
                         void (*function)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(function);
    this->Observers.push_back(this->Interactor->AddObserver(event, command));
  };
  observe(vtkCommand::RenderEvent, [](vtkObject*, unsigned long, void* self, void*) {
    static_cast<Viewer*>(self)->updateZoom();
    static_cast<Viewer*>(self)->Window.touch(ViewerWindow::Views);
  });
  observe(vtkCommand::DropFilesEvent, [](vtkObject*, unsigned long, void* self, void* names) {
    auto* files = static_cast<vtkStringArray*>(names);
    if (files && files->GetNumberOfValues() > 0)
    {
      static_cast<Viewer*>(self)->takeDropped(files->GetValue(0));
    }
  });
  observe(vtkCommand::ConfigureEvent, [](vtkObject*, unsigned long, void* self, void*) {
    auto* viewer = static_cast<Viewer*>(self);
    viewer->resize();
  });
  observe(vtkCommand::ExposeEvent, [](vtkObject*, unsigned long, void* self, void*) {
    static_cast<Viewer*>(self)->Window.renew();
  });
  // The close button of the window.
  observe(vtkCommand::ExitEvent,
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<Viewer*>(self)->askToQuit(); });
  this->Window.addPainter(
    ViewerWindow::Before, [this](Canvas& canvas) { this->paintView(canvas, true); });
  this->Window.addPainter(
    ViewerWindow::After, [this](Canvas& canvas) { this->paintView(canvas, false); });
  for (const bool upper : { true, false })
  {
    this->Window.addPainter(ViewerWindow::PanelPart,
      [this, upper](Canvas& canvas) { this->Controls.paint(canvas, upper); });
  }
  this->Window.addPainter(
    ViewerWindow::Strip, [this](Canvas& canvas) { this->paintStrip(canvas); });
  this->Window.addPainter(
    ViewerWindow::Status, [this](Canvas& canvas) { this->paintStatus(canvas); });
  this->Window.addPainter(ViewerWindow::Overlay, [this](Canvas& canvas) {
    if (this->Starts)
    {
      canvas.fill(this->Window.layout().window, shades::Ground); // the example is not chosen yet
    }
    if (this->Asked)
    {
      this->Asked->paint(canvas, this->Window.layout().window);
    }
    else if (this->View.help)
    {
      paintHelp(canvas, this->Window.layout().window);
    }
  });
}

void Viewer::open()
{
  this->placeControls();
  this->resetCamera();
  this->Window.draw(false);
}

void Viewer::resize()
{
  const Rect before = this->Window.layout().before;
  if (this->Window.resize())
  {
    this->takePlaces(before);
  }
}

void Viewer::takePlaces(const Rect& before)
{
  this->placeControls();
  vtkCamera* camera = this->Window.renderer(ViewerWindow::Before)->GetActiveCamera();
  if (this->Fitted == placeOf(camera))
  {
    this->fitCamera();
    return;
  }
  // As much stays in view of what was, in the direction in which the view is the narrower.
  const Rect& after = this->Window.layout().before;
  zoomAbout(camera, Vec3(camera->GetFocalPoint()),
    std::min(1.F, after.w / after.h) / std::min(1.F, before.w / before.h));
  this->updateZoom();
}

void Viewer::resetCamera()
{
  const auto [x, y, z] = ViewFrom;
  this->View.zUp ? this->lookFrom(Vec3(x, -z, y), Vec3::UnitZ())
                 : this->lookFrom(Vec3(x, y, z), Vec3::UnitY());
}

void Viewer::lookAlong(int axis)
{
  vtkCamera* camera = this->Window.renderer(ViewerWindow::Before)->GetActiveCamera();
  const Vec3 positive = Vec3::Unit(axis);
  const bool turns = positive.dot(Vec3(camera->GetDirectionOfProjection())) < -0.9999;
  const int up = this->View.zUp ? 2 : 1;
  // Seen from above, what was in front is below.
  const Vec3 upward = axis != up ? Vec3::Unit(up) : (up == 1 ? Vec3(0, 0, -1) : Vec3(0, 1, 0));
  this->lookFrom(turns ? Vec3(-positive) : positive, turns && axis == up ? Vec3(-upward) : upward);
}

void Viewer::lookFrom(const Vec3& from, const Vec3& up)
{
  vtkCamera* camera = this->Window.renderer(ViewerWindow::Before)->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(from.data());
  camera->SetViewUp(up.data());
  this->fitCamera();
}

void Viewer::fitCamera()
{
  const Rect& view = this->Window.layout().before;
  stipple::fitCamera(this->Window.renderer(ViewerWindow::Before), this->Input, view.w / view.h,
    40 * this->Window.layout().scale / view.h);
  this->Fitted = placeOf(this->Window.renderer(ViewerWindow::Before)->GetActiveCamera());
  this->updateZoom();
  this->Window.touch(ViewerWindow::Views);
}

void Viewer::updateZoom()
{
  vtkCamera* camera = this->Window.renderer(ViewerWindow::Before)->GetActiveCamera();
  const double height = 2. * camera->GetDistance() *
    std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  const double zoom = this->Window.layout().before.h / height;
  this->BeforeSide.setZoom(zoom / this->Window.layout().scale);
  this->AfterSide.setZoom(zoom / this->Window.layout().scale);
}

void Viewer::tick()
{
  this->takeResults();
  const bool previews = this->takePreview();
  if (this->PreviewIsOld && this->HasAtlas)
  {
    this->PreviewIsOld = false;
    if (pointsOfLength(this->Now, this->Area) <= this->AgreedPoints)
    {
      // A frame has no time for what is not seen.
      this->Sampler.setDensityWanted(this->View.display == Display::Density);
      this->Sampler.start(this->sampledSession());
    }
  }
  if (this->MeshWanted && !this->Starts && Clock::now() >= this->MeshAt)
  {
    this->startMeshing();
  }
  this->showActivity();
  // A frame with a new preview draws one other part at most: the sum would be felt.
  if (this->StaleIsOld && (!previews || Clock::now() - this->LastStrip > 0.5 * StripTime))
  {
    this->StaleIsOld = false;
    this->Window.touch(ViewerWindow::After | ViewerWindow::Status);
  }
  else if (this->StripIsOld && Clock::now() - this->LastStrip > StripTime)
  {
    this->StripIsOld = false;
    this->LastStrip = Clock::now();
    this->Window.touch(ViewerWindow::Strip | ViewerWindow::Status);
  }
  // A frame of the controls alone would take its time from the samples that are nearly there.
  const double waiting = this->Sampler.waiting();
  const bool waits =
    waiting > 0 && waiting < OwnFrameTime && (this->Window.dirtyParts() & ViewerWindow::Views) == 0;
  if (this->Window.dirty() && !waits)
  {
    this->Window.draw(false);
    this->LastFrame = Clock::now();
  }
  else if (!waits && this->Window.rough() && Clock::now() - this->LastFrame > CalmTime)
  {
    this->Window.draw(true);
  }
  if (this->AfterDraw && !this->Window.dirty())
  {
    std::exchange(this->AfterDraw, nullptr)();
  }
}

bool Viewer::atRest()
{
  const bool previewIsDue = this->PreviewIsOld && this->HasAtlas;
  return this->WantedFile.empty() && (!this->MeshWanted || this->Starts) && this->Worker.idle() &&
    !previewIsDue && this->Sampler.idle() && this->activity() == this->Doing && !this->StripIsOld &&
    !this->StaleIsOld && !this->AfterDraw && !this->Window.dirty() && !this->Window.rough();
}

void Viewer::settle()
{
  // No turn comes after the question: a mesh that it took would be drawn, but not smoothly.
  while (!this->atRest())
  {
    this->tick();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void Viewer::takeResults()
{
  if (auto atlas = this->Worker.takeAtlas())
  {
    this->Sampler.setAtlas(atlas->sampling);
    this->HasAtlas = true;
    this->AtlasIsNewer = true;
    this->NewAtlas = std::move(atlas);
    this->PreviewIsOld = true;
    if (this->meshIsCurrent() && this->NewAtlas->session != this->Now)
    {
      // Of a session that was taken back meanwhile: it may lack maps that this one needs.
      this->MeshWanted = true;
      this->MeshAt = Clock::now();
    }
    if (!this->Shown)
    {
      this->showAtlas();
    }
  }
  if (auto mesh = this->Worker.takeMesh())
  {
    this->Mesh = std::move(mesh);
    this->AtlasIsNewer = false;
    this->AfterSide.setMesh(this->Mesh->mesh, this->Mesh->lines, this->Mesh->colors);
    this->AfterSide.setLost(this->Mesh->lost);
    this->Window.renderer(ViewerWindow::After)->AddActor(this->BeforeSide.points());
    this->BeforeSide.setMissed(this->Mesh->colors);
    this->NextLost = 0;
    this->Hinting = HintTurn::Over; // what there is to say of it is seen, wherever the pointer is
    this->showVertices();
    this->Figures.setFigures(this->Mesh->figures);
    this->showSession();
    this->Problem.clear();
    if (this->Mesh->deviation > 0 && this->meshIsCurrent())
    {
      this->say("With " + grouped(this->Mesh->mesh->GetNumberOfPoints()) + " points" +
        this->reachedDistance() + ".");
    }
    this->Window.touch(ViewerWindow::Views | ViewerWindow::Strip | ViewerWindow::Status);
    if (this->SaveWhenDone && this->meshIsCurrent())
    {
      this->saveMesh();
    }
  }
  if (const std::string error = this->Worker.takeError(); !error.empty())
  {
    this->Problem = error;
    if (this->SaveWhenDone)
    {
      this->say(this->meshFile() + " is not written.", true);
      this->forgetToSave();
    }
    this->Window.touch(ViewerWindow::After | ViewerWindow::Status);
  }
}

std::string Viewer::reachedDistance() const
{
  if (!(this->Mesh->deviation > 0))
  {
    return "";
  }
  char percent[32];
  std::snprintf(percent, sizeof(percent), "%.3g", this->Mesh->deviation);
  return std::string(", mesh and input are within ") + percent +
    " % of the diagonal of each other everywhere";
}

void Viewer::showAtlas()
{
  if (this->NewAtlas)
  {
    this->Shown.reset();
    this->BeforeSide.setAtlas(this->NewAtlas->charts, this->NewAtlas->graph);
    this->Sheet.setCharts(this->NewAtlas->charts);
    this->NewAtlas.reset();
    this->Window.touch(ViewerWindow::Before | ViewerWindow::Strip);
  }
}

bool Viewer::takePreview()
{
  auto preview = this->Sampler.take();
  if (!preview)
  {
    return false;
  }
  this->showAtlas(); // it is this one's
  this->PreviewProblem = preview->problem;
  if (preview->problem.empty())
  {
    this->BeforeSide.setDensity(std::move(preview->density));
    this->BeforeSide.setDots(std::move(preview->dots));
    this->BeforeSide.setCreases(preview->creases);
    this->Sheet.setControls(preview->controls);
    this->Shown = std::move(preview);
    this->Curve.setHistogram(this->Shown->histogram);
    this->showVertices();
    if (pointsFollow(this->Now))
    {
      this->showSession();
    }
  }
  this->StripIsOld = true;
  this->Window.touch(ViewerWindow::Before);
  return true;
}

void Viewer::showVertices()
{
  if (this->showsVertices())
  {
    this->BeforeSide.setDots(this->Mesh->dots);
    this->BeforeSide.setCreases(this->Mesh->creases);
    this->Window.touch(ViewerWindow::Before);
  }
}

bool Viewer::showsVertices() const
{
  return this->Shown && !this->NewAtlas && this->meshIsCurrent() && !this->AtlasIsNewer &&
    this->Mesh->dots;
}

void Viewer::setReading(const std::string& file)
{
  this->Reading = nameOfFile(file);
  if (this->Starts && !file.empty())
  {
    this->show(std::make_shared<ListPage>("Reading " + this->Reading + " ...",
      "It opens as soon as it is read.",
      std::vector<ListPage::Entry>{
        { "Escape", "Open something else", "", [this] { this->giveUpReading(); } },
        { "q", "Quit", "", [this] { this->askToQuit(); } } }));
  }
  this->say("");
}

void Viewer::giveUpReading()
{
  this->GivenUp = true;
  if (this->Starts)
  {
    this->showStart();
  }
}

Activity Viewer::activity()
{
  using Mesh = Activity::Mesh;
  Activity now;
  now.progress = this->Worker.busy() ? std::floor(200 * this->Worker.progress()) / 200 : 0;
  now.reading = this->Reading;
  now.savesMesh = this->SaveWhenDone;
  now.meshFile = this->meshFile();
  now.meshPath = this->SaveWhenDone ? wholePath(this->Files.mesh) : "";
  now.sampling = this->Sampler.waiting() > SamplingTime;
  now.samples = !this->Shown && ((this->PreviewIsOld && this->HasAtlas) || !this->Sampler.idle());
  now.meshProblem = this->Problem;
  const bool works = !this->Stopped && this->Worker.busy();
  // Maps of another number of points say nothing about this one, and there may be others soon.
  now.sampleProblem = works || this->MeshWanted || this->Stopped ? "" : this->PreviewProblem;
  const double toAgree = this->pointsToAgree();
  const double byLevels = pointsOfLevels(this->Now, this->Area);
  now.points = toAgree > 0 ? toAgree : byLevels;
  now.byLevels = byLevels > 0;
  now.tried = this->Worker.tried();
  now.mesh = this->meshIsCurrent()         ? Mesh::Current
    : works && this->Worker.makesCharts()  ? Mesh::Charts
    : this->MeshWanted                     ? Mesh::Waiting
    : !this->Problem.empty()               ? Mesh::Failed
    : toAgree > 0                          ? Mesh::Asks
    : this->Stopped || this->Worker.idle() ? Mesh::Stopped
                                           : Mesh::Making;
  return now;
}

void Viewer::showActivity()
{
  const Activity now = this->activity();
  if (now == this->Doing)
  {
    return;
  }
  // Progress is shown at once; the rest after a preview, where one is drawn.
  const bool note = now.note() != this->Doing.note();
  const bool tries = now.tried != this->Doing.tried;
  if (!this->Shown && now.sampleNote() != this->Doing.sampleNote())
  {
    this->Window.touch(ViewerWindow::Before);
  }
  this->Doing = now;
  this->StaleIsOld = this->StaleIsOld || note;
  this->Window.touch(ViewerWindow::Status);
  if (tries)
  {
    this->PreviewIsOld = true;
    this->showSession();
  }
}

void Viewer::makeMesh()
{
  this->PreviewIsOld = this->PreviewIsOld || this->Stopped || this->pointsToAgree() > 0;
  this->AgreedPoints = std::max(this->AgreedPoints, this->pointsToAgree());
  this->MeshWanted = !this->meshIsCurrent();
  this->MeshAt = Clock::now();
  this->Stopped = false;
}

void Viewer::startMeshing()
{
  this->MeshWanted = false;
  if (this->pointsToAgree() == 0 && (!this->meshIsCurrent() || this->AtlasIsNewer))
  {
    this->Problem.clear();
    this->Stopped = false;
    this->Worker.start(this->Now);
  }
  this->Window.touch(ViewerWindow::After | ViewerWindow::Strip | ViewerWindow::Status);
}

double Viewer::pointsToAgree() const
{
  // What the slider takes, divided once, is no surprise.
  constexpr double MostByLevels = 4. * MostSliderPoints;
  const double byLength = pointsOfLength(this->Now, this->Area);
  const double byLevels = pointsOfLevels(this->Now, this->Area);
  return byLevels > std::max(this->AgreedPoints, MostByLevels) ? byLevels
    : byLength > this->AgreedPoints                            ? byLength
                                                               : 0;
}

Session Viewer::sampledSession() const
{
  Session session = this->Now;
  if (session.number("max_deviation") > 0 && (this->Doing.tried > 0 || this->Mesh))
  {
    session.set("points",
      this->Doing.tried > 0 ? this->Doing.tried
                            : static_cast<double>(this->Mesh->mesh->GetNumberOfPoints()));
  }
  return session;
}

std::string Viewer::meshFile() const
{
  return nameOfFile(this->Files.mesh);
}

void Viewer::usePicture()
{
  const std::string& file = this->Now.text("importance_image");
  if (file != this->PictureInUse)
  {
    this->PictureInUse = file;
    this->Sampler.setImage(this->Pictures[file]);
    this->Worker.setImage(this->Pictures[file]);
  }
}

void Viewer::changed(bool rests)
{
  this->usePicture();
  this->PreviewIsOld = true;
  this->PreviewProblem.clear();
  this->Problem.clear();
  if (this->SaveWhenDone && this->Now != this->SavesMeshOf)
  {
    this->forgetToSave();
    this->Unwritten =
      this->meshFile() + " is not written: its mesh is another one now. Ctrl+S writes it.";
  }
  this->say(this->Unwritten, !this->Unwritten.empty());
  this->Stopped = false;
  this->Worker.relax();
  this->MeshWanted = true;
  this->MeshAt = Clock::now() + (rests ? Clock::duration::zero() : Clock::duration(RestTime));
  this->showSession();
}

double Viewer::edgeOf(vtkIdType points) const
{
  return points > 0 ? std::sqrt(2 / std::sqrt(3.) * this->Area / static_cast<double>(points)) : 0.;
}

void Viewer::showSession()
{
  const int points = this->Doing.tried > 0 ? this->Doing.tried
    : this->Shown                          ? static_cast<int>(this->Shown->numberOfSamples)
                                           : 0;
  this->Controls.show(this->Now, this->View, points,
    this->edgeOf(this->meshIsCurrent() ? this->Mesh->mesh->GetNumberOfPoints() : 0));
  this->Controls.setUndo(this->Edits.canUndo() || this->Editing, this->Edits.canRedo());
  this->Curve.setPoints(this->Now.rows<2>("transfer"));
  this->Curve.setGamma(this->Now.number("gamma"));
  const bool marks = this->BeforeSide.setMarks(this->Now);
  this->StripIsOld = true;
  this->Window.touch(ViewerWindow::PanelPart | (marks ? ViewerWindow::Before : 0));
  this->showStale();
}

void Viewer::showStale()
{
  const bool stale = !this->meshIsCurrent();
  if (stale != this->ShownStale)
  {
    this->ShownStale = stale;
    this->Figures.setStale(stale);
    this->StaleIsOld = true;
    this->StripIsOld = true;
  }
}

bool Viewer::isInSession() const
{
  std::error_code error;
  return this->isOurs(this->Files.session) && std::filesystem::exists(this->Files.session, error);
}

void Viewer::renewTitle()
{
  this->Window.setTitle(nameOfFile(this->Now.text("model")) +
    (this->isInSession() ? ", " + nameOfFile(this->Files.session) : ""));
}

void Viewer::say(const std::string& sentence, bool alarm)
{
  this->Hinting = this->Hinting == HintTurn::First ? HintTurn::Last : this->Hinting;
  if (this->Message != sentence || this->MessageAlarm != alarm)
  {
    this->Message = sentence;
    this->MessageAlarm = alarm;
    this->Window.touch(ViewerWindow::Status);
  }
}

Status Viewer::writePicture(const std::string& file)
{
  if (Status status = OutputFiles::check(file); !status.ok())
  {
    return status;
  }
  OutputFiles files;
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window.window());
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(files.aside(file).c_str());
  writer->Write();
  return writer->GetErrorCode() == 0 ? files.commit()
                                     : Status::error("cannot write '" + file + "'");
}
}
