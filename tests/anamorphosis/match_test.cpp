#include "anamorphosis/match.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "anamorphosis/vertex_ray.h"
#include "geometry/shapes.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

MatchInput matchInput(const DeformInput& deform, Sculpture sculpture, int size = 128) {
  MatchInput input;
  input.original = deform.original;
  input.originalBvh = std::make_shared<const Bvh>(deform.original->positions, deform.original->triangles);
  input.sculptureBvh = std::make_shared<const Bvh>(sculpture.mesh.positions, sculpture.mesh.triangles);
  input.sculpture = std::make_shared<const Sculpture>(std::move(sculpture));
  input.optic = deform.map.optic;
  input.camera = deform.camera;
  input.width = input.height = size;
  return input;
}

DeformInput makeInput(Shape mirror, Mesh mesh, const Point& position, double scale) {
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return position + scale * p; });
  DeformInput input;
  input.original = std::make_shared<const Mesh>(std::move(mesh));
  input.map.optic.shape() = mirror;
  input.camera.target = position;
  input.map.depthScale = 0.4;
  input.imageSize = 128;
  return input;
}

DeformInput cylinderInput(Mesh mesh) {
  DeformInput input =
      makeInput(CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3}, std::move(mesh), {0, 5.4, 0.8}, 0.7);
  input.map.eye = input.camera.eye = {0, -13.6, 9.8};
  return input;
}

DeformInput sphereInput(Mesh mesh) {
  DeformInput input = makeInput(SphereMirror{{0, 0, 4}, 4}, std::move(mesh), {0, 5.2, 1.7}, 0.7);
  input.map.eye = input.camera.eye = {0, -9.9, 15.9};
  return input;
}

DeformInput planeInput(Mesh mesh) {
  DeformInput input =
      makeInput(PlaneMirror{{Point(-8, 0, 0), Point(8, 0, 0), Point(8, 0, 8), Point(-8, 0, 8)}},
                std::move(mesh), {0, 3.4, 1}, 1);
  input.map.eye = input.camera.eye = {0, -11.9, 6.5};
  input.map.depthScale = 1;
  return input;
}

Mesh box(int segments = 16) {
  return makeBox({6, 2, 2}, segments);
}

MatchReport reportOf(const DeformInput& deform, Sculpture sculpture) {
  return computeMatch(matchInput(deform, std::move(sculpture))).report;
}

// Every triangle asked in double, no tree: Moeller and Trumbore's test.
struct BruteHit {
  double t = infinity;
  std::uint32_t triangle = 0;
  double u = 0, v = 0;
};

BruteHit bruteForce(const Mesh& mesh, const Ray& ray) {
  BruteHit best;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& corners = mesh.triangles[i];
    const Point a = mesh.positions[corners[0]];
    const Vector e1 = mesh.positions[corners[1]] - a, e2 = mesh.positions[corners[2]] - a;
    const Vector p = glm::cross(ray.direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0) continue;
    const Vector s = ray.origin - a;
    const double u = glm::dot(s, p) / determinant;
    const Vector q = glm::cross(s, e1);
    const double v = glm::dot(ray.direction, q) / determinant, t = glm::dot(e2, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < best.t) best = {t, i, u, v};
  }
  return best;
}

struct BruteFigures {
  std::size_t both = 0, either = 0, original = 0, hidden = 0, missed = 0;
  double errorSum = 0, errorMax = 0;
};

BruteFigures bruteFigures(const MatchInput& input) {
  BruteFigures figures;
  const Projection projection(input.camera, input.width, input.height);
  const Sculpture& s = *input.sculpture;
  for (int y = 0; y < input.height; ++y) {
    for (int x = 0; x < input.width; ++x) {
      const Pixel centre = matchSample(x, y);
      const Ray ray = projection.rayThrough(centre);
      const bool direct = bruteForce(*input.original, ray).t < infinity;
      const auto mirror = intersect(input.optic.shape(), ray);
      const bool blocked = bruteForce(s.mesh, ray).t < (mirror ? mirror->t : infinity);
      bool reflected = false;
      if (mirror && !blocked) {
        const BruteHit hit = bruteForce(
            s.mesh,
            {mirror->point, ray.direction - 2 * glm::dot(ray.direction, mirror->normal) * mirror->normal});
        reflected = hit.t < infinity;
        if (reflected && direct) {
          const Triangle& t = s.mesh.triangles[hit.triangle];
          const Point p =
              (1 - hit.u - hit.v) * s.original[t[0]] + hit.u * s.original[t[1]] + hit.v * s.original[t[2]];
          const double error = glm::length(*projection.pixelOf(p) - centre);
          figures.errorSum += error;
          figures.errorMax = std::max(figures.errorMax, error);
        }
      }
      figures.both += direct && reflected;
      figures.either += direct || reflected;
      figures.original += direct;
      figures.hidden += direct && mirror && blocked;
      figures.missed += direct && !mirror;
    }
  }
  return figures;
}

