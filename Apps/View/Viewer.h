// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The program's heart: a session that the controls edit, a preview that follows it at once, a
// worker that makes its mesh, and a window that shows all three.
//
// Nothing is computed or drawn within an event: events note what changed, tick() (a timer) does it,
// so that a queue of mouse moves costs one frame.
#ifndef stipple_Viewer_h
#define stipple_Viewer_h

#include "Activity.h"
#include "AfterScene.h"
#include "BeforeScene.h"
#include "Commands.h"
#include "ControlSheet.h"
#include "CurveEditor.h"
#include "Document.h"
#include "FiguresView.h"
#include "History.h"
#include "MeshWorker.h"
#include "Page.h"
#include "Panel.h"
#include "PreviewWorker.h"
#include "SurfacePicker.h"
#include "ViewerWindow.h"
#include "vtkViewerStyle.h"

#include "vtkNew.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

class vtkImageData;
class vtkRenderWindowInteractor;

namespace stipple
{
class Viewer
  : public Commands
  , public PointerHandler
{
public:
  /// Shows itself in the window, by the interactor's events; both outlive it.
  Viewer(ViewerWindow& window, vtkRenderWindowInteractor* interactor, const Document& document);
  ~Viewer() override;

  /// Draws for the first time.
  void open();
  /// The window may have another size; the model stays in view.
  void resize();
  /// The file that was asked for since this was called last; empty: none.
  [[nodiscard]] std::string takeWantedFile();
  /// The session's file, if it was written since this was called last.
  [[nodiscard]] std::string takeWrittenSession() { return std::exchange(this->NewSession, ""); }
  /// The name of a file that is read beside the window; empty: no more.
  void setReading(const std::string& file);
  /// Whether the user has given it up since this was called last.
  [[nodiscard]] bool takeGivenUp() { return std::exchange(this->GivenUp, false); }
  /// Whether there is paint, points, edges or a curve that is in no session's file, or another
  /// change of which neither session nor mesh is in a file.
  [[nodiscard]] bool hasUnsavedWork() const;
  /// Whether something over the window waits for an answer, but the start page.
  [[nodiscard]] bool asks() const { return this->Asked && !this->Starts; }
  /// Says what went wrong.
  void complain(const std::string& sentence);
  /// The page of a window without a file, with what went wrong, if anything.
  void showStart(const std::string& problem = "");
  /// One turn of the loop: takes what the worker has done, previews, starts meshing, draws.
  void tick();
  /// The mesh is that of the session, or failed or was stopped, and all is drawn as it will stay.
  [[nodiscard]] bool atRest();
  /// Ticks until it is at rest.
  void settle();
  /// The window's picture as it is.
  [[nodiscard]] Status writePicture(const std::string& file);

  const Session& session() const { return this->Now; }
  bool meshIsCurrent() const { return this->Mesh && this->Mesh->session == this->Now; }
  bool busy() const { return this->Worker.busy(); }
  /// The session's samples are shown, or why there are none.
  bool previewIsCurrent() { return this->HasAtlas && !this->PreviewIsOld && this->Sampler.idle(); }
  /// Its samples are shown, perhaps a draft of them.
  bool previewIsShown() { return this->Shown && this->Shown->session == this->sampledSession(); }
  /// That the samples took which are shown.
  double previewSeconds() const { return this->Shown ? this->Shown->seconds : 0; }
  ViewerWindow& window() { return this->Window; }
  /// Leaves out what differs from run to run, for pictures that are compared.
  void hideTimes() { this->TimesHidden = true; }
  /// Looks at the model as at the beginning.
  void resetCamera();
  /// From where it looks, the whole model.
  void fitCamera();
  /// The whole model from the positive side of an axis, or, if that is so already, from the other.
  void lookAlong(int axis);
  /// Ends the program; asks first if there is unsaved work.
  void askToQuit();
  /// Opens another file; asks first likewise.
  void askToOpen(const std::string& file);
  /// Makes a picture the importance, and opens what is none.
  void takeDropped(const std::string& file);

  // Commands
  void edit(const std::function<void(Session&)>& change, bool rests) override;
  void changeView(const std::function<void(ViewState&)>& change) override;
  void clear(Clear what) override;
  void undo() override;
  void redo() override;
  void saveMesh() override;
  void savePicture() override;
  void saveSession() override;
  void openFile() override;
  void saveMeshAs() override;
  void saveFigures() override;
  void chooseArray(const std::string& option, int points) override;
  void choosePicture() override;
  void say(const std::string& sentence, bool alarm = false) override;

  // PointerHandler
  bool press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;
  void hover(const Pointer& pointer) override;
  void wheel(const Pointer& pointer, int notches) override;
  bool key(const KeyStroke& stroke) override;

private:
  using Clock = std::chrono::steady_clock;

  // The session and what follows from it
  void changed(bool rests);
  void showSession();
  /// The session with as many points as the mesh of it had, where only a mesh can tell.
  [[nodiscard]] Session sampledSession() const;
  /// Hands the session's picture to the workers, if it is another one.
  void usePicture();
  void takeResults();
  /// Whether there was a new one.
  bool takePreview();
  /// The new charts take the place of those before, whose samples are shown until there are others.
  void showAtlas();
  /// Makes it, now, if it is not there, of however many points.
  void makeMesh();
  void startMeshing();
  /// How many points the session's length of edges, or its levels of subdivision, lead to, if that
  /// is many and not agreed to; 0 mostly.
  [[nodiscard]] double pointsToAgree() const;
  /// Of points, quads and triangles of the mesh, or of triangles alone, as .stl has it.
  [[nodiscard]] std::string countsOfMesh(bool inTriangles = false) const;
  /// The name of the file that the mesh goes to, without its folder.
  [[nodiscard]] std::string meshFile() const;
  /// The dots are the mesh's own vertices where that is the session's.
  void showVertices();
  [[nodiscard]] bool showsVertices() const;
  /// The next of the triangles with the smallest angles is marked and looked at.
  void goToWorst();
  void goToLost();
  /// In one view, of the middle, which is looked at.
  void showMeshInMiddle();
  /// What is done now, as everything in the window says it.
  [[nodiscard]] Activity activity();
  void showActivity();

  void writeMesh(); ///< or has it written when it is done
  void writePictureFile();
  void writeFigureFiles();
  /// Says whether it could be written.
  bool writeSessionFile();
  /// Named by the user, or written from here.
  [[nodiscard]] bool isOurs(const std::string& file) const;
  /// Writes, after a question if the file is there and not ours.
  void replaceFirst(const std::string& file, const std::function<void()>& write);

  // Pages over the window
  void show(std::shared_ptr<Page> page);
  void closePage();
  void giveUpReading();
  /// Whether there is paint, points, edges or a curve that is in no session's file.
  [[nodiscard]] bool hasHandMade() const;
  void takePicture(const std::string& file);
  /// Does it, after a question if there is unsaved work. `title` is the question, `opened` a file
  /// that is read then.
  void askFirst(const std::string& title, const std::string& answer,
    const std::function<void()>& action, const std::string& opened = "");
  /// The same if a mesh is still to be written. True: it was asked.
  bool askToWait(const std::string& title, const std::string& answer,
    const std::function<void()>& action, const std::string& opened);
  void forgetToSave();
  void quit();

  // The window
  void connect();
  void placeControls();
  void updateZoom();
  /// Controls and model take the places that the window has for them; its view before was so.
  void takePlaces(const Rect& before);
  void lookFrom(const Vec3& from, const Vec3& up);
  void paintView(Canvas& canvas, bool before);
  /// What the colors of a view stand for, if there are any.
  [[nodiscard]] std::optional<ColorBar> barOf(bool before) const;
  void showStale();
  void paintStrip(Canvas& canvas);
  void paintStatus(Canvas& canvas);
  /// What the mesh lacks that somebody may expect.
  [[nodiscard]] std::string remark() const;

  // The pointer
  [[nodiscard]] bool pick(const Pointer& pointer, PickedPlace& place);
  void useTool(const PickedPlace& place, const Pointer& pointer);
  /// Paints on the way from where the pointer was last in this drag.
  void paintTo(const Pointer& pointer);
  /// Dabs there, but where they are too near to the one before in this drag.
  void paint(const std::vector<Vec3>& way, bool begins);
  /// Paint, or none, on all of the surface around what is under the pointer, up to features.
  void fillRegion(bool erases);
  void addStrokes(const std::vector<Vec3>& positions, double radius, double strength, bool rests);
  /// Each with its mirror image behind it, if the brush mirrors.
  [[nodiscard]] std::vector<Vec3> mirrored(const std::vector<Vec3>& positions) const;
  /// The line between both models in one view.
  [[nodiscard]] bool isOverWipe(const Pointer& pointer) const;
  /// What a click would touch: the brush's outline, a point's, edges.
  void showTool(const Pointer& pointer);
  /// The edge there, or the way to it from the last one.
  [[nodiscard]] std::vector<std::array<vtkIdType, 2>> edgesAt(
    const PickedPlace& place, bool path) const;
  /// What the left button does over a view.
  [[nodiscard]] std::string toolHint(const Pointer& pointer) const;
  /// Of equilateral triangles that are alike, as many as a mesh of so many points has; 0 of none.
  [[nodiscard]] double edgeOf(vtkIdType points) const;
  /// What is sure of the mesh that there is, after a comma; nothing if no distance was asked for.
  [[nodiscard]] std::string reachedDistance() const;
  /// The model's name, and the session's if it has one.
  bool isInSession() const; ///< that is a file
  void renewTitle();
  /// Of what is under the pointer now.
  void renewHint();
  void togglePoint(const PickedPlace& place);
  void tagEdges(const PickedPlace& place, bool path);
  Control* controlAt(const Pointer& pointer);
  void setFocus(Control* control);
  int partOf(const Control* control) const;
  bool commandKey(const KeyStroke& stroke);

  vtkSmartPointer<vtkPolyData> Input;
  double Diagonal;
  bool Solid;
  double Area;
  std::map<std::string, vtkSmartPointer<vtkImageData>> Pictures; ///< that were read, by file
  std::string PictureInUse;
  Session Now;
  Session Saved;          ///< as it was opened, or written last
  Session Written;        ///< whose mesh was written last
  std::string NewSession; ///< file that is written
  Session EditBase;       ///< before the edit that goes on
  bool Editing = false;
  History Edits;
  ViewState View;
  ViewerFiles Files;
  std::filesystem::path Folder; ///< of the session that was opened, or what was saved last
  std::string WantedFile;
  std::string Reading; ///< the file
  bool GivenUp = false;
  bool Starts = false; ///< nothing was chosen on the start page yet

  ViewerWindow& Window;
  vtkRenderWindowInteractor* Interactor;
  std::vector<unsigned long> Observers; ///< of the interactor
  vtkNew<vtkViewerStyle> Style;
  BeforeScene BeforeSide;
  AfterScene AfterSide;
  std::shared_ptr<const SurfacePicker> Picker;
  Panel Controls;
  ControlSheet Sheet;
  CurveEditor Curve;
  FiguresView Figures;
  std::array<double, 9> Fitted = {}; ///< the camera's place when the model was fit into the view
  Painted ShownStrip;
  std::shared_ptr<Page> Asked; ///< what is over the window; null mostly
  Control* Captured = nullptr;
  bool Wiping = false;   ///< the line between both models in one view is dragged
  bool Painting = false; ///< the brush is down on the surface
  Vec3 LastDab = Vec3::Zero();
  Pointer LastPainted; ///< where it was looked for dabs last
  Control* Focus = nullptr;
  Control* Under = nullptr;
  Pointer LastPointer;
  std::size_t NextWorst = 0; ///< of the mesh's worst triangles
  vtkIdType NextLost = 0;    ///< of the feature edges that it has not
  vtkIdType LastTagged = -1; ///< point where the last tagged edge ends

  bool HasAtlas = false;                 ///< there are charts
  std::unique_ptr<AtlasResult> NewAtlas; ///< that is not shown yet
  bool AtlasIsNewer = false; ///< than the mesh: of a session whose mesh was stopped, or failed
  bool PreviewIsOld = false; ///< the session is to be sampled
  std::unique_ptr<PreviewResult> Shown;
  std::string PreviewProblem;
  std::unique_ptr<MeshResult> Mesh;
  std::string Problem; ///< what failed for the session of now
  double AgreedPoints; ///< most that follow without a question
  bool MeshWanted = true;
  bool Stopped = false;     ///< by the user
  Clock::time_point MeshAt; ///< when, at the earliest
  Clock::time_point LastFrame;
  Clock::time_point LastStrip;
  bool StripIsOld = false; ///< the control map; it may lag behind a moving slider
  int NextCell = 0;        ///< of the strip, to be painted first
  bool StaleIsOld = false; ///< whether the right view's mesh is the session's; that too
  bool SaveWhenDone = false;
  Session SavesMeshOf;   ///< the session whose mesh that is
  std::string Unwritten; ///< what was to be said of such a file that will not be written
  std::function<void()> AfterSaving; ///< what waits for that
  std::function<void()> AfterDraw;   ///< takes long, once what is said of it can be read
  std::string Message;
  std::string Hint; ///< of what is under the pointer
  /// When the hint is read: before the message, where it is a control's and the newer one; where
  /// there is nothing else to say; or not, for the mesh is newer.
  enum class HintTurn
  {
    First,
    Last,
    Over
  };
  HintTurn Hinting = HintTurn::Last;
  bool MessageAlarm = false;
  Activity Doing; ///< as it is shown
  bool ShownStale = false;
  bool TimesHidden = false;

  PreviewWorker Sampler;
  MeshWorker Worker; ///< last: stops first
};
}

#endif
