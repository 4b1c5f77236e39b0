#include "panels/figures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <imgui.h>

#include "base/language.h"
#include "panels/style.h"

namespace anamorph {
namespace {

constexpr ImU32 incident = ink::of(palette::rayFromEye), reflected = ink::of(palette::rayReflected),
                normal = ink::of(palette::normal), mirror = ink::of(palette::figureMirror),
                object = ink::of(palette::figureOriginal);
constexpr float degree = 3.14159265f / 180;

// A sheet with x from 0 to 100, and y down from 0 to `height`.
class Sheet {
 public:
  Sheet(const Look& look, float height) : look_(look), list_(*ImGui::GetWindowDrawList()) {
    const float width = std::min(ImGui::GetContentRegionAvail().x, 420 * static_cast<float>(look.scale));
    unit_ = width / 100;
    origin_ = ImGui::GetCursorScreenPos();
    list_.AddRectFilled(origin_, {origin_.x + width, origin_.y + height * unit_},
                        ImGui::GetColorU32(ImGuiCol_FrameBg, 0.55f), 4 * static_cast<float>(look.scale));
    ImGui::Dummy({width, height * unit_});
  }

  ImVec2 at(float x, float y) const { return {origin_.x + x * unit_, origin_.y + y * unit_}; }
  float thick(float pixels) const { return pixels * static_cast<float>(look_.scale); }
  ImU32 ink() const { return ImGui::GetColorU32(ImGuiCol_Text); }
  ImU32 quiet() const { return ImGui::GetColorU32(ImGuiCol_Text, 0.5f); }

  void line(float x1, float y1, float x2, float y2, ImU32 color, float width = 2) const {
    list_.AddLine(at(x1, y1), at(x2, y2), color, thick(width));
  }
  void dashes(float x1, float y1, float x2, float y2, ImU32 color, float width = 1.6f) const {
    const float length = std::hypot(x2 - x1, y2 - y1), dash = 2.4f;
    for (float t = 0; t < length; t += 2 * dash) {
      const float a = t / length, b = std::min(1.0f, (t + dash) / length);
      line(x1 + a * (x2 - x1), y1 + a * (y2 - y1), x1 + b * (x2 - x1), y1 + b * (y2 - y1), color, width);
    }
  }
  void arrow(float x1, float y1, float x2, float y2, ImU32 color) const {
    line(x1, y1, x2, y2, color);
    const float angle = std::atan2(y2 - y1, x2 - x1), size = 3.2f;
    const float mx = 0.45f * x1 + 0.55f * x2, my = 0.45f * y1 + 0.55f * y2;  // in the middle
    const auto corner = [&](float turn) {
      return at(mx - size * std::cos(angle + turn), my - size * std::sin(angle + turn));
    };
    list_.AddTriangleFilled(at(mx + 0.6f * size * std::cos(angle), my + 0.6f * size * std::sin(angle)),
                            corner(0.5f), corner(-0.5f), color);
  }
  void dot(float x, float y, ImU32 color) const { list_.AddCircleFilled(at(x, y), thick(3.4f), color); }
  void circle(float x, float y, float r, ImU32 color, float width = 2.4f) const {
    list_.AddCircle(at(x, y), r * unit_, color, 48, thick(width));
  }
  void arc(float x, float y, float r, float from, float to, ImU32 color, float width = 1.6f) const {
    list_.PathArcTo(at(x, y), r * unit_, from, to, 24);
    list_.PathStroke(color, 0, thick(width));
  }
  void polygon(const std::vector<ImVec2>& points, ImU32 color, bool filled) const {
    std::vector<ImVec2> placed;
    for (const ImVec2& p : points) placed.push_back(at(p.x, p.y));
    if (filled) {
      list_.AddConvexPolyFilled(placed.data(), static_cast<int>(placed.size()), color);
    } else {
      list_.AddPolyline(placed.data(), static_cast<int>(placed.size()), color, ImDrawFlags_Closed, thick(2));
    }
  }
  // Centred at the place.
  void letter(float x, float y, const char* text, ImU32 color = 0) const {
    const FontScope strong(look_.fonts.strong);
    const ImVec2 size = ImGui::CalcTextSize(text), p = at(x, y);
    list_.AddText({p.x - size.x / 2, p.y - size.y / 2}, color != 0 ? color : ink(), text);
  }
  void words(float x, float y, const char* english) const {
    const char* text = tr(english);
    const float font = ImGui::GetFontSize() * 0.85f;
    const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(font, FLT_MAX, 0, text), p = at(x, y);
    list_.AddText(ImGui::GetFont(), font, {p.x - size.x / 2, p.y - size.y / 2}, quiet(), text);
  }
  // An eye that looks to the right.
  void eye(float x, float y) const {
    arc(x - 5, y, 6, -0.62f, 0.62f, ink(), 2);
    line(x - 4.6f, y, x - 0.2f, y - 3.5f, ink());
    line(x - 4.6f, y, x - 0.2f, y + 3.5f, ink());
    dot(x, y, ink());
  }

