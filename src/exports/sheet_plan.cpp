#include "exports/sheet_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/language.h"
#include "exports/page_file.h"

namespace anamorph {
namespace {

// Strips around the things, millimetres of the page.
constexpr double above = 9, left = 4, below = 9, eyeStrip = 13;
constexpr double railStart = 7, railStep = 6, railEnd = 4;
constexpr double nothing = 0.05;  // millimetres: not worth a dimension

const Pen outlinePen{0.4, ink::blue, {}};
const Pen sculpturePen{0.4, ink::vermilion, {}};
const Pen platePen{0.3, ink::green, {2, 1}};
const Pen helpPen{0.12, ink::faint, {}};
const Pen centrePen{0.15, ink::grey, {4, 1, 0.6, 1}};

void extend(Rectangle& box, const Point2& p) {
  box.min = glm::min(box.min, p);
  box.max = glm::max(box.max, p);
}

Rectangle boxOf(const Loop& points) {
  Rectangle box{points.front(), points.front()};
  for (const Point2& p : points) extend(box, p);
  return box;
}

std::vector<Point2> flatten(const Arrangement& arrangement, const PointArray& positions) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < positions.size(); ++i) points.push_back(arrangement.planOf(positions[i]));
  return points;
}

// An upright plane is a line from above; rounding must not make it a very thin polygon.
Loop withoutThinness(const Loop& hull) {
  const auto farthestFrom = [&](const Point2& p) {
    return *std::max_element(hull.begin(), hull.end(), [&](const Point2& a, const Point2& b) {
      return glm::length(a - p) < glm::length(b - p);
    });
  };
  const Point2 from = farthestFrom(hull.front()), to = farthestFrom(from), way = to - from;
  const double length = glm::length(way);
  const bool isLine = std::all_of(hull.begin(), hull.end(), [&](const Point2& p) {
    return std::abs(way.x * (p.y - from.y) - way.y * (p.x - from.x)) <= 1e-6 * length * length;
  });
  return isLine ? Loop{from, to} : hull;
}

// Of what is round, or a line, from above the hull is the outline, and exact.
std::vector<Loop> outlineOf(const std::vector<Point2>& points, const Mesh& surface, bool isRound) {
  const Loop hull = withoutThinness(convexHull(points));
  if (isRound || hull.size() == 2) return {hull};
  return makeSilhouette(points, surface.triangles);
}

// By the number of sides to the right of the point: odd inside.
bool isInside(const std::vector<Loop>& loops, const Point2& p) {
  bool inside = false;
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside;
}

// A distance along the page from the middle of the mirror to a line, and where on that line it is measured.
struct Distance {
  double to;
  double from;  // across: the right end of what has this distance
};

// The edges of the sculpture nearest to and farthest from the middle, and the eye: shortest first, so that no
// line crosses another.
std::vector<Distance> distancesOf(const SheetPlan& plan, bool withEye) {
  std::vector<Distance> distances;
  const auto add = [&](double to, double from) {
    if (std::abs(to) > nothing) distances.push_back({to, from});
  };
  add(plan.sculptureBox.min.y, plan.sculptureBox.max.x);
  add(plan.sculptureBox.max.y, plan.sculptureBox.max.x);
  if (withEye) add(plan.eye.y, plan.eye.x);
  std::stable_sort(distances.begin(), distances.end(),
                   [](const Distance& a, const Distance& b) { return std::abs(a.to) < std::abs(b.to); });
  return distances;
}

double rightStrip(const SheetPlan& plan, bool withEye) {
  return railStart + railStep * double(distancesOf(plan, withEye).size()) + railEnd;
}

double lowestOf(const SheetPlan& plan, double scale, bool withEye) {
  const double things = plan.things.min.y / scale - below;
  return (withEye ? std::min(things, plan.eye.y / scale) : things) - eyeStrip;
}

class Drawing {
 public:
  Drawing(Page& page, const SheetPlan& plan, const Rectangle& area, double scale, bool withEye)
      : page_(page), plan_(plan), area_(area), scale_(scale), withEye_(withEye) {
    const double lowest = lowestOf(plan, scale, withEye), highest = plan.things.max.y / scale + above;
    const double leftmost = plan.things.min.x / scale - left;
    const double rightmost = plan.things.max.x / scale + rightStrip(plan, withEye);
    const Point2 middle = 0.5 * (area.min + area.max);
    origin_ = {middle.x - 0.5 * (leftmost + rightmost), middle.y + 0.5 * (lowest + highest)};
  }

