// The palette: every colour that means something, once, as displayed. Rays, legend, overlays, drawings, exports and
// shaders take it from here, so that a thing has one colour wherever it is shown.
//
// The hues are those of Okabe and Ito, which people with any colour vision tell apart. Colours of the themes are in
// panels/style.cpp, those of surfaces in the level.
#pragma once

#include <array>

#include "math/color.h"

namespace anamorph::palette {

// ---- Okabe and Ito

constexpr Rgb orange{0xE69F00}, green{0x009E73}, yellow{0xF0E442}, blue{0x0072B2}, vermilion{0xD55E00},
    purple{0xCC79A7};

// ---- Rays and the construction of a vertex

constexpr Rgb rayFromEye = blue, rayReflected = vermilion, rayToLight = yellow, rayInShadow{0x555555},
              rayIntoSky{0x999999};
constexpr Rgb firstCaustic = orange, secondCaustic = purple;
constexpr Rgb normal = green, virtualRay{0xBFCCD9};
/// Labels on dark plates: brighter than the lines they belong to.
constexpr Rgb pointLabel{0xFFFFFF}, distanceLabel{0xFFE178}, angleLabel{0x5ADCAA}, labelPlate{0x121419},
    pointRim{0x14161C};

// ---- Things of the scene, where they are drawn as lines

constexpr Rgb selected{0xFF5900}, rtCamera{0x9EA8B3}, canvas{0x8CADCC}, chosenCell{0xFFD933};
constexpr Rgb figureMirror{0x8FA8C4}, figureOriginal{0x4C7FC8};

// ---- The axes x, y, z: over the view, where the fourth is the handle for all of them, and beside numbers

inline constexpr std::array viewAxes{Rgb{0xE24A46}, Rgb{0x4AB054}, Rgb{0x4C86EB}, Rgb{0xF0F0F0}};
inline constexpr std::array fieldAxes{Rgb{0xD64541}, Rgb{0x40A04A}, Rgb{0x4278D8}};
constexpr Rgb heldHandle{0xFFCD3C};

// ---- What became of the original's vertices, in the order of PathStatus

inline constexpr std::array vertexStatus{green, vermilion, purple, yellow, orange};

// ---- Where reflection and original differ

/// Plainly different and with everyday names: blue, red, yellow, purple.
constexpr Rgb onlyOriginal = blue, onlyReflection{0xD4213D}, hiddenReflection = yellow, noMirror = purple;

// ---- How good something is; on dark themes, and on light ones

struct ForThemes {
  Rgb dark, light;
};
inline constexpr ForThemes good{Rgb{0x2FBF8F}, Rgb{0x007A58}};
inline constexpr ForThemes middling{orange, Rgb{0x9A6200}};
inline constexpr ForThemes bad{Rgb{0xFF7A4D}, Rgb{0xB93A00}};

// ---- Signs of the window

constexpr Rgb folder = orange, badge = orange;
constexpr Rgb pointedAt{0xFF7800};  ///< what a lesson and the tour point at
constexpr Rgb mouseDisc{0xFFD200}, mouseRing{0xFFAA00};

// ---- Printed pages

constexpr Rgb black{0x000000}, white{0xFFFFFF}, grey{0x6B6B6B}, faint{0xBFBFBF};
constexpr Rgb lightBlue{0xE3F1F9}, lightVermilion{0xFCE8D6}, lightGreen{0xE0F5ED};

}  // namespace anamorph::palette
