#include "base/error.h"

#include <utility>

namespace anamorph {
namespace {

std::string join(const std::string& file, const std::string& where, const std::string& message) {
  std::string text;
  for (const std::string& part : {file, where}) {
    if (!part.empty()) text += part + ": ";
  }
  return text + message;
}

}  // namespace

Error::Error(std::string messageText, std::string fileName, std::string place)
    : std::runtime_error(join(fileName, place, messageText)),
      message(std::move(messageText)),
      file(std::move(fileName)),
      where(std::move(place)) {}

}  // namespace anamorph
