#include "edit/status.h"

#include <utility>

namespace anamorph {

void Status::sayOf(const Level& level, std::string text) {
  text_ = std::move(text);
  level_ = level;
}

void Status::say(std::string text) {
  text_ = std::move(text);
  level_.reset();
}

void Status::update(const Level& level) {
  if (level_ && !(*level_ == level)) clear();
}

}  // namespace anamorph