TEST(Match, AgreesWithBruteForce) {
  for (DeformInput deform : {planeInput(box(3)), cylinderInput(box(3)), sphereInput(box(3)),
                             cylinderInput(makePawn(3, 8)), sphereInput(makeLetterF(3, 1))}) {
    for (const double tolerance : {0.0, 1.0}) {
      for (const double lift : {0.0, -7.0}) {  // a low eye: the sculpture hides itself
        DeformInput changed = deform;
        changed.tolerancePixels = tolerance;
        changed.camera.eye.z += lift;
        const MatchInput input = matchInput(changed, makeSculpture(changed), 96);
        const MatchReport report = computeMatch(input).report;
        const BruteFigures figures = bruteFigures(input);
        ASSERT_GT(figures.original, 30u);
        const double pixel =
            1.0 / static_cast<double>(figures.original);  // rays through an edge may go either way
        EXPECT_NEAR(report.silhouetteIou, double(figures.both) / double(figures.either), 2 * pixel);
        EXPECT_NEAR(report.hiddenShare, double(figures.hidden) * pixel, 2 * pixel);
        EXPECT_NEAR(report.missedShare, double(figures.missed) * pixel, 2 * pixel);
        if (figures.both == 0) continue;
        EXPECT_NEAR(report.meanPx, figures.errorSum / double(figures.both), 0.02);
        EXPECT_NEAR(report.maxPx, figures.errorMax, 0.1 + 0.02 * figures.errorMax);
      }
    }
  }
}

TEST(Match, ExactSculptureIsExcellent) {
  for (const DeformInput& deform :
       {planeInput(box()), cylinderInput(box()), sphereInput(box()),
        cylinderInput(makeTorusKnot(2, 3, 0.3, 96, 12)), sphereInput(makePawn(2.5, 32))}) {
    const MatchReport report = reportOf(deform, makeSculpture(deform));
    EXPECT_GE(report.silhouetteIou, 0.995);
    EXPECT_LE(report.p99Px, 0.25);
    EXPECT_GE(report.triangleAgreement, 0.995);
    EXPECT_EQ(gradeOf(report), MatchGrade::excellent);
  }
}

TEST(Match, EdgeAlongARowOfPixelsDoesNotDecideTheRow) {
  // The eye at the height of the object's middle: its edges are level and fall between pixel centres or on
  // them, depending on the size alone. The grade must not.
  DeformInput deform = cylinderInput(makeLetterF(4, 4));
  for (const int size : {127, 128, 129, 256}) {
    deform.imageSize = size;
    const MatchReport report = computeMatch(matchInput(deform, makeSculpture(deform), size)).report;
    EXPECT_EQ(gradeOf(report), MatchGrade::excellent) << size << ": " << report.silhouetteIou;
  }
}

TEST(Match, SamplesLieInTheirPixelsAndAreSpread) {
  double sumX = 0, sumY = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const Pixel p = matchSample(x, y);
      ASSERT_TRUE(p.x > x && p.x < x + 1 && p.y > y && p.y < y + 1);
      sumX += p.x - x;
      sumY += p.y - y;
    }
  }
  EXPECT_NEAR(sumX / 10000, 0.5, 0.01);
  EXPECT_NEAR(sumY / 10000, 0.5, 0.01);
}

TEST(Match, SameForEveryThreadCount) {
  const DeformInput deform = cylinderInput(box(4));
  const MatchInput input = matchInput(deform, makeSculpture(deform));
  const Match one = computeMatch(input, 1), four = computeMatch(input, 4);
  EXPECT_EQ(one.classes, four.classes);
  EXPECT_EQ(one.report.meanPx, four.report.meanPx);
  EXPECT_EQ(one.report.p99Px, four.report.p99Px);
}

// The score is not fooled.

TEST(Match, ShiftedSculptureScoresWorse) {
  for (const DeformInput& deform : {planeInput(box()), cylinderInput(box()), sphereInput(box())}) {
    Sculpture s = makeSculpture(deform);
    const double shift = 0.02 * boundingBox(s.mesh.positions).diagonal();
    s.mesh.positions = mapPoints(s.mesh.positions, [&](const Point& p) { return p + Vector(shift, 0, 0); });
    const MatchReport report = reportOf(deform, std::move(s));
    EXPECT_LT(report.silhouetteIou, 0.995);
    EXPECT_GT(report.meanPx, 0.5);
    EXPECT_NE(gradeOf(report), MatchGrade::excellent);
  }
}

