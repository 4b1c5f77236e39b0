// What a person does in a window, one thing after the other, for a benchmark of the window's frames: opens a level,
// turns the view, goes to another level, saves, exports. Drags are the caller's.
#pragma once

#include <filesystem>

#include "app/frame_recorder.h"

namespace anamorph {

/// A copy of the level there, with a torus knot of about so many triangles as its original, as large as the old one.
/// Returns its file. Throws Error.
std::filesystem::path writeKnotLevel(const std::filesystem::path& level, std::size_t triangles,
                                     const std::filesystem::path& folder);

/// Opens it, until the sculpture is there, and until the view is as fine as it gets.
void benchOpen(Gui& gui, FrameRecorder& recorder, const std::filesystem::path& level);

/// Turns the view by its background in so many frames, and clicks into its middle.
void benchView(HeadlessGui& headless, FrameRecorder& recorder, int frames);

/// Takes the last step back.
void benchUndo(Gui& gui, FrameRecorder& recorder);

/// To an installed level and back, saves the level into the folder, exports the sculpture and a picture of the window
/// there, and begins another one that is four times as large.
void benchFiles(Gui& gui, FrameRecorder& recorder, const std::filesystem::path& folder);

}  // namespace anamorph
