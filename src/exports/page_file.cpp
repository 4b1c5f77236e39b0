#include "exports/page_file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <memory>

#include "base/error.h"

namespace anamorph {
namespace {

constexpr double pointsPerMillimetre = 72 / 25.4;
constexpr const char* fontName = "DejaVu Sans";

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* text, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

// Letters are placed as if they were infinitely fine, on paper and when they are measured.
void chooseFont(cairo_t* context, double size, bool bold) {
  const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
      cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options.get());
  cairo_select_font_face(context, fontName, CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
}

double advanceOf(cairo_t* context, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

void setColor(cairo_t* context, const Color& color) {
  cairo_set_source_rgb(context, color.x, color.y, color.z);
}

// Fills and strokes the current path, and forgets it.
void paint(cairo_t* context, const std::optional<Pen>& pen, const std::optional<Color>& fill) {
  if (fill) {
    setColor(context, *fill);
    cairo_fill_preserve(context);
  }
  if (pen) {
    setColor(context, pen->color);
    cairo_set_line_width(context, pen->width);
    cairo_set_dash(context, pen->dash.data(), static_cast<int>(pen->dash.size()), 0);
    cairo_stroke_preserve(context);
  }
  cairo_new_path(context);
}

struct DrawItem {
  cairo_t* context;

  void operator()(const PageShape& shape) const {
    for (const auto& line : shape.lines) {
      cairo_new_sub_path(context);
      for (const glm::dvec2& p : line) cairo_line_to(context, p.x, p.y);
      if (shape.closed) cairo_close_path(context);
    }
    paint(context, shape.pen, shape.fill);
  }
  void operator()(const PageCircle& circle) const {
    cairo_new_sub_path(context);
    cairo_arc(context, circle.centre.x, circle.centre.y, circle.radius, 0, 2 * pi);
    cairo_close_path(context);
    paint(context, circle.pen, circle.fill);
  }
  void operator()(const PageText& text) const {
    cairo_save(context);
    chooseFont(context, text.size, text.bold);
    setColor(context, text.color);
    cairo_translate(context, text.at.x, text.at.y);
    if (text.upwards) cairo_rotate(context, -pi / 2);
    const double width = advanceOf(context, text.text);
    const double fraction = text.align == TextAlign::left ? 0 : text.align == TextAlign::centre ? 0.5 : 1;
    cairo_move_to(context, -fraction * width, 0);
    cairo_show_text(context, text.text.c_str());
    cairo_restore(context);
  }
};

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("cannot draw the page: ") + cairo_status_to_string(status));
}

void draw(const Page& page, cairo_surface_t* surface, double unit) {
  const Context context(cairo_create(surface), cairo_destroy);
  cairo_scale(context.get(), unit, unit);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_fill_rule(context.get(), CAIRO_FILL_RULE_EVEN_ODD);
  for (const PageItem& item : page.items) std::visit(DrawItem{context.get()}, item);
  cairo_show_page(context.get());
  check(cairo_status(context.get()));
}

}  // namespace

std::string encodePage(const Page& page, PageFormat format) {
  std::string bytes;
  const bool pdf = format == PageFormat::pdf;
  const double unit = pdf ? pointsPerMillimetre : 1;  // an SVG's unit is the millimetre itself
  const double width = unit * page.width, height = unit * page.height;
  const Surface surface(pdf ? cairo_pdf_surface_create_for_stream(append, &bytes, width, height)
                            : cairo_svg_surface_create_for_stream(append, &bytes, width, height),
                        cairo_surface_destroy);
  if (pdf) {
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, page.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "Anamorph");
    // The date of the day would make the same page different bytes tomorrow.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  } else {
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
  }
  draw(page, surface.get(), unit);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return bytes;
}

double textWidth(const std::string& text, double size, bool bold) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy);
  const Context context(cairo_create(surface.get()), cairo_destroy);
  constexpr double large = 100;  // whatever is rounded is rounded away
  chooseFont(context.get(), large, bold);
  return advanceOf(context.get(), text) * size / large;
}

}  // namespace anamorph
