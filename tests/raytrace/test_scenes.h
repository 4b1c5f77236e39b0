// Small scenes whose colours can be worked out by hand.
#pragma once

#include <random>

#include "raytrace/render.h"
#include "shapes.h"

namespace anamorph::test {

/// Two triangles, corners in order around the quadrilateral.
inline Mesh makeQuad(const Point& a, const Point& b, const Point& c, const Point& d) {
  Mesh mesh;
  for (const Point& p : {a, b, c, d}) mesh.positions.push_back(p);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Side 2 * half, parallel to the ground, facing up.
inline Mesh makeFloor(double half, double z) {
  return makeQuad({-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z});
}

/// The axis-aligned box, twelve triangles, facing outwards.
inline Mesh makeCuboid(const Point& low, const Point& high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline OpticSurface makeMirror(const Shape& shape) {
  return {Optic{OpticKind::mirror, shape}, {0.9, 0.95, 1}, 0.8};
}

/// A mirror cylinder on the ground with a box beside it that shows in it, two lights.
inline SceneInput makeStudio() {
  SceneInput input;
  input.surfaces.push_back(makeSurface("box", makeCuboid({-1.5, -4, 0.5}, {1, -3, 1.5}),
                                       Material{{0.8, 0.3, 0.1}, 0.2, 0.7, 0.3, 20}));
  input.optic = makeMirror(CylinderMirror{{0, 0, 0}, {0, 0, 4}, 1.5});
  input.ground = Ground{};
  input.background = {{0.02, 0.045, 0.09}, {0.48, 0.52, 0.57}};
  input.lights = {PointLight{{-5, -4, 8}, {1, 0.95, 0.9}, 0.7}, PointLight{{6, -7, 9}, {0.9, 0.95, 1}, 0.4}};
  return input;
}

inline Camera studioCamera() {
  Camera camera;
  camera.eye = {0, -9, 6};
  camera.target = {0, 0, 1.2};
  return camera;
}

inline ImageRequest smallImage(int width, int height, int threads = 1) {
  ImageRequest request;
  request.width = width;
  request.height = height;
  request.threads = threads;
  return request;
}

/// The same scene, larger or smaller.
inline SceneInput scaled(SceneInput input, double scale) {
  const auto times = [scale](const Point& p) { return scale * p; };
  for (MeshSurface& surface : input.surfaces) {
    const Mesh mesh{mapPoints(surface.mesh->positions, times), surface.mesh->triangles};
    surface = makeSurface(surface.name, mesh, surface.material);
  }
  if (input.optic) {
    input.optic->optic.shape() = mapShape(input.optic->optic.shape(), {times, Vector(scale)});
  }
  if (input.ground) {
    input.ground->height *= scale;
    input.ground->gridSpacing *= scale;
  }
  for (PointLight& light : input.lights) light.position *= scale;
  return input;
}

}  // namespace anamorph::test
