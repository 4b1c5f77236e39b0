// The facts F1 to F8 that every implementation must satisfy (method section 4), each over random scenes.

#include <algorithm>

#include <gtest/gtest.h>

#include "anamorphosis/edge_error.h"
#include "anamorphosis/map_points.h"
#include "anamorphosis/vertex_ray.h"
#include "optics/camera.h"
#include "optics/reflect.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

constexpr unsigned scenes = 1000;

// Runs body(scene, random) for every kind of mirror and every seed.
template <typename Body>
void forScenes(std::initializer_list<ShapeKind> kinds, const Body& body) {
  for (const ShapeKind kind : kinds) {
    for (unsigned seed = 0; seed < scenes; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const RandomScene scene = makeRandomScene(kind, random);
      body(scene, random);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

constexpr auto everyKind = {ShapeKind::plane, ShapeKind::cylinder,  ShapeKind::sphere,
                            ShapeKind::cone,  ShapeKind::ellipsoid, ShapeKind::paraboloid};

// The normal at a point of the mirror, computed here from the shape alone.
Direction normalAt(const RandomScene& scene, const Point& q) {
  Direction n;
  if (const auto* plane = scene.optic.shape().as<PlaneMirror>()) {
    n = glm::normalize(
        glm::cross(plane->corners[1] - plane->corners[0], plane->corners[3] - plane->corners[0]));
  } else if (const auto* tube = scene.optic.shape().as<CylinderMirror>()) {
    const Vector axis = tube->top - tube->bottom, w = q - tube->bottom;
    n = glm::normalize(w - glm::dot(w, axis) / glm::dot(axis, axis) * axis);
  } else if (const auto* cone = scene.optic.shape().as<ConeMirror>()) {
    const Vector axis = cone->top - cone->bottom, w = q - cone->bottom;
    const Direction out = glm::normalize(w - glm::dot(w, axis) / glm::dot(axis, axis) * axis);
    // Perpendicular to the ruling through q, in the plane of the axis.
    const Vector ruling = axis + (cone->topRadius - cone->bottomRadius) * out;
    n = glm::normalize(out - glm::dot(out, ruling) / glm::dot(ruling, ruling) * ruling);
  } else if (const auto* egg = scene.optic.shape().as<EllipsoidMirror>()) {
    const glm::dmat3 own = rotationMatrix(egg->rotationDegrees);
    n = glm::normalize(own * (glm::transpose(own) * (q - egg->centre) / (egg->radii * egg->radii)));
  } else if (const auto* bowl = scene.optic.shape().as<ParaboloidMirror>()) {
    // Half way between the focus and what comes in along the axis.
    const Direction axis = glm::normalize(bowl->axis);
    n = glm::normalize(axis + glm::normalize(bowl->vertex + bowl->focalLength * axis - q));
  } else {
    n = glm::normalize(q - shapeAs<SphereMirror>(scene.optic.shape()).centre);
  }
  return glm::dot(n, scene.eye - q) > 0 ? n : -n;
}

// Where the eye sees the sculpture point S in the mirror: the ray to Q is given, S has to lie on its
// reflection.
double missDistance(const RandomScene& scene, const Point& q, const Point& s) {
  const Vector in = glm::normalize(q - scene.eye), n = normalAt(scene, q);
  const Vector r = in - 2 * glm::dot(in, n) * n, toS = s - q;
  return glm::length(toS - glm::dot(toS, r) * r);
}

TEST(Facts, F1AnyDepthGivesTheSameImage) {
  forScenes(everyKind, [](const RandomScene& scene, Random& random) {
    const Point p = makeRandomOriginal(scene, random, 0.05);
    Camera camera;
    camera.eye = scene.eye;
    camera.target = scene.onMirror;
    const Projection projection(camera, 1, 1);  // so pixels are widths of the image
    const auto wanted = projection.pixelOf(p);
    ASSERT_TRUE(wanted);
    for (const double k : {0.01, 0.4, 1.0, 3.0, random.uniform(0.01, 100)}) {
      const VertexRay ray = makeVertexRay({scene.optic, scene.eye, k, {}}, p);
      ASSERT_EQ(ray.status, PathStatus::mapped);
      // S is met by the ray that goes to Q, and Q is seen where P is.
      const auto seen = projection.pixelOf(ray.legs.back().start);
      ASSERT_TRUE(seen);
      EXPECT_LT(glm::length(*seen - *wanted), 1e-9);
      const double reach = glm::length(ray.sculpture - ray.legs.back().start);
      EXPECT_LT(missDistance(scene, ray.legs.back().start, ray.sculpture), 1e-9 * reach);
      EXPECT_NEAR(reach, k * ray.distance, 1e-9 * reach);
    }
  });
}

TEST(Facts, F2DeeperStaysDeeper) {
  forScenes(everyKind, [](const RandomScene& scene, Random& random) {
    const Point near = makeRandomOriginal(scene, random, 0.05);
    const Point far = near + random.uniform(0.01, 5) * glm::normalize(near - scene.eye);
    const double k = random.uniform(0.05, 5);
    const VertexRay a = makeVertexRay({scene.optic, scene.eye, k, {}}, near),
                    b = makeVertexRay({scene.optic, scene.eye, k, {}}, far);
    ASSERT_EQ(a.status, PathStatus::mapped);
    ASSERT_EQ(b.status, PathStatus::mapped);
    // On the same reflected ray, the farther original point is the farther sculpture point.
    const double da = glm::dot(a.sculpture - a.legs.back().start, a.legs.back().direction),
                 db = glm::dot(b.sculpture - a.legs.back().start, a.legs.back().direction);
    EXPECT_LT(da, db);
  });
}

TEST(Facts, F3PlaneMirrorGivesTheMirrorImage) {
  std::size_t otherEyes = 0;
  forScenes({ShapeKind::plane}, [&](const RandomScene& scene, Random& random) {
    const auto& plane = shapeAs<PlaneMirror>(scene.optic.shape());
    const Direction n = plane.normal();
    for (int i = 0; i < 10; ++i) {
      const Point p = makeRandomOriginal(scene, random, 0.05);
      const VertexRay ray = makeVertexRay({scene.optic, scene.eye, 1, {}}, p);
      ASSERT_EQ(ray.status, PathStatus::mapped);
      const Point householder = plane.corners[0] + reflect(p - plane.corners[0], n);
      EXPECT_LT(glm::length(ray.sculpture - householder), 1e-12 * (1 + glm::length(p - scene.eye)));
      // From any other eye on the same side that sees it, the sculpture is the same.
      const Point other = scene.eye + random.point(0.3);
      const VertexRay again = makeVertexRay({scene.optic, other, 1, {}}, p);
      if (again.status != PathStatus::mapped) continue;
      ++otherEyes;
      EXPECT_LT(glm::length(again.sculpture - ray.sculpture), 1e-12 * (1 + glm::length(p - scene.eye)));
    }
  });
  EXPECT_GT(otherEyes, scenes);
}

TEST(Facts, F4CylinderKeepsTheCoordinateAlongItsAxis) {
  forScenes({ShapeKind::cylinder}, [](const RandomScene& scene, Random& random) {
    const auto& tube = shapeAs<CylinderMirror>(scene.optic.shape());
    const Direction axis = glm::normalize(tube.top - tube.bottom);
    const Point p = makeRandomOriginal(scene, random, 0.05);
    const VertexRay ray = makeVertexRay({scene.optic, scene.eye, 1, {}}, p);
    ASSERT_EQ(ray.status, PathStatus::mapped);
    EXPECT_NEAR(glm::dot(ray.sculpture - tube.bottom, axis), glm::dot(p - tube.bottom, axis),
                1e-13 * (1 + glm::length(p - scene.eye)));
  });
}

TEST(Facts, F5EyeMirrorPointSculptureAndNormalAreInOnePlane) {
  forScenes(everyKind, [](const RandomScene& scene, Random& random) {
    const Point p = makeRandomOriginal(scene, random, 0.05);
    const VertexRay ray = makeVertexRay({scene.optic, scene.eye, random.uniform(0.1, 4), {}}, p);
    ASSERT_EQ(ray.status, PathStatus::mapped);
    const Direction in = glm::normalize(ray.legs.back().start - ray.eye),
                    out = glm::normalize(ray.sculpture - ray.legs.back().start);
    EXPECT_NEAR(glm::dot(glm::cross(in, out), normalAt(scene, ray.legs.back().start)), 0, 1e-12);
    EXPECT_LT(glm::length(ray.legs.back().normal - normalAt(scene, ray.legs.back().start)), 1e-12);
    if (const auto* sphere = scene.optic.shape().as<SphereMirror>()) {
      const Direction toCentre = glm::normalize(sphere->centre - ray.legs.back().start);
      EXPECT_NEAR(glm::dot(glm::cross(in, out), toCentre), 0, 1e-12);
    }
  });
}

TEST(Facts, F6EqualAnglesAndEqualLengths) {
  forScenes(everyKind, [](const RandomScene& scene, Random& random) {
    const Point p = makeRandomOriginal(scene, random, 0.05);
    const VertexRay ray = makeVertexRay({scene.optic, scene.eye, 1, {}}, p);
    ASSERT_EQ(ray.status, PathStatus::mapped);
    const Direction toEye = glm::normalize(ray.eye - ray.legs.back().start),
                    out = glm::normalize(ray.sculpture - ray.legs.back().start);
    const Direction n = normalAt(scene, ray.legs.back().start);
    EXPECT_NEAR(glm::dot(toEye, n), glm::dot(out, n), 1e-12);
    EXPECT_NEAR(ray.legs.back().angleOutDegrees, degrees(std::acos(glm::dot(out, ray.legs.back().normal))),
                1e-5);
    const double through =
        glm::length(ray.legs.back().start - ray.eye) + glm::length(ray.sculpture - ray.legs.back().start);
    EXPECT_NEAR(through, glm::length(p - ray.eye), 1e-12 * through);
  });
}

TEST(Facts, F7NoFoldOnConvexMirrors) {
  std::size_t tested = 0;
  forScenes(everyKind, [&](const RandomScene& scene, Random& random) {
    // A patch across the view: small front-facing triangles, wound alike as seen from the eye.
    const Direction forward = glm::normalize(scene.onMirror - scene.eye);
    const Frame frame = makeFrame(forward, random.direction());
    const double beyond = random.uniform(0.5, 4), k = random.uniform(0.1, 3);
    for (int i = 0; i < 10; ++i) {
      const Point centre = makeRandomOriginal(scene, random, 0.05) + beyond * forward;
      const double size = 1e-3;
      const Vector lean1 = random.uniform(-0.5, 0.5) * forward, lean2 = random.uniform(-0.5, 0.5) * forward;
      const Point a = centre, b = centre + size * (frame.right + lean1),
                  c = centre + size * (frame.up + lean2);
      const VertexRay ra = makeVertexRay({scene.optic, scene.eye, k, {}}, a);
      const VertexRay rb = makeVertexRay({scene.optic, scene.eye, k, {}}, b);
      const VertexRay rc = makeVertexRay({scene.optic, scene.eye, k, {}}, c);
      if (ra.status != PathStatus::mapped || rb.status != PathStatus::mapped ||
          rc.status != PathStatus::mapped)
        continue;
      const Vector normal = glm::cross(rb.sculpture - ra.sculpture, rc.sculpture - ra.sculpture);
      // right x up points to the eye; after one reflection the same winding is seen from behind.
      EXPECT_GT(glm::dot(normal, ra.legs.back().direction), 0);
      ++tested;
    }
  });
  EXPECT_GT(tested, 3 * scenes);
}

TEST(Facts, F8HalvingAnEdgeQuartersItsError) {
  for (const ShapeKind kind : curvedShapeKinds) {
    std::vector<double> ratios;
    for (unsigned seed = 0; seed < scenes; ++seed) {
      Random random(seed);
      const RandomScene scene = makeRandomScene(kind, random);
      Camera camera;
      camera.eye = scene.eye;
      camera.target = scene.onMirror;
      const Projection projection(camera, 1024, 1024);
      const VertexMap map{scene.optic, scene.eye, 1, {}};
      const EdgeJudge judge{map, projection};
      const auto end = [&](const Point& p) {
        const MappedPoint mapped = mapPoint(map, p);
        return EdgeEnd{p, mapped.point, mapped.status};
      };
      const Point a = makeRandomOriginal(scene, random, 0.02),
                  b = a + random.point(0.02 * glm::length(a - scene.eye));
      const EdgeEnd from = end(a), middle = end(0.5 * (a + b)), to = end(b);
      if (from.status != PathStatus::mapped || to.status != PathStatus::mapped) continue;
      const double whole = edgeErrorPixels(judge, from, to);
      const double half = std::max(edgeErrorPixels(judge, from, middle), edgeErrorPixels(judge, middle, to));
      if (whole > 0.01 && whole < 5) ratios.push_back(half / whole);
    }
    ASSERT_GT(ratios.size(), 200u);
    std::sort(ratios.begin(), ratios.end());
    EXPECT_NEAR(ratios[ratios.size() / 2], 0.25, 0.02);
    EXPECT_NEAR(ratios[ratios.size() / 10], 0.25, 0.1);
    EXPECT_NEAR(ratios[ratios.size() * 9 / 10], 0.25, 0.1);
  }
}

TEST(MapPoints, AgreesWithOneVertexAfterTheOtherForAnyThreadCount) {
  forScenes(everyKind, [](const RandomScene& scene, Random& random) {
    PointArray original;
    const int count = random.integer(1, 300);
    for (int i = 0; i < count; ++i) {
      original.push_back(random.integer(0, 2) ? makeRandomOriginal(scene, random, 1) : random.point(20));
    }
    original.push_back(scene.eye);
    const double k = random.uniform(0.1, 4);
    MappedPoints mapped;
    mapPointsThrough({scene.optic, scene.eye, k, {}}, original, mapped, random.integer(1, 4));
    for (std::size_t i = 0; i < original.size(); ++i) {
      const MappedPoint one = mapPoint({scene.optic, scene.eye, k, {}}, original[i]);
      ASSERT_EQ(mapped.points[i], one.point) << i;
      ASSERT_EQ(mapped.status[i], one.status) << i;
      ASSERT_TRUE(isFinite(mapped.points[i]));
    }
  });
}

}  // namespace
}  // namespace anamorph
