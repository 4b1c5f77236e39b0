#include "base/error.h"

#include <utility>

#include <fmt/format.h>

#include "base/check.h"
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

std::string firstOf(const std::vector<Error>& faults) {
  CHECK(!faults.empty());
  const std::string first = faults.front().what();
  return faults.size() == 1 ? first : fmt::format("{} (and {} more)", first, faults.size() - 1);
}

}  // namespace

Error::Error(std::string messageText, std::string fileName, std::string place)
    : std::runtime_error(join(fileName, shortened(place, longestPlace), messageText)),
      message(std::move(messageText)),
      file(std::move(fileName)),
      where(shortened(std::move(place), longestPlace)) {}

Error::Error(std::vector<Error> found)
    : std::runtime_error(firstOf(found)),
      message(found.front().message),
      file(found.front().file),
      where(found.front().where),
      faults(std::move(found)) {}

std::vector<std::string> linesOf(const Error& error) {
  std::vector<std::string> lines;
  for (const Error& fault : error.faults) lines.emplace_back(fault.what());
  return lines.empty() ? std::vector<std::string>{error.what()} : lines;
}

}  // namespace anamorph
