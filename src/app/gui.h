// All of a window but the window: Dear ImGui, the editor, the panels, the 3D view, drawn into whatever
// framebuffer is bound. The real window, screenshots, the benchmark and tests run the same frame().
//
//   mouse in the view --> editor advances --> 3D view --> panels and overlay --> picture
//   edits the session     live step           is drawn    show all that is new; what they edit is in the next frame
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/export_job.h"
#include "app/font_files.h"
#include "app/image_texture.h"
#include "app/quality.h"
#include "app/render_job.h"
#include "app/shader_warmer.h"
#include "app/view_input.h"
#include "edit/editor.h"
#include "gl/timer.h"
#include "panels/ui_state.h"
#include "pipeline/memo.h"
#include "viewport/viewport.h"

struct ImGuiContext;

namespace anamorph {

/// Milliseconds of one frame on the processor, and of the view on the graphics processor.
struct FrameTimes {
  double panels = 0;   ///< widgets and mouse
  double advance = 0;  ///< live step, rays, coarse preview (LiveTimes has its parts)
  double input = 0;    ///< lines and the view's input
  double view = 0;     ///< OpenGL calls of the 3D view, uploads included
  double draw = 0;     ///< OpenGL calls of the panels
  double gpu = 0;      ///< of the 3D view, the newest answer
};

class Gui {
 public:
  /// Needs a current OpenGL context. `wake` is called from other threads when there is something new to show.
  explicit Gui(Preferences preferences, std::function<void()> wake = {}, int threads = 0);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Opens a level that was read, whatever becomes of the old one.
  void open(LevelFile file);
  /// Reads it first. Throws Error.
  void open(const std::filesystem::path& path) { open(readLevelFile(path)); }

  /// One frame, `seconds` after the last. The caller has set Dear ImGui's display size and mouse, and has
  /// bound a framebuffer of that size. Without `forced` quality it is chosen by how fast frames are.
  void frame(double seconds, const ViewQuality* forced = nullptr);

  /// For a picture of the window: a frame that nobody sees, so that Dear ImGui lays itself out.
  void layOut();
  /// Likewise one whose panels are drawn, over nothing, without the 3D view. Returns what that would show.
  ViewportInput drawWithoutView();

  /// Whether the next frame would differ without any input.
  bool unfinished() const;
  /// Whether a clock of the panels runs: that of what a lesson's step points at.
  bool isPlaying() const { return ui_.highlight.seconds > 0; }
  /// A key went down (`repeated`: is held down); ignored while text is typed, unless a dialog is open.
  void key(int key, int modifiers, bool repeated = false);
  /// Files were dropped on the window.
  void drop(const std::vector<std::filesystem::path>& files);

  Editor& editor() { return *editor_; }
  UiState& ui() { return ui_; }
  const FrameTimes& times() const { return times_; }
  /// In a window: the view waits for its shaders instead of holding up a frame for them. Elsewhere nobody minds.
  void keepShadersWarm(std::function<void()> wake);
  /// Whether the 3D view is as fine as it gets.
  bool viewComplete() const { return fine_ && viewport_->complete(); }
  /// At the end: waits so long for each file that is being written; those that are not written then.
  std::vector<std::filesystem::path> unwritten(double seconds);
  /// For pictures of the window: everything is so many times as large.
  void setShotFactor(double factor) { shotFactor_ = factor; }
  void setTransparent(bool transparent) { transparent_ = transparent; }
  /// UI scale when the preferences leave it to the screen.
  void setScreenScale(double scale) { screenScale_ = scale; }

 private:
  void refreshLanguage();
  void refreshLetters();
  void refreshStyle();
  void refreshTextures();
  void loadThumbnails();
  void serveRequests();
  void openWhenRead(double patienceSeconds);
  void beginFrame(double seconds);
  void advanceAll(double seconds);
  void drawView(double seconds, const ViewQuality* forced);
  void drawLists(float alpha) const;

  ImGuiContext* context_;
  UiState ui_;
  std::unique_ptr<Editor> editor_;
  std::unique_ptr<Viewport> viewport_;
  std::unique_ptr<ShaderWarmer> warmer_;  // null: shaders are compiled when they are needed
  std::unique_ptr<RenderJob> renderJob_;
  std::unique_ptr<ExportJob> exportJob_;
  ViewInputMaker inputMaker_;
  std::optional<ShownRays> rays_;  // of this frame
  ViewportInput lastInput_;
  ImageTexture reflection_, original_, difference_, render_;
  std::map<std::string, ImageTexture> thumbnails_;

  double screenScale_ = 1, shotFactor_ = 1;
  std::optional<std::string> language_;           // that is in force
  Letters languageLetters_;                       // of its texts
  Memo<Shared<LevelText>, Letters> textLetters_;  // of the level's, which may be long
  Letters letters_;                               // that the fonts were loaded with, as far as they have them
  std::set<std::string> explained_;               // what was said of letters that cannot be drawn
  Level openingFrom_;                             // the level that was there when another was asked for
  bool transparent_ = false;
  bool software_;
  bool owesFrame_ = false;  // the panels may have changed something
  bool fine_ = false;       // the view was last drawn in its final quality
  QualityGovernor governor_;
  double secondsStill_ = 0, secondsHandsOff_ = 1;
  GpuTimer timer_;
  FrameTimes times_;
};

}  // namespace anamorph
