#include "pipeline/live.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "anamorphosis/vertex_ray.h"
#include "geometry/shapes.h"
#include "pipeline/changing_levels.h"
#include "pipeline/picture.h"
#include "pipeline/stages.h"
#include "pipeline/worker.h"

namespace anamorph {
namespace {

using namespace testing;

PreparedSculpture settledSculpture(const Level& level, const PreparedMesh& original) {
  return prepareSculpture(makeSculpture(makeDeformInput(level, original.mesh)));
}

bool wholeTriangle(const Sculpture& sculpture, const Triangle& t) {
  return sculpture.status[t[0]] == PathStatus::mapped && sculpture.status[t[1]] == PathStatus::mapped &&
         sculpture.status[t[2]] == PathStatus::mapped;
}

/// The share of rays through the mesh's box for which two trees give another answer. Indices of the second
/// one are those of `indexOf`.
double differingHits(const Bvh& a, const Bvh& b, const std::vector<std::uint32_t>& indexOf, const Box& box,
                     Random& random) {
  constexpr int count = 400;
  int differing = 0;
  for (int i = 0; i < count; ++i) {
    const Point target = box.centre() + 0.5 * random.point(1) * box.size();
    const Point origin = target + 2 * box.diagonal() * random.direction();
    const Ray ray{origin, glm::normalize(target - origin)};
    BvhHit hitA, hitB;
    const bool foundA = a.closestHit(ray, hitA), foundB = b.closestHit(ray, hitB);
    if (!foundA && !foundB) continue;
    differing += foundA != foundB || hitA.triangle != indexOf[hitB.triangle] ||
                 std::abs(hitA.t - hitB.t) > 1e-9 * (1 + hitB.t);
  }
  return double(differing) / count;
}

/// All that follow() promises, from the level and the placed original alone.
void expectMapped(const PreparedSculpture& live, const Level& level, const Mesh& original, Random& random) {
  const Sculpture& sculpture = *live.sculpture;
  const std::size_t count = sculpture.original.size();
  ASSERT_EQ(sculpture.mesh.positions.size(), count);
  ASSERT_EQ(sculpture.status.size(), count);
  ASSERT_EQ(sculpture.source.size(), count);
  std::size_t wrong = 0, misplaced = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const VertexSource& source = sculpture.source[i];
    const auto& [a, b, c] = original.triangles[source.triangle];
    const Point p = (1 - source.u - source.v) * original.positions[a] + source.u * original.positions[b] +
                    source.v * original.positions[c];
    misplaced += !(glm::length(sculpture.original[i] - p) <= 1e-12 * (1 + glm::length(p)));
    const MappedPoint mapped = mapPoint(makeVertexMap(level), sculpture.original[i]);
    wrong += sculpture.mesh.positions[i] != mapped.point || sculpture.status[i] != mapped.status;
  }
  EXPECT_EQ(misplaced, 0u);
  EXPECT_EQ(wrong, 0u);
  StatusCounts counts{};
  for (std::size_t i = 0; i < original.positions.size(); ++i) {
    const auto mapped = mapPoint(makeVertexMap(level), original.positions[i]);
    ++counts[static_cast<std::size_t>(mapped.status)];
  }
  EXPECT_EQ(sculpture.originalStatus, counts);

