// The end of the window. Its workers are cancelled and waited for; but some work does not look up for a while, a large
// file that is parsed or written, and a disk that does not answer never lets go. Nobody wants to wait for that: when
// everything is kept that was to be kept, the program ends.
#pragma once

#include <filesystem>
#include <vector>

namespace anamorph {

/// Tells, for the log of whoever started the program, that these files were still to be written.
void reportUnwritten(const std::vector<std::filesystem::path>& files);

/// The program ends by itself after so long, successfully, if it has not ended until then. What is in a thread then is
/// lost, so whoever calls this has said what that is. Files are replaced atomically: an old one stays whole.
void endProgramIn(double seconds);

}  // namespace anamorph
