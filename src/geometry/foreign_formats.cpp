#include "geometry/foreign_formats.h"

#include <algorithm>

#include "base/folder.h"
#include "geometry/file_text.h"

namespace anamorph {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view exportIt = "export it as STL or OBJ";
constexpr std::string_view meshIt = "it has no surface. Make a mesh of it first";
constexpr std::string_view unpackIt = "unpack it first";
constexpr std::string_view flat = "a mesh is needed: STL, OBJ or PLY";

// Of two that begin alike the first counts; what may begin anyhow comes last.
const std::vector<ForeignFormat> foreignFormats{
    {"STEP", "a STEP file", exportIt, {".step", ".stp", ".p21"}, {"ISO-10303-21"}},
    {"IFC", "an IFC building", exportIt, {".ifc"}, {}},
    {"IGES", "an IGES file", exportIt, {".iges", ".igs"}, {}},
    {"BREP", "a BREP file", exportIt, {".brep"}, {"DBRep_DrawableShape", "CASCADE Topology"}},
    {"Parasolid",
     "a Parasolid file",
     exportIt,
     {".x_t", ".x_b", ".xmt_txt"},
     {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ"}},
    {"ACIS", "an ACIS file", exportIt, {".sat", ".sab"}, {"ACIS BinaryFile"}},
    {"JT", "a JT file", exportIt, {".jt"}, {"Version 8.", "Version 9.", "Version 10."}},
    {"SolidWorks", "a SolidWorks file", exportIt, {".sldprt", ".sldasm"}, {}},
    {"Inventor", "an Inventor file", exportIt, {".ipt", ".iam"}, {}},
    {"CATIA", "a CATIA file", exportIt, {".catpart", ".catproduct"}, {"V5_CFV2"}},
    {"Fusion", "a Fusion file", exportIt, {".f3d", ".f3z"}, {}},
    {"FreeCAD", "a FreeCAD file", exportIt, {".fcstd"}, {}},
    {"OpenSCAD", "an OpenSCAD program", exportIt, {".scad"}, {}},
    {"3MF", "a 3MF file", exportIt, {".3mf"}, {}},
    {"AMF", "an AMF file", exportIt, {".amf"}, {"<amf"}},
    {"glTF", "a glTF file", exportIt, {".gltf", ".glb"}, {"glTF"}},
    {"FBX", "an FBX file", exportIt, {".fbx"}, {"Kaydara FBX", "; FBX"}},
    {"Blender", "a Blender file", exportIt, {".blend"}, {"BLENDER"}},
    {"COLLADA", "a COLLADA file", exportIt, {".dae"}, {"<collada"}},
    {"USD", "a USD file", exportIt, {".usd", ".usda", ".usdc", ".usdz"}, {"#usda", "PXR-USDC"}},
    {"3DS", "a 3DS file", exportIt, {".3ds"}, {}},
    {"3ds Max", "a 3ds Max file", exportIt, {".max"}, {}},
    {"Cinema 4D", "a Cinema 4D file", exportIt, {".c4d"}, {"QC4DC4D6"}},
    {"Maya", "a Maya file", exportIt, {".ma", ".mb"}, {"//Maya ASCII"}},
    {"LightWave", "a LightWave file", exportIt, {".lwo", ".lws"}, {}},
    {"DirectX", "a DirectX model", exportIt, {".x"}, {"xof 03"}},
    {"Alembic", "an Alembic file", exportIt, {".abc"}, {"Ogawa"}},
    {"SketchUp", "a SketchUp file", exportIt, {".skp"}, {"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0"sv}},
    {"Rhino", "a Rhino file", exportIt, {".3dm"}, {"3D Geometry File Format"}},
    {"ZBrush", "a ZBrush file", exportIt, {".ztl", ".zpr"}, {}},
    {"VRML", "a VRML file", exportIt, {".wrl", ".vrml", ".wrz"}, {"#VRML"}},
    {"X3D", "an X3D file", exportIt, {".x3d", ".x3dv"}, {"#X3D", "<x3d"}},
    {"VTK", "a VTK file", exportIt, {".vtk", ".vtp", ".vtu"}, {"# vtk DataFile", "<vtkfile"}},
    {"OFF",
     "an OFF file",
     exportIt,
     {".off"},
     {"OFF\n", "OFF\r", "COFF\n", "COFF\r", "NOFF\n", "NOFF\r", "OFF "}},
    {"DXF",
     "a DXF drawing",
     exportIt,
     {".dxf"},
     {"0\nSECTION", "0\r\nSECTION", "  0\nSECTION", "  0\r\nSECTION", "AutoCAD Binary DXF"}},
    {"DWG", "a DWG drawing", exportIt, {".dwg"}, {"AC10"}},
    {"G-code",
     "G-code for a printer",
     "the model that it was made of is needed",
     {".gcode", ".bgcode"},
     {"GCDE"}},
    {"a point cloud",
     "a point cloud",
     meshIt,
     {".xyz", ".pts", ".ptx", ".pcd", ".las", ".laz", ".e57"},
     {"# .PCD", "LASF", "ASTM-E57"}},
    {"a cloud of splats", "a cloud of splats", meshIt, {".splat", ".spz", ".ksplat"}, {}},
    {"HTML",
     "an HTML page",
     "download the file itself",
     {".html", ".htm"},
     {"<!doctype html", "<html", "<head", "<body"}},
    {"SVG", "an SVG drawing", flat, {".svg"}, {"<svg"}},
    {"XML", "an XML file", exportIt, {".xml"}, {"<?xml"}},
    {"PDF", "a PDF", flat, {".pdf"}, {"%PDF"}},
    {"PostScript", "a PostScript drawing", flat, {".ps", ".eps"}, {"%!PS"}},
    {"PNG", "a PNG picture", flat, {".png"}, {"\x89PNG"}},
    {"JPEG", "a JPEG picture", flat, {".jpg", ".jpeg"}, {"\xFF\xD8\xFF"}},
    {"GIF", "a GIF picture", flat, {".gif"}, {"GIF8"}},
    {"WebP", "a WebP picture", flat, {".webp"}, {"RIFF"}},
    {"TIFF", "a TIFF picture", flat, {".tif", ".tiff"}, {"II*\0"sv, "MM\0*"sv}},
    {"BMP", "a BMP picture", flat, {".bmp"}, {}},
    {"Git LFS",
     "a Git LFS pointer",
     "get the file itself with: git lfs pull",
     {},
     {"version https://git-lfs", "version https://hawser"}},
    {"AppleDouble", "macOS's notes about a file", "take the file without ._ in front", {}, {"\0\5\x16\7"sv}},
    {"UTF-16", "text in UTF-16", "save it as UTF-8", {}, {"\xFF\xFE", "\xFE\xFF"}},
    {"ZIP", "a ZIP archive", unpackIt, {".zip"}, {"PK\3\4", "PK\5\6"}},
    {"gzip", "a gzip archive", unpackIt, {".gz", ".tgz"}, {"\x1F\x8B"}},
    {"7z", "a 7z archive", unpackIt, {".7z"}, {"7z\xBC\xAF"}},
    {"RAR", "a RAR archive", unpackIt, {".rar"}, {"Rar!"}},
    {"bzip2", "a bzip2 archive", unpackIt, {".bz2"}, {"BZh"}},
    {"xz",
     "an xz archive",
     unpackIt,
     {".xz"},
     {"\xFD"
      "7zXZ"}},
    {"Zstandard", "a Zstandard archive", unpackIt, {".zst"}, {"\x28\xB5\x2F\xFD"}},
    {"tar", "a tar archive", unpackIt, {".tar"}, {}}};

// Every other byte 0, as text of ASCII letters in UTF-16 has it.
bool isUtf16(std::string_view head) {
  constexpr std::size_t letters = 8;
  if (head.size() < 2 * letters) return false;
  for (std::size_t i = 0; i < 2 * letters; i += 2) {
    const bool isLetter = head[i] >= '\t' && head[i] <= '~';
    if (!isLetter || head[i + 1] != '\0') return false;
  }
  return true;
}

}  // namespace

const ForeignFormat* foreignByEnding(const std::filesystem::path& path) {
  const std::string ending = lowerEnding(path);
  for (const ForeignFormat& format : foreignFormats) {
    const auto& all = format.endings;
    if (std::find(all.begin(), all.end(), ending) != all.end()) return &format;
  }
  return nullptr;
}

const ForeignFormat* foreignByContent(std::string_view head) {
  constexpr std::size_t searched = 2048;
  head = head.substr(0, searched);
  std::string_view text = withoutByteOrderMark(head);
  while (!text.empty() && isBlank(text[0])) text.remove_prefix(1);
  const std::string markup = text.starts_with('<') ? lowerCase(std::string(text)) : std::string();
  for (const ForeignFormat& format : foreignFormats) {
    for (const std::string_view beginning : format.beginnings) {
      const bool isMarkup = beginning[0] == '<';
      if (isMarkup ? markup.find(beginning) != std::string::npos
                   : head.starts_with(beginning) || text.starts_with(beginning))
        return &format;
    }
    if (format.name == "UTF-16" && isUtf16(head)) return &format;
  }
  return nullptr;
}

}  // namespace anamorph
