#include "base/kept_attributes.h"

#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/xattr.h>
#endif

#include <climits>

#include "base/system_call.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

constexpr uid_t sameOwner = static_cast<uid_t>(-1);
constexpr gid_t sameGroup = static_cast<gid_t>(-1);
constexpr const char* accessList = "system.posix_acl_access";

#ifdef __linux__
std::vector<std::string> attributeNames(const fs::path& path) {
  std::string list(static_cast<std::size_t>(XATTR_LIST_MAX), 0);
  const ssize_t size = ::listxattr(path.c_str(), list.data(), list.size());
  std::vector<std::string> names;  // each ends with a 0
  for (std::size_t at = 0; size > 0 && at < static_cast<std::size_t>(size); at += names.back().size() + 1) {
    names.emplace_back(list.c_str() + at);
  }
  return names;
}

bool copyAttribute(const fs::path& from, int to, const std::string& name) {
  std::string value(static_cast<std::size_t>(XATTR_SIZE_MAX), 0);
  const ssize_t size = ::getxattr(from.c_str(), name.c_str(), value.data(), value.size());
  return size >= 0 && ::fsetxattr(to, name.c_str(), value.data(), static_cast<std::size_t>(size), 0) == 0;
}

// What the folder hands down to every new file, the old one may not have had.
void dropInheritedList(int file) {
  ::fremovexattr(file, accessList);
}
#else
std::vector<std::string> attributeNames(const fs::path&) {
  return {};
}
bool copyAttribute(const fs::path&, int, const std::string&) {
  return true;
}
void dropInheritedList(int) {}
#endif

// What a new file has been given of the old one.
struct Copy {
  const fs::path& old;
  int file;
  const std::string& name;
  std::vector<std::string> lost = {};
  bool groupAsBefore = true;

  void lose(const std::string& message) { lost.push_back(name + ": replaced, but " + message); }
  void loseForReason(const std::string& what) {
    lose("its " + what + " could not be kept: " + systemReason());
  }
};

void copyOwner(Copy& copy, const struct stat& before, const struct stat& now) {
  if (before.st_uid != now.st_uid && ::fchown(copy.file, before.st_uid, sameGroup) != 0) {
    copy.loseForReason("owner");
  }
  if (before.st_gid != now.st_gid && ::fchown(copy.file, sameOwner, before.st_gid) != 0) {
    copy.groupAsBefore = false;
    copy.loseForReason("group");
  }
}

void copyAttributes(Copy& copy) {
  dropInheritedList(copy.file);
  for (const std::string& attribute : attributeNames(copy.old)) {
    if (attribute.starts_with("security.")) continue;
    const bool isList = attribute == accessList;
    if (isList && !copy.groupAsBefore) {
      copy.lose("its access control list is for a group that could not be kept");
    } else if (!copyAttribute(copy.old, copy.file, attribute)) {
      copy.loseForReason(isList ? "access control list" : "attribute " + attribute);
      if (isList) copy.groupAsBefore = false;
    }
  }
}

// Last: the owner's group gets what the old one had only if it is that one, else what anybody has.
void copyRights(Copy& copy, const struct stat& before) {
  mode_t mode = before.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  if (!copy.groupAsBefore) mode = (mode & (S_IRWXU | S_IRWXO)) | ((mode & S_IRWXO) << 3);
  if (::fchmod(copy.file, mode) != 0) copy.loseForReason("access rights");
}

}  // namespace

std::vector<std::string> keepAttributes(const fs::path& old, int file, const std::string& name) {
  struct stat before {
  }, now{};
  if (::stat(old.c_str(), &before) != 0 || ::fstat(file, &now) != 0) return {};
  Copy copy{old, file, name};
  copyOwner(copy, before, now);
  copyAttributes(copy);
  copyRights(copy, before);
  if (before.st_nlink > 1) {
    const auto others = before.st_nlink - 1;
    copy.lose(others == 1 ? "its other name (a hard link) still has the old contents"
                          : "its " + std::to_string(others) +
                                " other names (hard links) still have the old contents");
  }
  return copy.lost;
}

}  // namespace anamorph
