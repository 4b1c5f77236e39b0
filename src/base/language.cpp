#include "base/language.h"

#include <atomic>

namespace anamorph {
namespace {

std::atomic<const TextTable*> chosen = nullptr;

}  // namespace

void setLanguage(const TextTable* table) {
  chosen.store(table, std::memory_order_release);
}

const char* tr(const char* english) {
  const TextTable* table = chosen.load(std::memory_order_acquire);
  if (!table) return english;
  const auto found = table->find(english);
  return found == table->end() ? english : found->second.c_str();
}

std::string tr(const std::string& english) {
  return tr(english.c_str());
}

std::string formatTranslated(fmt::string_view english, fmt::format_args arguments) {
  const std::string text(english.data(), english.size());
  try {
    return fmt::vformat(tr(text), arguments);
  } catch (const fmt::format_error&) {
    return fmt::vformat(english, arguments);
  }
}

}  // namespace anamorph
