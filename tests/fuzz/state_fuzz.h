// What must hold for any bytes in the files that the program keeps for itself or is given: they are read, or refused
// with an Error or a message, and what was read can be used. Shared by the fuzz targets and by the replay of their
// corpus (app/fuzz_corpus_test.cpp).
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/args.h>

#include "app/autosave.h"
#include "app/preferences.h"
#include "app/progress_file.h"
#include "base/check.h"
#include "base/error.h"
#include "base/format_places.h"
#include "edit/level_files.h"
#include "level/languages.h"
#include "level/level_json.h"

namespace anamorph::testing {

/// Whether a call throws no Error.
template <typename Call>
bool succeeds(const Call& call) {
  try {
    call();
    return true;
  } catch (const Error& error) {
    CHECK(!error.message.empty());
    return false;
  }
}

/// A file of this process with these bytes, in a folder of its own.
inline std::filesystem::path fileWith(std::string_view bytes, const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("anamorph-fuzz-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name, std::ios::binary)
      << bytes;  // without waiting for the disk, as writeFile() does
  return folder / name;
}

// A translation whose places have no specifications takes any values.
inline void checkTranslation(const std::string& english, const std::string& text) {
  const auto places = findFormatPlaces(english);
  if (!places || places->size() > 100) return;
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  std::size_t next = 0;
  for (const auto& [number, spec] : *places) {
    if (!spec.empty() || number != next++) return;
    values.push_back("value");
  }
  fmt::vformat(english, values);
  fmt::vformat(text, values);
}

inline bool readsAsLanguage(std::string_view bytes) {
  return succeeds([&] {
    std::string name;
    for (const auto& [english, text] : parseTexts(bytes, "fuzz.json", &name)) checkTranslation(english, text);
  });
}

inline bool readsAsPreferences(std::string_view bytes) {
  std::string message;
  const Preferences read = loadPreferences(fileWith(bytes, "preferences.json"), message);
  const std::filesystem::path again = fileWith("", "again.json");
  std::string none;
  savePreferences(again, {}, read);
  loadPreferences(again, none);
  CHECK(none.empty());
  return message.empty();
}

inline bool readsAsProgress(std::string_view bytes) {
  std::string message;
  const LessonProgress read = loadProgress(fileWith(bytes, "progress.json"), message);
  const std::filesystem::path again =
      fileWith("{\"format\": \"anamorph-progress\", \"lessons\": {}}", "again.json");
  saveProgress(again, {}, read);
  std::string none;
  CHECK(loadProgress(again, none) == read && none.empty());
  return message.empty();
}

inline bool readsAsRecovery(std::string_view bytes) {
  const std::filesystem::path file = fileWith(bytes, "recovery-1.json");
  bool sound = false;
  for (const Rescued& rescued : findRescued(file.parent_path())) {
    sound = rescued.entry.problem.empty();
    if (sound) CHECK(parseLevel(formatLevel(rescued.level), "again.json").level == rescued.level);
  }
  return sound;
}

inline bool readsAsPastedLevel(std::string_view bytes) {
  return succeeds([&] {
    const Level level = levelFromText(std::string(bytes), {}, "/a/level.json").level;
    CHECK(levelFromText(levelAsText(level, "/a/level.json"), level, "/a/level.json").level == level);
  });
}

struct StateReader {
  const char* name;  ///< of its folder in the corpus
  bool (*reads)(std::string_view bytes);
};

inline const std::vector<StateReader> stateReaders{{"language", readsAsLanguage},
                                                   {"preferences", readsAsPreferences},
                                                   {"progress", readsAsProgress},
                                                   {"recovery", readsAsRecovery},
                                                   {"pasted", readsAsPastedLevel}};

}  // namespace anamorph::testing
