#include "app/gui.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>

#include "app/fonts.h"
#include "base/error.h"
#include "base/resources.h"
#include "edit/advance.h"
#include "gl/load_gl.h"
#include "level/languages.h"
#include "panels/dialogs.h"
#include "panels/file_flow.h"
#include "panels/key_input.h"
#include "panels/level_sharing.h"
#include "panels/panels.h"
#include "panels/shown_texts.h"
#include "panels/style.h"
#include "panels/view_mouse.h"
#include "panels/widgets.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

constexpr double textPixels = 15;  // at 100 %
constexpr double patience = 0.2;   // seconds without the mouse before a fine picture is begun in software

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Runs and says how long it took.
template <typename Work>
double timed(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return millisecondsSince(start);
}

std::size_t triangleCount(const ViewportInput& input) {
  std::size_t count = 0;
  for (const auto& mesh : {input.original.mesh, input.sculpture.prepared.mesh})
    count += mesh ? mesh->triangles.size() : 0;
  return count;
}

// What the panels have done since the editor advanced is seen in the next frame. They do nothing by themselves.
bool wasTouched() {
  const ImGuiIO& io = ImGui::GetIO();
  bool touched = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0;
  for (int button = 0; button < 3; ++button) {
    touched = touched || ImGui::IsMouseClicked(button) || ImGui::IsMouseReleased(button);
  }
  return touched || !io.InputQueueCharacters.empty();
}

}  // namespace

Gui::Gui(Preferences preferences, std::function<void()> wake, int threads)
    : context_(ImGui::CreateContext()),
      editor_(std::make_unique<Editor>(wake, threads)),
      renderJob_(std::make_unique<RenderJob>(wake)),
      exportJob_(std::make_unique<ExportJob>(wake)),
      software_(isSoftwareRenderer()),
      governor_(software_) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  ImGui_ImplOpenGL3_Init("#version 330 core");
  viewport_ = std::make_unique<Viewport>();
  ui_.preferences = preferences;
  ui_.levels = listLevels();
  ui_.languages = listLanguages();
  loadThumbnails();
}