  void draw() {
    drawWidths();
    drawDistances();
    drawMirror();
    drawSculpture();
    drawPlate();
    drawCentreLine();
    drawNames();
    drawEyePlace();
    drawAxes();
  }

 private:
  std::string surface() const { return tr(plan_.hasMirror ? "mirror" : "canvas"); }
  // Whether it is flat and upright.
  bool isLine() const { return plan_.mirror.size() == 1 && plan_.mirror.front().size() == 2; }
  // A canvas does not stand on the table: dashed.
  Pen surfacePen() const { return plan_.hasMirror ? outlinePen : Pen{0.3, ink::blue, {1.5, 1}}; }

  Point2 at(const Point2& p) const { return at(p.x, p.y); }
  Point2 at(double right, double away) const { return origin_ + Point2(right, -away) / scale_; }

  std::vector<Loop> moved(const std::vector<Loop>& loops) const {
    std::vector<Loop> result = loops;
    for (Loop& loop : result) {
      for (Point2& p : loop) p = at(p);
    }
    return result;
  }

  void drawMirror() {
    if (plan_.mirrorRadius) {
      page_.items.push_back(PageCircle{at(0, 0), *plan_.mirrorRadius / scale_, surfacePen(), ink::lightBlue});
      return;
    }
    page_.items.push_back(PageShape{moved(plan_.mirror), true, surfacePen(), ink::lightBlue});
    if (isLine() && plan_.hasMirror) drawBack();
  }

  // Short strokes on the side of an upright mirror that the eye does not see.
  void drawBack() {
    const Loop& line = plan_.mirror.front();
    const Point2 from = at(line[0]), to = at(line[1]), way = to - from;
    const double length = glm::length(way);
    if (length < 1) return;
    Point2 back = Point2(way.y, -way.x) / length;
    if (glm::dot(back, at(plan_.eye) - from) > 0) back = -back;
    const int strokes = static_cast<int>(length / 2);
    for (int i = 0; i <= strokes; ++i) {
      const Point2 p = from + way * (double(i) / std::max(strokes, 1));
      drawLine(page_, p, p + 1.6 * back + 0.8 * way / length, Pen{0.15, ink::blue, {}});
    }
  }

  void drawSculpture() {
    page_.items.push_back(PageShape{moved(plan_.sculpture), true, sculpturePen, Color(ink::lightVermilion)});
  }

  void drawPlate() {
    if (plan_.plate.empty()) return;
    page_.items.push_back(PageShape{moved({plan_.plate}), true, platePen, {}});
    for (const Point2& post : plan_.posts) {
      page_.items.push_back(PageCircle{at(post), plan_.postRadius / scale_, Pen{0.25, ink::green, {}}, {}});
    }
  }

  void drawCentreLine() {
    const double end = withEye_ ? plan_.eye.y : plan_.things.min.y - below * scale_;
    drawLine(page_, at(0, std::max(plan_.things.max.y, 0.0)) - Point2(0, 2), at(0, end), centrePen);
    const Pen cross{0.25, ink::blue, {}};
    drawLine(page_, at(0, 0) - Point2(3, 0), at(0, 0) + Point2(3, 0), cross);
    drawLine(page_, at(0, 0) - Point2(0, 3), at(0, 0) + Point2(0, 3), cross);
  }

  // A dimension across the page at height `y`, with lines down to what it measures.
  void drawWidth(double from, double to, double away, double y) {
    if (std::abs(to - from) < nothing) return;
    const double beyond = y < at(0, away).y ? -1 : 1;
    for (const double end : {from, to}) drawLine(page_, at(end, away), {at(end, 0).x, y + beyond}, helpPen);
    drawDimension(page_, {at(from, 0).x, y}, {at(to, 0).x, y}, formatLength(std::abs(to - from)));
  }

