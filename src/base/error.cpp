#include "base/error.h"

#include <utility>

#include "base/text.h"

namespace anamorph {
namespace {

constexpr std::size_t longestPlace = 300;  // bytes; the keys of a JSON pointer may be as long as their file

std::string join(const std::string& file, const std::string& where, const std::string& message) {
  std::string text;
  for (const std::string& part : {file, where}) {
    if (!part.empty()) text += part + ": ";
  }
  return text + message;
}

}  // namespace

Error::Error(std::string messageText, std::string fileName, std::string place)
    : std::runtime_error(join(fileName, shortened(place, longestPlace), messageText)),
      message(std::move(messageText)),
      file(std::move(fileName)),
      where(shortened(std::move(place), longestPlace)) {}

}  // namespace anamorph
