#include "level/level_condition.h"

namespace anamorph {

std::optional<bool> holdsOfLevel(const StepCondition& condition, const LevelScene& begin,
                                 const LevelScene& level) {
  switch (condition.when) {
    case StepEvent::movedEye:
      return !(level.camera.eye == begin.camera.eye);
    case StepEvent::movedOriginal:
      return !(level.original.placement == begin.original.placement);
    case StepEvent::movedMirror:
      return !(level.optic.shape() == begin.optic.shape());
    case StepEvent::changedOriginal:
      return !(level.original.shape == begin.original.shape);
    case StepEvent::changedMirror:
      return condition.what == shapeName(level.optic.shape());
    case StepEvent::depthScaleChanged:
      return level.sculpture.depthScale != begin.sculpture.depthScale;
    case StepEvent::toleranceOff:
      return level.sculpture.tolerancePixels == 0;
    case StepEvent::toleranceOn:
      return level.sculpture.tolerancePixels > 0;
    case StepEvent::putRight: {
      Mistakes mistakes = level.sculpture.mistakes;
      return !mistakeOf(mistakes, condition.what);
    }
    case StepEvent::frozen:
      return level.sculpture.frozen.has_value();
    case StepEvent::eyeAbove:
      return level.camera.eye.z > condition.value;
    case StepEvent::eyeAway:
      return glm::length(level.camera.eye - middleOf(level.optic.shape())) > condition.value;
    case StepEvent::keptEye:
      return level.camera.eye == begin.camera.eye;
    case StepEvent::depthScaleAbove:
      return level.sculpture.depthScale > condition.value;
    case StepEvent::depthScaleBelow:
      return level.sculpture.depthScale < condition.value;
    case StepEvent::depthOffsetAbove:
      return level.sculpture.depthOffset > condition.value;
    case StepEvent::depthOffsetBelow:
      return level.sculpture.depthOffset < condition.value;
    default:
      return std::nullopt;
  }
}

}  // namespace anamorph