  ASSERT_EQ(live.prepared.mesh.get(), &sculpture.mesh);
  EXPECT_EQ(*live.prepared.normals,
            computeNormals(sculpture.mesh.positions, sculpture.mesh.triangles, *live.prepared.normalGroups));
  Mesh whole{sculpture.mesh.positions, {}};
  std::vector<std::uint32_t> indexOf;
  Box box;
  for (std::uint32_t t = 0; t < sculpture.mesh.triangles.size(); ++t) {
    const Triangle& corners = sculpture.mesh.triangles[t];
    if (!wholeTriangle(sculpture, corners)) continue;
    whole.triangles.push_back(corners);
    indexOf.push_back(t);
    for (const std::uint32_t corner : corners) box.extend(sculpture.mesh.positions[corner]);
  }
  if (box.empty()) {
    for (int i = 0; i < 100; ++i) {
      EXPECT_FALSE(live.prepared.bvh->anyHit({random.point(10), random.direction()}));
    }
    return;
  }
  const Bvh fresh(whole.positions, whole.triangles);
  EXPECT_LE(differingHits(*live.prepared.bvh, fresh, indexOf, box, random), 0.01)
      << "only rays beside an edge";
}

TEST(LiveOriginal, IsPlacedAsTheSettledOne) {
  const OriginalShape shapes[] = {BoxShape{{6, 2, 2}, 5}, SphereShape{1, 24},
                                  TorusKnotShape{2, 3, 0.25, 60, 8}, LetterFShape{2, 3}, PawnShape{2, 24}};
  for (const OriginalShape& shape : shapes) {
    for (unsigned seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE("shape " + std::to_string(shape.index()) + ", seed " + std::to_string(seed));
      Random random(seed);
      const auto mesh = loadOriginal(shape, "level.json").mesh;
      LiveOriginal live(mesh, prepareMesh(placeOriginal(*mesh, seed == 1, {})));
      for (int i = 0; i < 4; ++i) {
        const bool unitized = i % 2 == 1;
        Placement placement{random.point(10), random.point(180), Vector(random.uniform(0.1, 3))};
        const PreparedMesh placed = live.place(unitized, placement, 1 + i);
        const auto wanted = placeOriginal(*mesh, unitized, placement);
        EXPECT_EQ(*placed.mesh, *wanted);
        const PreparedMesh fresh = prepareMesh(wanted);
        double worst = 0;
        const NormalGroups &groups = *placed.normalGroups, &freshGroups = *fresh.normalGroups;
        ASSERT_EQ(groups.corners.size(), freshGroups.corners.size());
        for (std::size_t t = 0; t < groups.corners.size(); ++t) {
          for (int c = 0; c < 3; ++c) {
            const glm::vec3 difference =
                (*placed.normals)[groups.corners[t][c]] - (*fresh.normals)[freshGroups.corners[t][c]];
            worst = std::max(worst, double(glm::length(difference)));
          }
        }
        EXPECT_LT(worst, 1e-4);
        std::vector<std::uint32_t> same(wanted->triangles.size());
        for (std::uint32_t t = 0; t < same.size(); ++t) same[t] = t;
        EXPECT_LE(differingHits(*placed.bvh, *fresh.bvh, same, boundingBox(wanted->positions), random), 0.01);
      }
      // Any other placement, also one without size, at least has the right points and sound normals.
      for (const Vector& scale : {Vector(0.1, 2, 1), Vector(1, 0, 1), Vector(0)}) {
        const Placement placement{random.point(10), random.point(180), scale};
        const PreparedMesh placed = live.place(false, placement, 2);
        EXPECT_EQ(*placed.mesh, *placeOriginal(*mesh, false, placement));
        for (const glm::vec3& n : *placed.normals) EXPECT_NEAR(glm::length(n), 1, 1e-5);
      }
    }
  }
}

TEST(LiveSculpture, FollowsAsTheMapSays) {
  int whole = 0, partly = 0, none = 0;
  const std::vector<Level> levels = quickLevels();
  for (std::size_t which = 0; which < levels.size(); ++which) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE("level " + std::to_string(which) + ", seed " + std::to_string(seed));
      Random random(seed);
      Level start = levels[which];
      if (seed % 4 == 3) start.sculpture.tolerancePixels = 0;
      const auto shape = loadOriginal(start.original.shape, "level.json").mesh;
      const PreparedMesh original = prepareMesh(placedOriginal(start));
      LiveOriginal liveOriginal(shape, original);
      LiveSculpture live(original, settledSculpture(start, original));
      for (int i = 0; i < 6; ++i) {
        const Level level = changed(start, random, i < 3 ? 0.3 : 4);
        const PreparedMesh placed =
            liveOriginal.place(level.original.unitize, level.original.placement, 1 + i % 3);
        if (findProblem(level, placed.box)) continue;
        const PreparedSculpture followed = live.follow(makeVertexMap(level), placed.mesh, 1 + i % 3);
        expectMapped(followed, level, *placed.mesh, random);
        const StatusCounts& counts = followed.sculpture->originalStatus;
        (counts[0] == placed.mesh->positions.size() ? whole : counts[0] > 0 ? partly : none) += 1;
      }
    }
  }
  EXPECT_GT(whole, 30);
  EXPECT_GT(partly, 10);
}

