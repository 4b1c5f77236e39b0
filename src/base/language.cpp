#include "base/language.h"

#include <atomic>
#include <cmath>
#include <cstdlib>

namespace anamorph {
namespace {

std::atomic<const TextTable*> chosen = nullptr;

// How the language writes one half: what is between its digits.
std::string decimalSign() {
  const std::string half = tr("0.5");
  return half.size() > 2 ? half.substr(1, half.size() - 2) : ".";
}

// "1.2e-05" as "0.000012", with the same digits; not what would be longer than anybody reads.
std::string withoutExponent(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos || text.find_first_of("0123456789") > e) return text;
  const std::size_t point = text.find('.');
  const int fraction = point < e ? static_cast<int>(e - point) - 1 : 0;
  const int exponent = std::atoi(text.c_str() + e + 1);
  if (std::abs(exponent) > 15) return text;
  return fmt::format("{:.{}f}", std::strtod(text.c_str(), nullptr), std::max(0, fraction - exponent));
}

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

std::string shownNumber(double value, std::string_view spec) {
  const std::string format = "{:" + std::string(spec) + "}";
  std::string text = withoutExponent(fmt::vformat(format, fmt::make_format_args(value)));
  const bool isZero = std::isfinite(value) && text.find_first_of("123456789") == std::string::npos;
  if (isZero && text.starts_with('-')) text.erase(0, 1);
  if (const std::size_t point = text.find('.'); point != std::string::npos)
    text.replace(point, 1, decimalSign());
  return text;
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
