#include "exports/sheet_side_view.h"
#include "exports/sheet_words.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/language.h"

namespace anamorph {
namespace {

constexpr double labelColumn = 34, labelStep = 3.4, labelSize = 2.6;
constexpr double heading = 6, tableStrip = 4, topStrip = 8, sideStrip = 7;  // around the things

const Pen thin{0.12, ink::faint, {0.6, 0.8}};

std::vector<Point2> flatten(const Arrangement& arrangement, const PointArray& positions) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < positions.size(); ++i) points.push_back(arrangement.sideOf(positions[i]));
  return points;
}

// The pixel nearest to the middle of the image in which the mirror shows the sculpture.
std::optional<std::vector<Point2>> findRay(const LevelResult& finished, const Arrangement& arrangement) {
  constexpr int size = 41;
  const Level& level = finished.level;
  const Projection projection(level.camera, size, size);
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<std::vector<Point2>> found;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double distance = std::hypot(x - size / 2, y - size / 2);
      if (distance >= nearest) continue;
      const Ray ray = projection.rayThrough({x + 0.5, y + 0.5});
      const auto sight = findSight(finished, ray);
      if (!sight) continue;
      const auto toSide = [&](const Point& p) {
        return arrangement.sideOf(arrangement.millimetresPerUnit * p);
      };
      nearest = distance;
      found.emplace();
      for (const Point& point : sight->points) found->push_back(toSide(point));
    }
  }
  return found;
}

// Text baselines near their heights, at least labelStep apart: pushed down from above, then back up from
// below.
std::vector<double> spreadLabels(std::vector<double> places, double lowest) {
  for (std::size_t i = 1; i < places.size(); ++i) places[i] = std::max(places[i], places[i - 1] + labelStep);
  for (std::size_t i = places.size(); i-- > 0;) {
    const double limit = i + 1 == places.size() ? lowest : places[i + 1] - labelStep;
    places[i] = std::min(places[i], limit);
  }
  return places;
}

// 1, 1.2, 1.5, 2, ... times a power of ten: the smallest that is not below.
double roundScale(double least) {
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (step * decade >= least * (1 - 1e-9)) return step * decade;
  }
  return 10 * decade;
}

void addBox(Rectangle& box, const std::vector<Point2>& points) {
  for (const Point2& p : points) {
    box.min = glm::min(box.min, p);
    box.max = glm::max(box.max, p);
  }
}

bool isLower(const Point2& a, const Point2& b) {
  return a.y < b.y;
}

class Drawing {
 public:
  Drawing(Page& page, const SideView& view, const Rectangle& area) : page_(page), view_(view), area_(area) {
    const Point2 room = area.size() - Point2(labelColumn + sideStrip + 2, heading + topStrip + tableStrip);
    const Point2 size = glm::max(view.box.size(), Point2(1e-6));
    scale_ = roundScale(std::max(size.x / room.x, size.y / room.y));
    origin_ = {area.min.x + sideStrip - view.box.min.x / scale_,
               area.min.y + heading + topStrip + view.box.max.y / scale_};
  }

  void draw() {
    drawText(page_,
             {area_.min + Point2(0, 3), trFormat("Side view, {}, heights above the table", scaleName(scale_)),
              2.8, true, TextAlign::left, false, ink::black});
    drawTable();
    drawLabels();
    drawThings();
    drawRay();
    drawEyeHeight();
  }

 private:
  Point2 at(const Point2& p) const { return origin_ + Point2(p.x, -p.y) / scale_; }

  double rightEnd() const { return at(view_.box.max).x; }

  void drawTable() {
    const double y = at({0, 0}).y;
    drawLine(page_, {area_.min.x, y}, {rightEnd() + 3, y}, Pen{0.35, ink::black, {}});
    for (double x = area_.min.x + 1; x < rightEnd() + 3; x += 2.5)
      drawLine(page_, {x, y}, {x - 1, y + 1.2}, Pen{0.12, ink::grey, {}});
  }

  void drawShape(const std::vector<Loop>& loops, const Pen& pen, const Color& fill) {
    PageShape shape{loops, true, pen, fill};
    for (auto& line : shape.lines) {
      for (Point2& p : line) p = at(p);
    }
    page_.items.push_back(std::move(shape));
  }