TEST(Match, WrongOrderOfDepthScoresWorse) {
  // d falls with |PQ|: every vertex is still on its own vertex ray, so the silhouette stays nearly right
  // (fact F1), but what was behind is now in front (fact F2).
  for (const DeformInput& deform : {planeInput(box()), cylinderInput(box()), sphereInput(box())}) {
    Sculpture s = makeSculpture(deform);
    std::vector<VertexRay> rays;
    double nearest = infinity, farthest = 0;
    for (std::size_t i = 0; i < s.original.size(); ++i) {
      rays.push_back(makeVertexRay({deform.map.optic, deform.camera.eye, 1, {}}, s.original[i]));
      nearest = std::min(nearest, rays[i].distance);
      farthest = std::max(farthest, rays[i].distance);
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const double distance = deform.map.depthScale * (nearest + farthest - rays[i].distance);
      s.mesh.positions.set(i, rays[i].legs.back().start + distance * rays[i].legs.back().direction);
    }
    const MatchReport report = reportOf(deform, std::move(s));
    EXPECT_GT(report.silhouetteIou, 0.8);
    EXPECT_LT(report.triangleAgreement, 0.5);
    EXPECT_NE(gradeOf(report), MatchGrade::excellent);
    EXPECT_NE(gradeOf(report), MatchGrade::match);
  }
}

TEST(Match, SelfHiddenSculptureScoresWorse) {
  DeformInput deform = cylinderInput(box());
  deform.map.eye =
      deform.camera.eye = {0, -12, 1};  // level with the object: the sculpture stands in its own light
  deform.map.depthScale = 1;
  const MatchReport report = reportOf(deform, makeSculpture(deform));
  EXPECT_GT(report.hiddenShare, 0.3);
  EXPECT_LT(report.silhouetteIou, 0.7);
  EXPECT_NE(gradeOf(report), MatchGrade::excellent);
}

TEST(Match, EmptySculptureScoresNothing) {
  const DeformInput deform = cylinderInput(box(2));
  const MatchReport report = reportOf(deform, Sculpture{});
  EXPECT_EQ(report.silhouetteIou, 0);
  EXPECT_EQ(report.comparedPixels, 0u);
  EXPECT_EQ(gradeOf(report), MatchGrade::none);
}

TEST(Match, MirrorTooSmallIsMissed) {
  DeformInput deform = cylinderInput(box());
  deform.map.optic.shape() = CylinderMirror{{0, 0, 0}, {0, 0, 10}, 0.8};
  const MatchReport report = reportOf(deform, makeSculpture(deform));
  EXPECT_GT(report.missedShare, 0.2);
  EXPECT_NE(gradeOf(report), MatchGrade::excellent);
}

TEST(Match, TheThesisFormulasScoreWorse) {
  // Each published mistake alone (method section 3): direction, distance, and the cylinder's normal.
  const DeformInput deform = cylinderInput(box());
  const auto& tube = shapeAs<CylinderMirror>(deform.map.optic.shape());
  for (int mistake = 0; mistake < 3; ++mistake) {
    SCOPED_TRACE(mistake);
    Sculpture s = makeSculpture(deform);
    for (std::size_t i = 0; i < s.original.size(); ++i) {
      const Point p = s.original[i];
      const VertexRay ray = makeVertexRay({deform.map.optic, deform.camera.eye, 1, {}}, p);
      const Direction in = glm::normalize(p - deform.camera.eye);
      Direction normal = ray.legs.back().normal;
      if (mistake == 2) normal = glm::normalize(ray.legs.back().start - 0.5 * (tube.bottom + tube.top));
      const Direction out = in - 2 * glm::dot(in, normal) * normal;
      const double distance =
          mistake == 1 ? glm::length((p - deform.camera.eye) - ray.legs.back().start) : ray.distance;
      s.mesh.positions.set(i, ray.legs.back().start + distance * 0.4 * (mistake == 0 ? -out : out));
    }
    const MatchReport report = reportOf(deform, std::move(s));
    if (mistake == 1) {
      // A wrong distance is invisible from the eye (F1) unless it breaks the order: that is the lesson.
      EXPECT_GT(report.silhouetteIou, 0.9);
    } else {
      EXPECT_LT(report.silhouetteIou, 0.8);
      EXPECT_NE(gradeOf(report), MatchGrade::excellent);
    }
  }
}

