// From the editor to what the 3D view draws: a value, made anew every frame and compared.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "edit/editor.h"
#include "panels/ui_state.h"
#include "pipeline/memo.h"
#include "viewport/ray_lines.h"
#include "viewport/viewport_input.h"

namespace anamorph {

/// The rays that are shown in a frame, sampled once: all lines of one pixel when one is picked, else as the settings
/// say; none where there is no sculpture.
class ShownRays {
 public:
  explicit ShownRays(const Editor& editor);

  /// As they are after `seconds` of the animation.
  std::vector<Line> lines(const RaySettings& settings, double seconds) const;
  /// Seconds that the animation takes from start to end; 0 when nothing is animated.
  double animationSeconds(const RaySettings& settings) const;
  /// Where an animation that is stepped by hand stops.
  std::vector<double> stops(const RaySettings& settings) const;

 private:
  std::shared_ptr<const std::vector<RayTree>> trees_;  // null: vertex rays are shown, or nothing
  std::optional<std::size_t> tree_;                    // alone
  std::vector<VertexRay> vertexRays_;
};

/// Takes the step that editor.rayStep asks for: pauses the animation where the next or the last piece ends.
void stepRays(Editor& editor, const ShownRays& rays);

/// The caustic as it is shown, kept as long as nothing changes that makes it.
class CausticStage {
 public:
  const std::vector<Line>& at(const LevelResult& result);

 private:
  struct Input {
    VertexMap map;
    std::shared_ptr<const Mesh> source;
    bool operator==(const Input&) const = default;
  };
  Memo<Input, std::vector<Line>> memo_;
};

/// All lines of the view: rays, RT camera, construction, caustic.
std::vector<Line> makeLines(Editor& editor, const UiState& ui, const ShownRays& rays, CausticStage& caustic);

class ViewInputMaker {
 public:
  ViewportInput make(Editor& editor, const UiState& ui, const ShownRays& rays, bool transparent);

 private:
  CausticStage caustic_;
  std::shared_ptr<const std::vector<Line>> lines_;  // the last ones: the same lines keep their pointer
};

}  // namespace anamorph