TEST(LiveSculpture, KeepsTheRefinedTrianglesOfAWholeSculpture) {
  for (const Level& level : quickLevels()) {
    const PreparedMesh original = prepareMesh(placedOriginal(level));
    const PreparedSculpture settled = settledSculpture(level, original);
    LiveSculpture live(original, settled);
    const PreparedSculpture same = live.follow(makeVertexMap(level), original.mesh, 1);
    EXPECT_EQ(same.sculpture->mesh.triangles, settled.sculpture->mesh.triangles);
    double worst = 0;
    for (std::size_t i = 0; i < same.sculpture->mesh.positions.size(); ++i) {
      worst = std::max(worst,
                       glm::length(same.sculpture->mesh.positions[i] - settled.sculpture->mesh.positions[i]));
    }
    EXPECT_LT(worst, 1e-9) << "nothing has moved";
    EXPECT_EQ(same.sculpture->originalStatus, settled.sculpture->originalStatus);
  }
}

TEST(LiveSculpture, IsTheSameForEveryNumberOfThreads) {
  Random random(3);
  Level level = installedLevel("3-sphere");
  const PreparedMesh original = prepareMesh(placedOriginal(level));
  const PreparedSculpture settled = settledSculpture(level, original);
  LiveSculpture live(original, settled);
  level.camera.eye += Vector(0.3, 0.2, 0.1);
  const PreparedSculpture one = live.follow(makeVertexMap(level), original.mesh, 1);
  const PreparedSculpture four = live.follow(makeVertexMap(level), original.mesh, 4);
  EXPECT_NE(one.sculpture, four.sculpture) << "the first one is still held";
  EXPECT_EQ(one.sculpture->mesh, four.sculpture->mesh);
  EXPECT_EQ(one.sculpture->status, four.sculpture->status);
  EXPECT_EQ(*one.prepared.normals, *four.prepared.normals);
  EXPECT_EQ(one.prepared.bvh->nodes(), four.prepared.bvh->nodes());
}

// A copy of everything that a held result must go on to be.
struct Snapshot {
  explicit Snapshot(const PreparedSculpture& held)
      : mesh(held.sculpture->mesh),
        original(held.sculpture->original),
        status(held.sculpture->status),
        normals(*held.prepared.normals),
        nodes(held.prepared.bvh->nodes()) {}
  bool operator==(const Snapshot&) const = default;

  Mesh mesh;
  PointArray original;
  std::vector<PathStatus> status;
  std::vector<glm::vec3> normals;
  std::vector<BvhNode> nodes;
};