 private:
  const Look& look_;
  ImDrawList& list_;
  ImVec2 origin_;
  float unit_;
};

// Side view: lines of sight over a standing object to the floor.
void drawPerspective(const Look& look) {
  const Sheet sheet(look, 50);
  constexpr float eyeX = 14, eyeY = 10, ground = 42;
  const auto onGround = [&](float x, float y) { return eyeX + (x - eyeX) * (ground - eyeY) / (y - eyeY); };
  constexpr float left = 40, right = 48, top = 26;
  const float topFar = onGround(right, top), bottom = left;
  sheet.line(6, ground, 96, ground, sheet.quiet(), 1.6f);
  sheet.line(eyeX, eyeY, topFar, ground, incident, 1.6f);
  sheet.line(eyeX, eyeY, bottom, ground, incident, 1.6f);
  sheet.polygon({{left, ground}, {left, top}, {right, top}, {right, ground}}, object, false);
  sheet.line(bottom, ground - 0.8f, topFar, ground - 0.8f, reflected, 4);
  sheet.eye(eyeX, eyeY);
  sheet.letter(eyeX, eyeY - 6, "E");
  sheet.letter(right + 4, top - 2, "P");
  sheet.dot(right, top, object);
  sheet.letter(topFar + 3, ground - 4, "S", reflected);
  sheet.words((left + topFar) / 2, ground + 4.8f, "the picture on the floor");
}

// A mirror seen from its edge: the construction of one vertex.
void drawConstruction(const Look& look) {
  const Sheet sheet(look, 62);
  constexpr float qx = 52, qy = 32, eyeX = 16, eyeY = 52;
  const float dx = qx - eyeX, dy = qy - eyeY, k = 0.72f;
  const float px = qx + k * dx, py = qy + k * dy, sx = qx - k * dx, sy = qy + k * dy;
  sheet.line(qx, 5, qx, 57, mirror, 4);
  sheet.dashes(18, qy, qx, qy, normal);
  sheet.arrow(eyeX, eyeY, qx, qy, incident);
  sheet.dashes(qx, qy, px, py, sheet.quiet());
  sheet.arrow(qx, qy, sx, sy, reflected);
  const float angle = std::atan2(std::abs(dy), dx);
  sheet.arc(qx, qy, 13, 180 * degree - angle, 180 * degree, normal);
  sheet.arc(qx, qy, 13, 180 * degree, 180 * degree + angle, normal);
  sheet.letter(qx - 17, qy + 4.2f, "α", normal);
  sheet.letter(qx - 17, qy - 4.4f, "α", normal);
  sheet.letter(15, qy, "N", normal);
  sheet.dot(qx, qy, sheet.ink());
  sheet.letter(qx + 4.5f, qy + 3.5f, "Q");
  sheet.dot(px, py, object);
  sheet.letter(px + 4, py, "P", object);
  sheet.dot(sx, sy, reflected);
  sheet.letter(sx - 4, sy, "S", reflected);
  sheet.eye(eyeX, eyeY);
  sheet.letter(eyeX - 8, eyeY, "E");
  sheet.letter((qx + px) / 2 + 1, (qy + py) / 2 + 5, "d");
  sheet.letter((qx + sx) / 2 + 3, (qy + sy) / 2 - 5, "k·d");
  sheet.words(qx, 59.5f, "mirror");
}

// From above: how the three mirrors turn parallel rays.
void drawColumns(const Look& look) {
  const Sheet sheet(look, 52);
  const auto bundle = [&](float x, float radius) {
    constexpr float top = 16;
    for (const float offset : {-4.0f, 0.0f, 4.0f}) {
      const float lean = radius > 0 ? std::asin(offset / radius) : 0;
      const float hitY = radius > 0 ? top + radius - std::sqrt(radius * radius - offset * offset) : top;
      const float hx = x + offset;
      sheet.line(hx, 44, hx, hitY, incident, 1.6f);
      const float turn = 2 * lean, length = 17;
      sheet.line(hx, hitY, hx + length * std::sin(turn), hitY + length * std::cos(turn), reflected, 1.6f);
    }
  };
  sheet.line(6, 16, 28, 16, mirror, 4);
  bundle(17, 0);
  sheet.circle(50, 27, 11, mirror, 4);
  bundle(50, 11);
  sheet.circle(83, 27, 11, mirror, 4);
  sheet.arc(83, 27, 5, 20 * degree, 200 * degree, mirror);
  bundle(83, 11);
  sheet.words(17, 48, "plane");
  sheet.words(50, 48, "cylinder");
  sheet.words(83, 48, "sphere");
}

// A straight edge of the sculpture against the curve that it stands for.
void drawEdges(const Look& look) {
  const Sheet sheet(look, 46);
  const auto curve = [&](float x0, int parts) {
    const auto point = [&](float t) {
      const float angle = (200 + 140 * t) * degree;
      return ImVec2{x0 + 18 * std::cos(angle), 32 + 22 * std::sin(angle)};
    };
    constexpr int fine = 40;
    for (int i = 0; i < fine; ++i) {
      const ImVec2 a = point(static_cast<float>(i) / fine), b = point(static_cast<float>(i + 1) / fine);
      sheet.line(a.x, a.y, b.x, b.y, sheet.quiet(), 1.4f);
    }
    for (int i = 0; i < parts; ++i) {
      const float n = static_cast<float>(parts);
      const ImVec2 a = point(static_cast<float>(i) / n), b = point(static_cast<float>(i + 1) / n);
      sheet.line(a.x, a.y, b.x, b.y, reflected, 2.4f);
      sheet.dot(a.x, a.y, reflected);
      sheet.dot(b.x, b.y, reflected);
    }
  };
  curve(26, 1);
  curve(74, 6);
  sheet.words(26, 41, "two vertices");
  sheet.words(74, 41, "seven vertices");
}

// The sculpture in the way of the eye, and the eye raised above it.
void drawOcclusion(const Look& look) {
  const Sheet sheet(look, 48);
  const auto scene = [&](float x, float eyeY, bool free) {
    constexpr float ground = 42;
    sheet.line(x + 38, 8, x + 38, ground, mirror, 4);
    sheet.line(x, ground, x + 42, ground, sheet.quiet(), 1.4f);
    sheet.polygon({{x + 19, ground}, {x + 19, ground - 13}, {x + 27, ground - 13}, {x + 27, ground}},
                  reflected, true);
    sheet.eye(x + 6, eyeY);
    if (free) {
      sheet.line(x + 6, eyeY, x + 38, ground - 13, incident, 1.8f);
      sheet.line(x + 38, ground - 13, x + 27, ground - 6, reflected, 1.8f);
    } else {
      sheet.line(x + 6, eyeY, x + 19, eyeY + 0.6f, incident, 1.8f);
      sheet.dashes(x + 27, eyeY + 0.9f, x + 38, eyeY + 1.2f, incident);
    }
  };
  scene(4, 33, false);
  scene(54, 8, true);
  sheet.words(25, 45.5f, "hidden");
  sheet.words(75, 45.5f, "free");
}

}  // namespace

void drawFigure(const std::string& name, const Look& look) {
  if (name == "perspective") drawPerspective(look);
  if (name == "construction") drawConstruction(look);
  if (name == "columns") drawColumns(look);
  if (name == "edges") drawEdges(look);
  if (name == "occlusion") drawOcclusion(look);
}

}  // namespace anamorph
