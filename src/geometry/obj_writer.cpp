#include "geometry/obj_writer.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

// Formatting takes longer than writing, so chunks of rows are formatted in parallel; a batch of them is
// written in order before the next one takes its memory again.
template <typename Write, typename FormatRow>
void writeRows(const Write& write, std::size_t count, const FormatRow& formatRow) {
  constexpr std::size_t chunk = 8192, batch = 64 * chunk;
  std::vector<fmt::memory_buffer> texts(batch / chunk);
  for (std::size_t first = 0; first < count; first += batch) {
    const std::size_t rows = std::min(batch, count - first);
    parallelFor(rows, chunk, 0, [&](std::size_t begin, std::size_t end) {
      fmt::memory_buffer& text = texts[begin / chunk];
      text.clear();
      for (std::size_t i = begin; i < end; ++i) formatRow(std::back_inserter(text), first + i);
    });
    for (std::size_t begin = 0; begin < rows; begin += chunk) {
      const fmt::memory_buffer& text = texts[begin / chunk];
      write(std::string_view(text.data(), text.size()));
    }
  }
}

template <typename Write>
void writeMeshRows(const Write& write, const Mesh& mesh) {
  writeRows(write, mesh.positions.size(), [&](auto out, std::size_t i) {
    const Point p = mesh.positions[i];
    fmt::format_to(out, FMT_COMPILE("v {} {} {}\n"), p.x, p.y, p.z);
  });
  writeRows(write, mesh.triangles.size(), [&](auto out, std::size_t i) {
    const Triangle& t = mesh.triangles[i];
    fmt::format_to(out, FMT_COMPILE("f {} {} {}\n"), std::uint64_t{t[0]} + 1, std::uint64_t{t[1]} + 1,
                   std::uint64_t{t[2]} + 1);
  });
}

}  // namespace

void writeObj(AtomicFile& file, const Mesh& mesh, const std::string& comment) {
  if (!comment.empty()) file.write("# " + comment + "\n");
  writeMeshRows([&](std::string_view rows) { file.write(rows); }, mesh);
}

std::string formatObj(const Mesh& mesh) {
  std::string text;
  writeMeshRows([&](std::string_view rows) { text += rows; }, mesh);
  return text;
}

}  // namespace anamorph