// Grades go by figures that mean the same for large and small things.
TEST(Match, ThinAndSmallOriginalsAreAsGoodAsTheirOutlines) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    testing::Random random(seed);
    DeformInput deform = seed % 2 == 0 ? sphereInput(box()) : cylinderInput(box());
    Mesh thin = seed % 3 == 0 ? makeTorusKnot(2, 3, random.uniform(0.01, 0.05), 400, 8)
                              : makeBox({random.uniform(0.5, 4), 0.04, random.uniform(0.02, 0.2)}, 12);
    const Point middle = boundingBox(deform.original->positions).centre();
    const double scale = random.uniform(0.1, 0.5);
    thin.positions = mapPoints(thin.positions, [&](const Point& p) { return middle + scale * p; });
    deform.original = std::make_shared<const Mesh>(std::move(thin));
    const MatchReport report = computeMatch(matchInput(deform, makeSculpture(deform), 512)).report;
    if (report.hiddenShare + report.missedShare > 0 || gradeOf(report) == MatchGrade::tooSmall) continue;
    EXPECT_EQ(gradeOf(report), MatchGrade::excellent)
        << "outline " << report.contourPx << ", p99 " << report.p99Px << ", agreement "
        << report.triangleAgreement << ", extra " << report.extraShare << ", " << report.originalPixels
        << " px";
  }
}

// A quarter of a pixel is two of its triangles here: the pixel shows another triangle, and no wrong one.
TEST(Match, FineOriginalsAgreeThoughTheErrorIsLargerThanTheirTriangles) {
  DeformInput deform = planeInput(makeBox({1.5, 0.5, 1}, 100));
  const Point middle = deform.camera.target;
  deform.original = std::make_shared<const Mesh>(
      Mesh{mapPoints(deform.original->positions, [&](const Point& p) { return middle + 0.2 * (p - middle); }),
           deform.original->triangles});
  Sculpture s = makeSculpture(deform);
  s.mesh.positions = mapPoints(s.mesh.positions, [](const Point& p) { return p + Vector(0.006, 0, 0); });
  const MatchReport report = computeMatch(matchInput(deform, std::move(s), 512)).report;
  EXPECT_GT(report.meanPx, 0.15);
  EXPECT_GE(report.triangleAgreement, 0.99);
  EXPECT_NE(gradeOf(report), MatchGrade::partial);
}

TEST(Match, GradesAreWorseTheFartherAwayTheSculptureIs) {
  const DeformInput deform = sphereInput(box());
  MatchGrade last = MatchGrade::excellent;
  for (const double shift : {0.0, 0.01, 0.03, 0.1, 0.4}) {
    Sculpture s = makeSculpture(deform);
    s.mesh.positions = mapPoints(s.mesh.positions, [&](const Point& p) { return p + Vector(shift, 0, 0); });
    const MatchGrade grade = gradeOf(computeMatch(matchInput(deform, std::move(s), 512)).report);
    EXPECT_GE(grade, last) << shift;
    last = grade;
  }
  EXPECT_EQ(last, MatchGrade::poor);
}

TEST(Match, FewPixelsHaveNoGrade) {
  DeformInput deform = sphereInput(box());
  deform.camera.fovDegrees = 170;
  const MatchReport report = reportOf(deform, makeSculpture(deform));
  EXPECT_LT(report.originalPixels, 16u);
  EXPECT_EQ(gradeOf(report), MatchGrade::tooSmall);
}

TEST(Match, WhatIsSeenBesideTheOriginalIsExtra) {
  const DeformInput deform = planeInput(makeBox({2, 2, 2}, 4));
  Sculpture twice = makeSculpture(deform);
  const Mesh other = twice.mesh;
  const auto first = static_cast<std::uint32_t>(other.positions.size());
  for (std::size_t i = 0; i < first; ++i) {
    twice.mesh.positions.push_back(other.positions[i] + Vector(3, 0, 0));
    twice.original.push_back(twice.original[i]);
  }
  for (std::size_t i = 0; i < other.triangles.size(); ++i) {
    const Triangle& t = other.triangles[i];
    twice.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    twice.sourceTriangle.push_back(twice.sourceTriangle[i]);
  }
  const MatchReport report = reportOf(deform, std::move(twice));
  EXPECT_NEAR(report.extraShare, 1, 0.4);
  EXPECT_NE(gradeOf(report), MatchGrade::excellent);
  EXPECT_EQ(report.hiddenShare, 0);
}

}  // namespace
}  // namespace anamorph