  void drawWidths() {
    const Rectangle &mirror = plan_.mirrorBox, &sculpture = plan_.sculptureBox;
    const double top = at(0, plan_.things.max.y).y - 0.6 * above;
    const double bottom = at(0, plan_.things.min.y).y + 0.6 * below;
    drawWidth(mirror.min.x, mirror.max.x, 0.5 * (mirror.min.y + mirror.max.y), top);
    const double middle = 0.5 * (sculpture.min.y + sculpture.max.y);
    if (sculpture.min.x < -nothing && sculpture.max.x > nothing) {
      drawWidth(0, sculpture.min.x, middle, bottom);
      drawWidth(0, sculpture.max.x, middle, bottom);
    } else {
      const bool onTheRight = sculpture.max.x > nothing;
      const double near = onTheRight ? sculpture.min.x : sculpture.max.x;
      const double far = onTheRight ? sculpture.max.x : sculpture.min.x;
      drawWidth(near, 0, middle, bottom);  // a short one has its text on the free side
      drawWidth(near, far, middle, bottom);
    }
  }

  void drawDistances() {
    const std::vector<Distance> distances = distancesOf(plan_, withEye_);
    double x = at(plan_.things.max).x + railStart;
    const double end = x + railStep * (double(distances.size()) - 1) + 1;
    if (!distances.empty()) drawLine(page_, at(0, 0) + Point2(3, 0), {end, at(0, 0).y}, helpPen);
    for (const Distance& distance : distances) {
      const Point2 from = at(distance.from, distance.to);
      drawLine(page_, from + Point2(1, 0), {x + 1, from.y}, helpPen);
      drawDimension(page_, {x, at(0, 0).y}, {x, from.y}, formatLength(std::abs(distance.to)));
      x += railStep;
    }
  }

  // Whether there is room for a rectangle of the page's width and height with its middle there.
  template <typename Contains>
  static bool hasRoom(const Point2& middle, const Point2& half, const Contains& contains) {
    for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      for (const double y : {-1.0, 0.0, 1.0}) {
        if (!contains(middle + Point2(x, y) * half)) return false;
      }
    }
    return true;
  }

  // The name of a thing inside it, beside the centre line, as near to the line as there is room; nowhere when
  // there is none.
  template <typename Contains>
  void drawName(const std::string& name, const Color& color, const Rectangle& box, const Contains& contains) {
    constexpr double size = 2.9;
    const Point2 half = scale_ * Point2(0.5 * textWidth(name, size) + 1, 0.5 * size + 0.7);
    constexpr int steps = 40;
    const Point2 step = (box.max - box.min) / double(steps);
    std::optional<Point2> best;
    for (int y = 0; y <= steps; ++y) {
      for (int x = 0; x <= steps; ++x) {
        const Point2 middle = box.min + step * Point2(x, y);
        if (std::abs(middle.x) < half.x || std::abs(middle.y) < half.y + scale_) continue;
        if (best && std::abs(best->x) <= std::abs(middle.x)) continue;
        if (hasRoom(middle, half, contains)) best = middle;
      }
    }
    if (!best) return;
    drawText(page_, {at(*best) + Point2(0, 0.36 * size), name, size, false, TextAlign::centre, false, color});
  }

  // An upright mirror has no inside: its name stands below its left end, where nothing else is.
  void nameLine() {
    const Point2 end = plan_.mirrorBox.min;
    const bool level = plan_.mirrorBox.size().y < scale_;
    if (!level || plan_.mirrorBox.size().x < 40 * scale_ || plan_.sculptureBox.max.y > end.y - 6 * scale_)
      return;
    drawText(page_, {at(end) + Point2(0, 4), surface(), 2.9, false, TextAlign::left, false, ink::blue});
  }

  void drawNames() {
    const auto inSculpture = [&](const Point2& p) { return isInside(plan_.sculpture, p); };
    const auto inMirror = [&](const Point2& p) { return isInside(plan_.mirror, p) && !inSculpture(p); };
    drawName(surface(), ink::blue, plan_.mirrorBox, inMirror);
    if (isLine()) nameLine();
    drawName(tr("sculpture"), ink::vermilion, plan_.sculptureBox, inSculpture);
  }

  void drawEyePlace() {
    const std::string height = trFormat("{} mm above the table", formatLength(plan_.eyeHeight));
    if (withEye_) {
      const Point2 place = at(plan_.eye);
      const Pen pen{0.3, ink::black, {}};
      drawLine(page_, place - Point2(3, 0), place + Point2(3, 0), pen);
      drawLine(page_, place - Point2(0, 3), place + Point2(0, 3), pen);
      drawEye(page_, place + Point2(0, 5.6), 6);
      write(place + Point2(0, 10.6), tr("eye, ") + height);
      return;
    }
    const Point2 start{at(0, 0).x, at(0, plan_.things.min.y).y + below + 0.5};
    drawArrow(page_, start, start + Point2(0, 5), Pen{0.3, ink::black, {}});
    drawEye(page_, start + Point2(-6, 2.5), 6);
    write(start + Point2(0, 9),
          trFormat("eye: {} mm from the cross, ", formatLength(std::abs(plan_.eye.y))) + height);
  }

  void write(const Point2& place, const std::string& text) {
    drawText(page_, {place, text, 2.9, false, TextAlign::centre, false, ink::black});
  }

  // Which way the axes of the exported meshes run, in the lower left corner.
  void drawAxes() {
    const auto onPage = [](const Point2& direction) { return Point2(direction.x, -direction.y); };
    const Point2 x = onPage(plan_.x), y = onPage(plan_.y);
    constexpr double length = 7, label = 9;
    const Point2 low = glm::min(Point2(0), glm::min(label * x, label * y)) - 1.5;
    const Point2 high = glm::max(Point2(0), glm::max(label * x, label * y)) + 1.5;
    const Point2 corner{area_.min.x - low.x, area_.max.y - high.y};
    drawArrow(page_, corner, corner + length * x, Pen{0.25, ink::grey, {}});
    drawArrow(page_, corner, corner + length * y, Pen{0.25, ink::grey, {}});
    const auto name = [&](const Point2& direction, const char* text) {
      drawText(page_, {corner + label * direction + Point2(0, 0.9), text, 2.7, false, TextAlign::centre,
                       false, ink::grey});
    };
    name(x, "x");
    name(y, "y");
    drawText(page_, {{area_.min.x + (high - low).x + 1, area_.max.y - 1},
                     tr("axes of the mesh files"),
                     2.4,
                     false,
                     TextAlign::left,
                     false,
                     ink::grey});
  }

  Page& page_;
  const SheetPlan& plan_;
  const Rectangle area_;
  const double scale_;
  const bool withEye_;
  Point2 origin_{0};
};

}  // namespace

