// The 3D view: everything of the level drawn by OpenGL into a picture of its own. It reads the result and never
// edits it.
//
// Meshes are rasterised; mirror, ground, sky and light markers are met analytically, pixel by pixel. Every
// surface is lit as the CPU tracer lights it (same materials, shadow rays through the same BVH, same tone
// curve), and the mirror traces reflected rays through it, so the picture from the RT camera's place is the
// tracer's picture.
//
// Draws only when something changed: the input is a value and is compared. While it stays the same, every
// call adds samples at other places in the pixels, up to `samples`, and the picture loses its jagged edges;
// then nothing is drawn at all.
//
// A sample may take many calls that have little time each. What is shown meanwhile is the last whole one: a picture
// is of one input.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "raytrace/image.h"
#include "viewport/piecework.h"
#include "viewport/viewport_input.h"

namespace anamorph {

class Viewport {
 public:
  /// Needs a current OpenGL 3.3 context (and keeps it for its life). Throws Error when a shader does not
  /// compile or the context lacks something.
  Viewport();
  ~Viewport();
  Viewport(const Viewport&) = delete;
  Viewport& operator=(const Viewport&) = delete;

  /// Draws what is missing. A changed input starts anew with `scale` times the size (0.1..1, for slow
  /// machines while something moves); a changed scale does too. At most `samplesNow` samples are added in
  /// this call, and none when there are `samples` (1..64) already. Returns whether anything was drawn.
  ///
  /// A call goes on for about so many `milliseconds`, and at least for one small piece. When that is too short for a
  /// sample, the next calls go on with it; one of an input that nothing is shown of yet even when the input has changed
  /// since, or nothing would be shown of a drag.
  bool draw(const ViewportInput& input, double scale, int samplesNow, int samples,
            double milliseconds = Piecework::noHurry);

  /// Whether the picture has all the samples asked for last.
  bool complete() const;
  /// How much of the samples asked for last is drawn, 0..1.
  double fraction() const;
  /// Whether the picture is one of the input of the last call, however coarse.
  bool current() const;
  /// Of the last whole sample that was drawn with little time: how long it took, uploads not counted, and at which
  /// scale; once.
  struct SampleCost {
    double scale, milliseconds;
  };
  std::optional<SampleCost> takeCost();

  /// The finished picture: an OpenGL texture name, RGBA8, display-ready (sRGB bytes, straight alpha), first
  /// row at the bottom as OpenGL has it. Its size is the input's times the scale.
  std::uint32_t texture() const;

  /// The same, read back: 4 channels, first row at the top.
  Bitmap readBack() const;

  /// What of the last input could not be shown as it is (a mesh too large for the graphics card), in a
  /// sentence for the user; empty when all is shown.
  std::string problem() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace anamorph