Gui::~Gui() {
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void Gui::open(LevelFile file) {
  endViewDrag(*editor_, ui_.mouse, false);  // it would put the old level into the new one's place
  letGoOfWidgets();
  const std::filesystem::path path = file.path;
  openLevel(*editor_, std::move(file));
  rememberLevel(ui_, path);
  askForMissingMesh(*editor_, ui_);
}

void Gui::serveRequests() {
  settleRequests(*editor_, ui_);
  double patience = 0;
  if (const auto path = std::exchange(ui_.requests.open, std::nullopt)) {
    editor_->opening.start(*path);
    openingFrom_ = editor_->session.level();
    patience = 0.05;  // most files are here in less, and then nothing flickers
  }
  if (std::exchange(ui_.requests.startNew, false)) {
    editor_->opening.cancel();
    openNewLevel(*editor_);
  }
  openWhenRead(patience);
}

void Gui::openWhenRead(double patienceSeconds) {
  try {
    auto file = editor_->opening.take(patienceSeconds);
    if (!file) return;
    // Nobody has been asked about changes that came after the question.
    if (!(openingFrom_ == editor_->session.level())) {
      throw Error(tr("the level has been changed meanwhile, so nothing was done."),
                  file->path.filename().string());
    }
    open(std::move(*file));
  } catch (const Error& error) {
    ui_.notice = Notice{"The level could not be opened", error.what()};
  }
}

// The pictures that the README shows, where there is one of a level's name.
void Gui::loadThumbnails() {
  for (const LevelEntry& entry : ui_.levels) {
    const std::filesystem::path file = resourceFolder() / "assets" / "pictures" / (entry.name + ".png");
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;
    try {
      thumbnails_[entry.name].show(loadPng(file), true);
      ui_.textures.thumbnails[entry.name] = thumbnails_[entry.name].texture();
    } catch (const Error&) {
      // A level without its picture is still a level.
    }
  }
}

void Gui::refreshLanguage() {
  if (language_ == ui_.preferences.language) return;
  language_ = ui_.preferences.language;
  try {
    languageLetters_.clear();
    const TextTable* texts = chooseLanguage(*language_);
    if (!texts) return;
    for (const auto& [english, text] : *texts) addLetters(text, languageLetters_);
  } catch (const Error& error) {
    editor_->status.say(error.what());
  }
}

// The fonts are loaded anew when a text needs a letter that they were not loaded with.
void Gui::refreshLetters() {
  Letters needed = textLetters_.get(editor_->session.level().text, [](const Shared<LevelText>& level) {
    Letters letters;
    forEachTextOf(*level, [&](std::string_view text) { addLetters(text, letters); });
    return letters;
  });
  needed.insert(languageLetters_.begin(), languageLetters_.end());
  forEachShownText(*editor_, ui_, [&](std::string_view text) { addLetters(text, needed); });
  if (std::includes(letters_.begin(), letters_.end(), needed.begin(), needed.end())) return;
  letters_ = std::move(needed);
  ImGui::GetIO().Fonts->Clear();
  for (const std::string& sentence : explainMissing(letters_)) {
    if (explained_.insert(sentence).second) editor_->status.say(sentence);
  }
}

void Gui::refreshStyle() {
  const Preferences& p = ui_.preferences;
  const double wanted = (p.uiScale > 0 ? p.uiScale : screenScale_) * themeScale(p.theme);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const double fitting = ui_.panelsHidden && !ui_.presenting
                             ? wanted
                             : fittingScale(wanted, display.x / shotFactor_, display.y / shotFactor_);
  const double scale = fitting * shotFactor_;
  const bool asBefore =
      ui_.scale == scale && ui_.theme == p.theme && ui_.presenting == (ui_.fonts.huge != nullptr);
  if (asBefore && ImGui::GetIO().Fonts->IsBuilt()) return;
  if (ui_.scale != scale && p.uiScale > 0 && fitting < wanted && !ui_.headless)
    editor_->status.say(
        trFormat("Text and controls have {:.0f} % of their size here: more would leave no room for all "
                 "panels.",
                 100 * fitting / themeScale(p.theme)));
  ui_.theme = p.theme;
  ui_.scale = scale;
  applyStyle(p.theme, scale);
  ui_.fonts = loadFonts(std::round(textPixels * ui_.scale), ui_.presenting, letters_);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Gui::refreshTextures() {
  const Previews& previews = editor_->updater.result().previews;
  const bool smooth = editor_->preview.size > 0;
  reflection_.show(previews.reflection, smooth);
  original_.show(previews.original, smooth);
  difference_.show(previews.difference, false);
  render_.show(renderJob_->picture());
  ui_.textures.reflection = reflection_.texture();
  ui_.textures.original = original_.texture();
  ui_.textures.difference = difference_.texture();
  ui_.textures.render = render_.texture();
}

void Gui::drawView(double seconds, const ViewQuality* forced) {
  ViewportInput input;
  times_.input = timed([&] { input = inputMaker_.make(*editor_, ui_, *rays_, transparent_); });
  const bool moving = !(input == lastInput_);
  secondsStill_ = moving ? 0 : secondsStill_ + seconds;
  const ImGuiIO& io = ImGui::GetIO();
  const bool handsOn =
      io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || ImGui::IsAnyMouseDown() || io.MouseWheel != 0;
  secondsHandsOff_ = handsOn ? 0 : secondsHandsOff_ + seconds;
  // A finer picture takes all the time that frames have, in which the panels would be slow to answer the mouse.
  if (software_ && !forced && !moving && secondsHandsOff_ < patience && viewport_->current()) return;
  ui_.preparingView = warmer_ && !forced && !warmer_->ready(input);
  if (ui_.preparingView) {
    fine_ = false;
    return;
  }
  if (triangleCount(input) > 4 * triangleCount(lastInput_)) governor_.forget();
  const ViewQuality quality = forced ? *forced : governor_.next(moving, secondsStill_);
  fine_ = forced || governor_.isFinal(quality);
  const auto start = std::chrono::steady_clock::now();
  timer_.begin();
  const bool drawn =
      viewport_->draw(input, quality.scale, quality.samplesNow, quality.samples, quality.milliseconds);
  timer_.end();
  if (drawn && software_) glFinish();  // its time is the processor's
  times_.view = millisecondsSince(start);
  times_.gpu = timer_.result();
  if (const auto cost = viewport_->takeCost()) {
    governor_.took({cost->scale}, cost->milliseconds);
  } else if (drawn && !software_ && quality.milliseconds == Piecework::noHurry) {
    governor_.took(quality, times_.gpu);
  }
  if (moving) lastInput_ = std::move(input);
  ui_.viewProblem = viewport_->problem();
  ui_.textures.view = {viewport_->texture(), editor_->viewWidth, editor_->viewHeight, true};
}

void Gui::frame(double seconds, const ViewQuality* forced) {
  const auto start = std::chrono::steady_clock::now();
  beginFrame(seconds);
  drawView(seconds, forced);
  refreshTextures();
  times_.panels += timed([&] { drawPanels(*editor_, ui_); });
  owesFrame_ = wasTouched();
  serveRequests();
  times_.draw = timed([&] { drawLists(transparent_ ? 0 : 1); });
  ui_.frameMilliseconds = millisecondsSince(start);
}

void Gui::keepShadersWarm(std::function<void()> wake) {
  if (software_) warmer_ = std::make_unique<ShaderWarmer>(std::move(wake));
}

void Gui::layOut() {
  beginFrame(1e-4);
  drawPanels(*editor_, ui_);
  ImGui::EndFrame();
}

ViewportInput Gui::drawWithoutView() {
  beginFrame(1e-4);
  const UiTexture view = std::exchange(ui_.textures.view, {});
  drawPanels(*editor_, ui_);
  drawLists(0);
  ui_.textures.view = view;
  return inputMaker_.make(*editor_, ui_, *rays_, transparent_);
}

void Gui::beginFrame(double seconds) {
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().DeltaTime = static_cast<float>(std::max(1e-4, seconds));
  refreshLanguage();
  refreshLetters();
  refreshStyle();
  ImGui_ImplOpenGL3_NewFrame();
  times_.panels = timed([&] {
    ImGui::NewFrame();
    handleInput(*editor_, ui_);
  });
  advanceAll(seconds);
}

void Gui::advanceAll(double seconds) {
  const double before = editor_->animationSeconds;
  times_.advance = timed([&] { advance(*editor_, seconds); });
  rays_.emplace(*editor_);
  stepRays(*editor_, *rays_);
  const double length = rays_->animationSeconds(editor_->rays);
  if (editor_->rays.animate && !editor_->rays.loop && editor_->animationSeconds > length) {
    const bool goesOn = before >= length;  // from the end, where it was paused
    editor_->animationSeconds = goesOn ? 0 : length;
    editor_->animationPaused = !goesOn;
  }
  renderJob_->update(editor_->updater.result(), ui_);
  exportJob_->update(*editor_, ui_);
}

void Gui::drawLists(float alpha) const {
  ImGui::Render();
  const ImGuiIO& io = ImGui::GetIO();
  glViewport(0, 0, static_cast<int>(io.DisplaySize.x * io.DisplayFramebufferScale.x),
             static_cast<int>(io.DisplaySize.y * io.DisplayFramebufferScale.y));
  glClearColor(0, 0, 0, alpha);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Gui::unfinished() const {
  return owesFrame_ || isMoving(*editor_) || !viewComplete() || editor_->updater.busy() ||
         editor_->job.busy() || editor_->opening.busy() || editor_->saving.busy() || editor_->morph.busy() ||
         ui_.render.running || !ui_.render.saving.empty() || !render_.complete() || ui_.exporting.running ||
         ui_.shot.running || ui_.requests.shot;
}

std::vector<std::filesystem::path> Gui::unwritten(double seconds) {
  std::vector<std::filesystem::path> files = renderJob_->unwritten(seconds);
  if (auto file = exportJob_->unwritten(seconds)) files.push_back(std::move(*file));
  if (auto file = editor_->saving.unwritten(seconds)) files.push_back(std::move(*file));
  return files;
}

void Gui::key(int key, int modifiers, bool repeated) {
  ImGui::SetCurrentContext(context_);
  if (ImGui::GetIO().WantTextInput && !isDialogOpen(ui_)) return;
  handleKey(key, modifiers, *editor_, ui_, repeated);
}

void Gui::drop(const std::vector<std::filesystem::path>& files) {
  ImGui::SetCurrentContext(context_);
  acceptFiles(files, *editor_, ui_);
}

}  // namespace anamorph