SheetPlan makeSheetPlan(const Arrangement& arrangement) {
  SheetPlan plan;
  plan.hasMirror = arrangement.hasMirror;
  const std::vector<Point2> mirror = flatten(arrangement, arrangement.mirrorSurface.positions);
  plan.mirrorRadius = circleFromAbove(arrangement.mirror);
  plan.mirror = outlineOf(mirror, arrangement.mirrorSurface, plan.mirrorRadius.has_value());
  plan.sculpture =
      makeSilhouette(flatten(arrangement, arrangement.sculpture.positions), arrangement.sculpture.triangles);
  plan.eye = arrangement.planOf(arrangement.eye);
  plan.eyeHeight = arrangement.sideOf(arrangement.eye).y;
  plan.mirrorBox = boxOf(mirror);
  if (const auto r = plan.mirrorRadius) plan.mirrorBox = {Point2(-*r), Point2(*r)};
  plan.sculptureBox = boxOf(flatten(arrangement, arrangement.sculpture.positions));
  plan.things = plan.mirrorBox;
  extend(plan.things, plan.sculptureBox.min);
  extend(plan.things, plan.sculptureBox.max);
  const auto turned = [&](const Point2& p) {
    return Point2(glm::dot(p, arrangement.right), glm::dot(p, arrangement.away));
  };
  if (arrangement.plate) {
    const Point2 middle{arrangement.middle.x, arrangement.middle.y};
    for (const Point2& p : arrangement.plate->outline) plan.plate.push_back(turned(p - middle));
    for (const Point2& p : arrangement.plate->posts) plan.posts.push_back(turned(p - middle));
    plan.postRadius = arrangement.plate->postRadius;
    for (const Point2& p : plan.plate) extend(plan.things, p);
  }
  plan.x = turned({1, 0});
  plan.y = turned({0, 1});
  return plan;
}

Point2 sizeOnPage(const SheetPlan& plan, double scale, bool withEye) {
  return {plan.things.size().x / scale + left + rightStrip(plan, withEye),
          plan.things.max.y / scale + above - lowestOf(plan, scale, withEye)};
}

void drawSheetPlan(Page& page, const SheetPlan& plan, const Rectangle& area, double scale, bool withEye) {
  Drawing(page, plan, area, scale, withEye).draw();
}

}  // namespace anamorph
