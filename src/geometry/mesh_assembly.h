// From the vertices and polygons of a file to a mesh: polygons that cannot be used are left out, the others cut into
// triangles, and vertices that no triangle uses are left out too: one stray point far away would make the box of the
// model that of the stray point.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/mesh_remarks.h"
#include "geometry/polygon.h"

namespace anamorph {

// What is left out of OBJ and PLY files alike.
inline constexpr Remark badVertices{"1 vertex without three numbers left out",
                                    "{} vertices without three numbers left out"};
inline constexpr Remark shortFaces{"1 face of fewer than three corners left out",
                                   "{} faces of fewer than three corners left out"};
inline constexpr Remark badIndices{"1 face without valid vertex indices left out",
                                   "{} faces without valid vertex indices left out"};

/// How a format counts, for messages.
struct FileCounting {
  std::size_t firstVertex = 0;                          ///< the index of the first vertex
  std::function<std::string(std::size_t)> whereIsFace;  ///< the place of a polygon of the soup
};

/// How an unusable vertex is kept until all faces are known; its faces are left out.
Point noVertex();

/// The mesh of a file, of which every remark is made; a vertex that is noVertex() is taken for said already. Without
/// triangles when nothing is left: then with all vertices. `normals` as for triangulate().
Mesh assembleMesh(PointArray positions, PolygonSoup polygons, const FileCounting& counting,
                  MeshRemarks& remarks, std::vector<Triangle>* normals = nullptr);

/// Leaves out the vertices that no triangle uses, each told by its number before. The others keep their order.
void leaveOutUnusedVertices(Mesh& mesh, const std::function<void(std::size_t)>& tell = {});

}  // namespace anamorph
