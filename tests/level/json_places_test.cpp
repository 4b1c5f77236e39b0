// Where values stand in their text: found once by the parser, and once by looking for them.
#include "level/json_places.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "error_text.h"
#include "level/json.h"

namespace anamorph {
namespace {

// Writes a random document with blanks of all kinds, and notes where everything goes.
class RandomDocument {
 public:
  explicit RandomDocument(std::uint64_t seed) : random_(seed) {}

  JsonValue value(int depth) {
    blanks();
    JsonValue made;
    made.place = here();
    const int kind = depth > 4 ? below(3) : below(6);
    if (kind >= 3) {
      container(made, kind == 3, depth);
    } else {
      write(kind == 0 ? "-12.5e3" : kind == 1 ? "true" : strings[below(5)]);
    }
    blanks();
    return made;
  }

  std::string text;

 private:
  static constexpr const char* strings[] = {R"("a")", R"("\\\" , : ]")", "\"\xc3\xa9\xe2\x82\xac\"", R"("")",
                                            R"("{[\u00e9")"};

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  void write(const std::string& piece) { text += piece; }
  void blanks() {
    const char* all[] = {"", " ", "\n", "\r\n", "\t", "  \n "};
    write(all[below(6)]);
  }
  // Counted anew: lines by their ends, columns by characters.
  JsonPlace here() const {
    JsonPlace place{1, 1};
    for (const char c : text.substr(text.rfind('\n') + 1)) place.column += (c & 0xc0) != 0x80;
    for (const char c : text) place.line += c == '\n';
    return place;
  }
  void container(JsonValue& made, bool isArray, int depth) {
    write(isArray ? "[" : "{");
    const int count = below(4);
    for (int i = 0; i < count; ++i) {
      if (i > 0) write(",");
      blanks();
      JsonPlace key;
      if (!isArray) {
        key = here();
        write("\"k\\\"" + std::to_string(i) + "\"");
        blanks();
        write(":");
      }
      made.items.push_back(value(depth + 1));
      made.items.back().keyPlace = key;
    }
    write(isArray ? "]" : "}");
  }

  std::mt19937_64 random_;
};

void expectSamePlaces(const JsonValue& read, const JsonValue& made, bool isMember) {
  EXPECT_EQ(whereText(read.place, ""), whereText(made.place, ""));
  if (isMember) {
    EXPECT_EQ(whereText(read.keyPlace, ""), whereText(made.keyPlace, ""));
  }
  ASSERT_EQ(read.items.size(), made.items.size());
  for (std::size_t i = 0; i < read.items.size(); ++i) {
    expectSamePlaces(read.items[i], made.items[i], read.kind == JsonValue::Kind::object);
  }
}

TEST(JsonPlaces, AreThoseOfTheText) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    RandomDocument document(seed);
    const JsonValue made = document.value(0);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + document.text);
    expectSamePlaces(parseJson(document.text, "f.json"), made, false);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(JsonPlaces, MakeNoValueAnotherOne) {
  EXPECT_EQ(parseJson("[1, {\"a\": 2}]", "f.json"), parseJson("\n [ 1,\n{ \"a\" :2}]", "f.json"));
}

TEST(JsonPlaces, StandBeforeThePath) {
  EXPECT_EQ(whereText({7, 31}, "/a"), "line 7, column 31: /a");
  EXPECT_EQ(whereText({7, 31}, ""), "line 7, column 31");
  EXPECT_EQ(whereText({}, "/a"), "/a");
  EXPECT_EQ(errorOf([] { parseJson("{\"\xc3\xa9\": 1,\n \"a\": 1, \"a\": 2}", "f.json"); }),
            "f.json: line 2, column 10: /a: expected each key once, got it twice");
  EXPECT_EQ(errorOf([] { parseJson("[\"\xc3\xa9\", 1e999]", "f.json"); }),
            "f.json: line 1, column 7: /1: expected a number below 1.8e308, got 1e999");
}

TEST(JsonPaths, LeadToTheirValues) {
  const JsonValue document = parseJson(R"({"a": [1, {"b/~": 2}], "": 3})", "f.json");
  EXPECT_EQ(findByPath(document, ""), &document);
  EXPECT_EQ(findByPath(document, "/a/1/b~1~0")->text, "2");
  EXPECT_EQ(findByPath(document, "/")->text, "3");
  for (const char* path : {"/b", "/a/2", "/a/x", "/a/0/0"})
    EXPECT_EQ(findByPath(document, path), nullptr) << path;
}

}  // namespace
}  // namespace anamorph
