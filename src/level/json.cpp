#include "level/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "level/file_remarks.h"

namespace anamorph {
namespace {

using Kind = JsonValue::Kind;

constexpr std::size_t lineWidth = 120;
constexpr std::size_t quotedWidth = 60;  // of a value in a message

void checkUtf8(std::string_view text, const std::string& file) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = characterLength(text.substr(i));
    if (length == 0 || text[i] == 0) {  // the reader would take a 0 for the end of the text
      throw Error(
          fmt::format("expected UTF-8 text, got the byte 0x{:02x}", static_cast<unsigned char>(text[i])),
          file, fmt::format("byte {}", i));
    }
    i += length;
  }
}

// A comma that nothing follows, at this byte.
struct StrayComma {
  std::size_t at;
};

// Receives the parser's events and grows the tree. `open_` leads from the root to the innermost open
// container; a container's items do not move while one of them is open.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::string& file) : text_(text), file_(file), places_(text) {}

  JsonValue takeRoot() { return std::move(root_); }

  bool null() override { return add(Kind::null, "null"); }
  bool boolean(bool value) override { return add(Kind::boolean, value ? "true" : "false"); }
  bool number_integer(std::int64_t value) override { return addInteger(value); }
  bool number_unsigned(std::uint64_t value) override { return addInteger(value); }
  bool number_float(double value, const std::string& written) override {
    return add(Kind::number, written, value);
  }
  bool string(std::string& value) override { return add(Kind::string, std::move(value)); }
  bool binary(nlohmann::json::binary_t&) override { return false; }  // not in JSON text

  bool start_object(std::size_t) override { return open(Kind::object); }
  bool start_array(std::size_t) override { return open(Kind::array); }
  bool key(std::string& name) override {
    keyPlace_ = places_.next();
    open_.back()->keys.push_back(std::move(name));
    return true;
  }
  bool end_object() override {
    checkKeysOnce();
    return end_array();
  }
  bool end_array() override {
    places_.next();
    open_.pop_back();
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    if (error.id == 406) {
      throw Error("expected a number below 1.8e308, got " + shortened(token, quotedWidth), file_,
                  whereText(places_.next(), nextPath()));
    }
    if (const auto comma = findStrayComma(position)) throw StrayComma{*comma};
    // The library's text is "[id] parse error at line 1, column 2: syntax error while parsing ...".
    const std::string what = completed(error.what(), position);
    const std::size_t start = what.find("syntax error");
    throw Error(shortened(start == std::string::npos ? what : what.substr(start), 240), file_,
                whereText(placeOfByte(text_, std::max<std::size_t>(position, 1) - 1), ""));
  }

 private:
  bool add(Kind kind, std::string text = {}, double number = 0) {
    if (++count_ > maxJsonValues) {
      throw Error(fmt::format("expected at most {} values in the file, got more", maxJsonValues), file_);
    }
    newest_ = open_.empty() ? &root_ : &open_.back()->items.emplace_back();
    newest_->kind = kind;
    newest_->text = std::move(text);
    newest_->number = number;
    newest_->place = places_.next();
    newest_->keyPlace = keyPlace_;
    return true;
  }

  template <typename Integer>
  bool addInteger(Integer value) {
    return add(Kind::number, std::to_string(value), static_cast<double>(value));
  }

  bool open(Kind kind) {
    if (open_.size() == maxJsonDepth) {
      throw Error(fmt::format("expected at most {} levels of nesting, got more", maxJsonDepth), file_);
    }
    add(kind);
    open_.push_back(newest_);
    return true;
  }

  // Sorted once at the end, so that many keys take no quadratic time.
  void checkKeysOnce() const {
    const std::vector<std::string>& keys = open_.back()->keys;
    std::vector<std::string_view> sorted(keys.begin(), keys.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice == sorted.end()) return;
    const auto again = std::find(keys.rbegin(), keys.rend(), *twice);
    const JsonValue& second = open_.back()->items[static_cast<std::size_t>(keys.rend() - again) - 1];
    throw Error("expected each key once, got it twice", file_,
                whereText(second.keyPlace, joinJsonPath(openPath(), *twice)));
  }

  // Of the innermost open container.
  std::string openPath() const {
    std::string path;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const JsonValue& value = *open_[i];
      const bool isObject = value.kind == Kind::object;
      path = joinJsonPath(path, isObject ? value.keys.back() : std::to_string(value.items.size() - 1));
    }
    return path;
  }

  // Of the value that is to be added next.
  std::string nextPath() const {
    if (open_.empty()) return "";
    const JsonValue& value = *open_.back();
    const bool isObject = value.kind == Kind::object;
    return joinJsonPath(openPath(), isObject ? value.keys.back() : std::to_string(value.items.size()));
  }

  // Before the bracket that the library stumbled over, which it has read already.
  std::optional<std::size_t> findStrayComma(std::size_t position) const {
    if (position < 2 || position > text_.size() || (text_[position - 1] != '}' && text_[position - 1] != ']'))
      return std::nullopt;
    const std::size_t before = text_.find_last_not_of(" \t\r\n", position - 2);
    return before != std::string_view::npos && text_[before] == ',' ? std::optional(before) : std::nullopt;
  }

  // The library ends its quotation after the offending byte, which may be the first of a character.
  std::string completed(std::string message, std::size_t position) const {
    const std::string_view rest =
        text_.substr(std::min(std::max<std::size_t>(position, 1) - 1, text_.size()));
    const std::size_t length = characterLength(rest);
    const std::size_t cut = length > 1 ? message.rfind(rest[0]) : std::string::npos;
    return cut == std::string::npos ? message : message.replace(cut, 1, rest.substr(0, length));
  }

  std::string_view text_;
  const std::string& file_;
  JsonPlaces places_;
  JsonPlace keyPlace_;
  JsonValue root_;
  JsonValue* newest_ = nullptr;
  std::vector<JsonValue*> open_;
  std::size_t count_ = 0;
};