TEST(LiveSculpture, WhatIsHeldStaysAsItIsWhileLaterFramesAreMade) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Level start = quickLevels()[seed % 3];
    const auto shape = loadOriginal(start.original.shape, "level.json").mesh;
    const PreparedMesh original = prepareMesh(placedOriginal(start));
    LiveOriginal liveOriginal(shape, original);
    LiveSculpture live(original, settledSculpture(start, original));
    std::vector<std::pair<PreparedSculpture, Snapshot>> held;
    std::vector<std::pair<PreparedMesh, Mesh>> heldOriginals;
    for (int i = 0; i < 40; ++i) {
      const Level level = changed(start, random, 0.5);
      const PreparedMesh placed = liveOriginal.place(false, level.original.placement, 2);
      if (findProblem(level, placed.box)) continue;
      const PreparedSculpture followed = live.follow(makeVertexMap(level), placed.mesh, 2);
      if (random.integer(0, 2) == 0) {
        held.emplace_back(followed, followed);
        heldOriginals.emplace_back(placed, *placed.mesh);
      }
      if (random.integer(0, 4) == 0 && !held.empty())
        held.erase(held.begin() + random.integer(0, int(held.size()) - 1));
      for (const auto& [result, copy] : held) ASSERT_EQ(Snapshot(result), copy) << "frame " << i;
      for (const auto& [result, copy] : heldOriginals) ASSERT_EQ(*result.mesh, copy) << "frame " << i;
    }
  }
}

