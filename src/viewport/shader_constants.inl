// What the shaders know of C++: one line a constant, SHADER_CONSTANT(GLSL type, name, value). scene_program.cpp puts
// them in front of every shader; the test of the leaf functions compiles them as C++.

// The scene block (scene_block.h).
SHADER_CONSTANT(int, surfaceCount, anamorph::gpuSurfaceCount)
SHADER_CONSTANT(int, meshCount, anamorph::gpuMeshCount)
SHADER_CONSTANT(int, lightLimit, anamorph::gpuLightLimit)
SHADER_CONSTANT(int, shapeVectors, anamorph::shapeVectors)
SHADER_CONSTANT(int, mostClips, anamorph::limits::mostClips)
SHADER_CONSTANT(int, layerLimit, anamorph::gpuLayerLimit)

// Which mesh is which, and flags of a surface.
SHADER_CONSTANT(int, sculptureSurface, anamorph::GpuSurface::sculpture)
SHADER_CONSTANT(int, originalSurface, anamorph::GpuSurface::original)
SHADER_CONSTANT(int, mirrorSurface, anamorph::GpuSurface::mirror)
SHADER_CONSTANT(int, inMirror, anamorph::SurfaceFlags::inMirror)
SHADER_CONSTANT(int, castsShadow, anamorph::SurfaceFlags::castsShadow)
SHADER_CONSTANT(int, castsInMirror, anamorph::SurfaceFlags::castsInMirror)
SHADER_CONSTANT(int, hasWires, anamorph::SurfaceFlags::hasWires)
SHADER_CONSTANT(int, wholeMesh, anamorph::SurfaceFlags::wholeMesh)

// What a ray meets.
SHADER_CONSTANT(int, hitNothing, anamorph::ObjectKind::none)
SHADER_CONSTANT(int, hitMesh, anamorph::ObjectKind::mesh)
SHADER_CONSTANT(int, hitMirror, anamorph::ObjectKind::optic)
SHADER_CONSTANT(int, hitGround, anamorph::ObjectKind::ground)
SHADER_CONSTANT(int, hitMarker, anamorph::ObjectKind::light)

// Why a vertex is not mapped.
SHADER_CONSTANT(int, missesMirror, anamorph::PathStatus::missesMirror)
SHADER_CONSTANT(int, inFrontOfMirror, anamorph::PathStatus::inFrontOfMirror)
SHADER_CONSTANT(int, grazing, anamorph::PathStatus::grazing)

// In which colour it is drawn, and what is selected.
SHADER_CONSTANT(vec3, missesMirrorInk, anamorph::statusInk(anamorph::PathStatus::missesMirror))
SHADER_CONSTANT(vec3, inFrontOfMirrorInk, anamorph::statusInk(anamorph::PathStatus::inFrontOfMirror))
SHADER_CONSTANT(vec3, grazingInk, anamorph::statusInk(anamorph::PathStatus::grazing))
SHADER_CONSTANT(vec3, hitsMirrorAgainInk, anamorph::statusInk(anamorph::PathStatus::hitsMirrorAgain))
SHADER_CONSTANT(vec3, selectedInk, anamorph::inkOf(anamorph::palette::selected))

// Lines (line.h).
SHADER_CONSTANT(int, lineSolid, anamorph::LineStyle::solid)
SHADER_CONSTANT(int, lineDashed, anamorph::LineStyle::dashed)
SHADER_CONSTANT(int, lineStyleMask, anamorph::LineFlags::styleMask)
SHADER_CONSTANT(int, lineArrow, anamorph::LineFlags::arrow)
SHADER_CONSTANT(int, lineInFront, anamorph::LineFlags::inFront)

// Long arrays in textures, trees.
SHADER_CONSTANT(int, texelRowBits, anamorph::TexelArrays::rowBits)
SHADER_CONSTANT(int, stackSize, anamorph::bvhMaxDepth)

// The look of the studio.
SHADER_CONSTANT(float, fadeStart, anamorph::look::fadeStart)
SHADER_CONSTANT(float, fadeEnd, anamorph::look::fadeEnd)
SHADER_CONSTANT(float, gridLineWidth, anamorph::look::gridLineWidth)
SHADER_CONSTANT(float, gridDarkening, anamorph::look::gridDarkening)
SHADER_CONSTANT(float, leastSlant, anamorph::look::leastSlant)
SHADER_CONSTANT(float, rimCosine, anamorph::look::rimCosine)
SHADER_CONSTANT(float, rimBorder, anamorph::look::rimBorder)
SHADER_CONSTANT(float, rimStrength, anamorph::look::rimStrength)
SHADER_CONSTANT(vec3, rimColor, anamorph::look::rimColor)
SHADER_CONSTANT(float, shoulderStart, anamorph::look::shoulderStart)
