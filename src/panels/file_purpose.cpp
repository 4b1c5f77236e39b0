#include "panels/file_purpose.h"

#include <string_view>

#include "exports/export_formats.h"

namespace anamorph {

const FilePurpose FilePurpose::openLevel{"Open a level", "Open", false, {".json"}};
const FilePurpose FilePurpose::saveLevel{"Save the level", "Save", true, {".json"}};
const FilePurpose FilePurpose::openMesh{"A mesh for the original", "Open", false,
                                        formatOf(ExportKind::sculpture).endings};
const FilePurpose FilePurpose::openMirror{"A mesh for the mirror", "Open", false, openMesh.endings};
const FilePurpose FilePurpose::findMesh{"The mesh of the original", "Open", false, openMesh.endings};
const FilePurpose FilePurpose::saveImage = toSave(formatOf(ExportKind::picture));

FilePurpose FilePurpose::toSave(const ExportFormat& format) {
  return {format.title, "Save", true, format.endings};
}

bool FilePurpose::operator==(const FilePurpose& other) const {
  return std::string_view(title) == other.title;
}

}  // namespace anamorph