bool holdsObject(const JsonValue& value) {
  return std::any_of(value.items.begin(), value.items.end(),
                     [](const JsonValue& item) { return item.kind == Kind::object || holdsObject(item); });
}

using Quote = std::string (*)(std::string_view);

// In ASCII; no blank and no > stays as it is.
std::string quotePlain(std::string_view text) {
  std::string quoted;
  for (const char c : nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace)) {
    if (c == ' ' || c == '>') {
      quoted += c == ' ' ? "\\u0020" : "\\u003e";
    } else {
      quoted += c;
    }
  }
  return quoted;
}

void appendCompact(std::string& out, const JsonValue& value, Quote quote) {
  if (value.kind == Kind::string) {
    out += quote(value.text);
  } else if (value.kind != Kind::array && value.kind != Kind::object) {
    out += value.kind == Kind::null ? "null" : value.text;
  } else {
    const bool isObject = value.kind == Kind::object;
    out += isObject ? '{' : '[';
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      if (i > 0) out += ", ";
      if (isObject) out += quote(value.keys[i]) + ": ";
      appendCompact(out, value.items[i], quote);
    }
    out += isObject ? '}' : ']';
  }
}

// `used` columns of the current line are taken already, by the indentation and the key.
void appendReadable(std::string& out, const JsonValue& value, std::size_t indent, std::size_t used) {
  if (value.items.empty() || (indent > 0 && !holdsObject(value))) {
    const std::string line = compactJson(value);
    if (value.items.empty() || used + line.size() < lineWidth) {
      out += line;
      return;
    }
  }
  const bool isObject = value.kind == Kind::object;
  const std::string margin = '\n' + std::string(indent + 2, ' ');
  out += isObject ? '{' : '[';
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    if (i > 0) out += ',';
    const std::string key = isObject ? quoteJson(value.keys[i]) + ": " : "";
    out += margin + key;
    appendReadable(out, value.items[i], indent + 2, indent + 2 + key.size());
  }
  out += '\n' + std::string(indent, ' ') + (isObject ? '}' : ']');
}

}  // namespace

JsonValue parseJson(std::string_view text, FileRemarks& remarks) {
  constexpr std::size_t mostCommas = 20;  // the text is read anew after each
  const std::string& fileName = remarks.file();
  checkUtf8(text, fileName);
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark) text.remove_prefix(byteOrderMark.size());
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw Error("expected JSON, got an empty file", fileName);
  }
  std::string without;  // the commas
  for (std::size_t commas = 0;; ++commas) {
    TreeBuilder builder(text, fileName);
    try {
      nlohmann::json::sax_parse(text, &builder);
      return builder.takeRoot();
    } catch (const StrayComma& comma) {
      remarks.addFault("expected another value after this comma, got a closing bracket: remove the comma",
                       placeOfByte(text, comma.at), "");
      if (commas == mostCommas) remarks.throwFaults();
      if (without.empty()) without = text;
      without[comma.at] = ' ';
      text = without;
    }
  }
}

JsonValue parseJson(std::string_view text, const std::string& fileName) {
  FileRemarks remarks(fileName);
  JsonValue value = parseJson(text, remarks);
  remarks.throwFaults();
  return value;
}

std::string formatJson(const JsonValue& value) {
  std::string out;
  appendReadable(out, value, 0, 0);
  return out + '\n';
}

std::string compactJson(const JsonValue& value) {
  std::string out;
  appendCompact(out, value, quoteJson);
  return out;
}

std::string plainJson(const JsonValue& value) {
  std::string out;
  appendCompact(out, value, quotePlain);
  return out;
}

std::string quoteJson(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

const JsonValue* findMember(const JsonValue& object, std::string_view key) {
  const auto found = std::find(object.keys.begin(), object.keys.end(), key);
  return found == object.keys.end() ? nullptr
                                    : &object.items[static_cast<std::size_t>(found - object.keys.begin())];
}

const JsonValue* findByPath(const JsonValue& document, std::string_view path) {
  const JsonValue* value = &document;
  while (value && !path.empty()) {
    const std::size_t end = std::min(path.find('/', 1), path.size());
    const std::string_view step = path.substr(0, end);
    const JsonValue* next = nullptr;
    for (std::size_t i = 0; i < value->items.size() && !next; ++i) {
      const bool isObject = value->kind == Kind::object;
      if (joinJsonPath("", isObject ? value->keys[i] : std::to_string(i)) == step) next = &value->items[i];
    }
    value = next;
    path.remove_prefix(end);
  }
  return value;
}

std::string joinJsonPath(const std::string& path, std::string_view key) {
  std::string joined = path + '/';
  for (const char c : key) {
    if (c == '~') {
      joined += "~0";
    } else if (c == '/') {
      joined += "~1";
    } else {
      joined += c;
    }
  }
  return joined;
}

std::string describeJson(const JsonValue& value) {
  if (value.kind == Kind::object) return "an object";
  const std::string text = compactJson(value);
  if (value.kind == Kind::array && text.size() > quotedWidth) return "an array";
  return shortened(text, quotedWidth);
}

}  // namespace anamorph