TEST(LiveSculpture, ResultsMayBeLetGoByAnotherThread) {
  // As a picture in high resolution does, while the drag goes on. The ThreadSanitizer's build tells.
  Level level = quickLevels()[1];
  const PreparedMesh original = prepareMesh(placedOriginal(level));
  LiveSculpture live(original, settledSculpture(level, original));
  Mailbox<PreparedSculpture> box;
  std::atomic<bool> done{false};
  std::atomic<int> read{0};
  std::thread reader([&] {
    while (!done) {
      if (const auto held = box.take()) {
        read += boundingBox(held->sculpture->mesh.positions).empty() ? 0 : 1;
      }
    }
  });
  for (int i = 0; i < 100; ++i) {
    level.camera.eye.x += 0.01;
    box.put(live.follow(makeVertexMap(level), original.mesh, 1));
    if (i % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  done = true;
  reader.join();
  EXPECT_GT(read, 0);
}

TEST(LiveSculpture, PartsOfAResultKeepTheWholeBuffer) {
  Level level = quickLevels()[0];
  const PreparedMesh original = prepareMesh(placedOriginal(level));
  LiveSculpture live(original, settledSculpture(level, original));
  const auto mesh =
      live.follow(makeVertexMap(level), original.mesh, 1).prepared.mesh;  // all the rest is let go
  const Mesh copy = *mesh;
  level.camera.eye.x += 1;
  level.sculpture.depthScale = 0.5;
  live.follow(makeVertexMap(level), original.mesh, 1);
  EXPECT_EQ(*mesh, copy);
}

TEST(LiveSculpture, BuffersThatNobodyHoldsAreUsedAgain) {
  Level level = quickLevels()[1];
  const PreparedMesh original = prepareMesh(placedOriginal(level));
  LiveSculpture live(original, settledSculpture(level, original));
  LiveOriginal liveOriginal(loadOriginal(level.original.shape, "level.json").mesh, original);
  std::set<const void*> sculptures, originals;
  PreparedSculpture shown;
  PreparedMesh placed;
  for (int i = 0; i < 20; ++i) {
    level.camera.eye.x += 0.01;
    placed = liveOriginal.place(false, level.original.placement, 1);
    shown = live.follow(makeVertexMap(level), placed.mesh, 1);
    sculptures.insert(shown.sculpture.get());
    originals.insert(placed.mesh.get());
  }
  EXPECT_LE(sculptures.size(), 3u);
  EXPECT_LE(originals.size(), 5u) << "sculptures may keep theirs";
}

TEST(LiveSculpture, UnmappedPartsGoAndComeBack) {
  for (const double tolerance : {0.0, 1.0}) {
    for (const bool startsWhole : {true, false}) {
      SCOPED_TRACE("tolerance " + std::to_string(tolerance) + (startsWhole ? ", whole" : ", in parts"));
      Random random(5);
      Level whole = quickLevels()[0];
      whole.sculpture.tolerancePixels = tolerance;
      Level parted = whole;
      parted.original.placement.position.x += 4;  // part of it is beside the mirror, seen from the eye
      const Level& start = startsWhole ? whole : parted;
      const auto shape = loadOriginal(start.original.shape, "level.json").mesh;
      const PreparedMesh original = prepareMesh(placedOriginal(start));
      const PreparedSculpture settled = settledSculpture(start, original);
      LiveOriginal liveOriginal(shape, original);
      LiveSculpture live(original, settled);
      for (const Level& level : {whole, parted, whole, parted}) {
        const PreparedMesh placed = liveOriginal.place(false, level.original.placement, 1);
        const PreparedSculpture followed = live.follow(makeVertexMap(level), placed.mesh, 1);
        const Sculpture& sculpture = *followed.sculpture;
        expectMapped(followed, level, *placed.mesh, random);
        EXPECT_EQ(sculpture.mesh.triangles,
                  startsWhole ? settled.sculpture->mesh.triangles : original.mesh->triangles);
        int hits = 0, wholeTriangles = 0;
        for (std::uint32_t t = 0; t < sculpture.mesh.triangles.size(); ++t) {
          const Triangle& corners = sculpture.mesh.triangles[t];
          const Vector area = areaVector(sculpture.mesh.positions, corners);
          if (glm::length(area) < 1e-6) continue;
          const Point middle = (sculpture.mesh.positions[corners[0]] + sculpture.mesh.positions[corners[1]] +
                                sculpture.mesh.positions[corners[2]]) /
                               3.0;
          const Direction n = glm::normalize(area);
          BvhHit hit;
          const bool found =
              followed.prepared.bvh->closestHit({middle + 1e-4 * n, -n}, hit, 0, 2e-4) && hit.triangle == t;
          wholeTriangles += wholeTriangle(sculpture, corners);
          hits += found;
          EXPECT_EQ(found, wholeTriangle(sculpture, corners)) << t;
        }
        EXPECT_EQ(hits, wholeTriangles);
        const std::size_t unmapped = placed.mesh->positions.size() - sculpture.originalStatus[0];
        if (level == whole) {
          EXPECT_EQ(unmapped, 0u);
        } else {
          EXPECT_GT(unmapped, 10u);
          EXPECT_GT(wholeTriangles, 50);
          EXPECT_LT(wholeTriangles, int(sculpture.mesh.triangles.size()));
        }
      }
    }
  }
}

TEST(LiveSculpture, StartsFromAProblemToo) {
  Level level = quickLevels()[2];
  const PreparedMesh original = prepareMesh(placedOriginal(level));
  for (const PreparedSculpture& settled : {PreparedSculpture{}, prepareSculpture({})}) {
    Random random(1);
    LiveSculpture live(original, settled);
    const PreparedSculpture followed = live.follow(makeVertexMap(level), original.mesh, 1);
    EXPECT_EQ(followed.sculpture->mesh.triangles, original.mesh->triangles);
    expectMapped(followed, level, *original.mesh, random);
  }
}

TEST(LiveSculpture, MatchesTheOriginalInPixelsToo) {
  // The same test of the result as for settled ones: what the mirror shows is the original.
  for (const Level& start : quickLevels()) {
    Level level = start;
    const auto shape = loadOriginal(start.original.shape, "level.json").mesh;
    const PreparedMesh original = prepareMesh(placedOriginal(start));
    LiveOriginal liveOriginal(shape, original);
    LiveSculpture live(original, settledSculpture(start, original));
    level.camera.eye += Vector(0.3, 0.1, 0.2);
    level.original.placement.position += Vector(0.1, 0.2, 0);
    const PreparedMesh placed = liveOriginal.place(false, level.original.placement, 1);
    const PreparedSculpture followed = live.follow(makeVertexMap(level), placed.mesh, 1);
    const Match match = computeMatch(makeMatchInput(level, placed, followed, 96, 96), 2);
    EXPECT_GT(match.report.silhouetteIou, 0.97);
    EXPECT_LT(match.report.p99Px, 1);
  }
}

}  // namespace
}  // namespace anamorph