  void drawThings() {
    drawShape({view_.mirror}, Pen{0.35, ink::blue, {}}, ink::lightBlue);
    if (!view_.plate.empty()) drawShape(view_.plate, Pen{0.25, ink::green, {}}, ink::lightGreen);
    drawShape(view_.sculpture, Pen{0.35, ink::vermilion, {}}, ink::lightVermilion);
  }

  void drawRay() {
    if (!view_.ray) return;
    const std::vector<Point2>& ray = *view_.ray;
    for (std::size_t i = 1; i < ray.size(); ++i) {
      const bool fromEye = i == 1 && ray.size() > 2;
      const Pen pen = fromEye ? Pen{0.25, ink::blue, {}} : Pen{0.25, ink::vermilion, {1.4, 0.8}};
      drawLine(page_, at(ray[i - 1]), at(ray[i]), pen);
    }
  }

  void drawEyeHeight() {
    const Point2 eye = at(view_.eye), foot = at({view_.eye.x, 0});
    drawLine(page_, eye, foot, Pen{0.15, ink::grey, {}});
    drawEye(page_, eye, 5);
    const std::string text = tr("eye ") + formatLength(view_.eye.y);
    drawText(page_, {{std::max(eye.x - 5, area_.min.x), eye.y - 3},
                     text,
                     labelSize,
                     false,
                     TextAlign::left,
                     false,
                     ink::black});
  }

  void drawLabels() {
    const double column = rightEnd() + 8;
    std::vector<double> places;
    for (const HeightLabel& label : view_.labels) places.push_back(at(label.at).y);
    const std::vector<double> spread = spreadLabels(places, at(view_.box.min).y + tableStrip);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Point2 bend{rightEnd() + 4, places[i]};
      drawLine(page_, at(view_.labels[i].at), bend, thin);
      drawLine(page_, bend, {column - 0.8, spread[i]}, Pen{0.12, ink::grey, {}});
      drawText(page_, {{column, spread[i] + 0.9},
                       view_.labels[i].text,
                       labelSize,
                       false,
                       TextAlign::left,
                       false,
                       ink::black});
    }
  }

  Page& page_;
  const SideView& view_;
  const Rectangle area_;
  double scale_ = 1;
  Point2 origin_{0};
};

}  // namespace

SideView makeSideView(const LevelResult& finished, const Arrangement& arrangement) {
  SideView view;
  const std::vector<Point2> mirror = flatten(arrangement, arrangement.mirrorSurface.positions);
  const std::vector<Point2> sculpture = flatten(arrangement, arrangement.sculpture.positions);
  view.mirror = convexHull(mirror);
  view.sculpture = makeSilhouette(sculpture, arrangement.sculpture.triangles, 600);
  view.eye = arrangement.sideOf(arrangement.eye);
  view.ray = findRay(finished, arrangement);
  const auto label = [&](const Point2& place, const std::string& name) {
    view.labels.push_back({place, name + " " + formatLength(place.y)});
  };
  const auto [mirrorBottom, mirrorTop] = std::minmax_element(mirror.begin(), mirror.end(), isLower);
  const auto [bottom, top] = std::minmax_element(sculpture.begin(), sculpture.end(), isLower);
  const std::string name = tr(surfaceName(finished.level.optic));
  label(*mirrorTop, name + tr(", top"));
  if (mirrorBottom->y > 0.05) label(*mirrorBottom, name + tr(", bottom"));
  label(*top, tr("sculpture, top"));
  if (bottom->y > 0.05 || arrangement.plate) label(*bottom, tr("sculpture, bottom"));
  view.box = {glm::min(view.eye, Point2(view.eye.x, 0)), view.eye};
  addBox(view.box, mirror);
  addBox(view.box, sculpture);
  if (arrangement.plate) {
    const std::vector<Point2> plate = flatten(arrangement, arrangement.plate->mesh.positions);
    const Point2 lowest = *std::min_element(plate.begin(), plate.end(), isLower);
    view.plate = makeSilhouette(plate, arrangement.plate->mesh.triangles, 600);
    if (lowest.y < -0.05) label(lowest, tr("plate, lower face"));
    addBox(view.box, plate);
  }
  std::stable_sort(view.labels.begin(), view.labels.end(),
                   [](const HeightLabel& a, const HeightLabel& b) { return a.at.y > b.at.y; });
  return view;
}

void drawSideView(Page& page, const SideView& view, const Rectangle& area) {
  Drawing(page, view, area).draw();
}

}  // namespace anamorph
