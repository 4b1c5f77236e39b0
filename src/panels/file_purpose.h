// What a file is chosen for in the file browser: a value, so that what is exported brings its own.
#pragma once

#include <vector>

namespace anamorph {

struct ExportFormat;

struct FilePurpose {
  const char* title;  ///< of the browser, in English; the same title is the same purpose
  const char* button;
  bool saves;  ///< a file that is there is asked about, and a name without an ending gets one
  std::vector<const char*> endings;  ///< of the files that are shown

  static const FilePurpose openLevel, saveLevel, openMesh, openMirror, findMesh, saveImage;
  static FilePurpose toSave(const ExportFormat& format);

  bool operator==(const FilePurpose& other) const;
};

}  // namespace anamorph
