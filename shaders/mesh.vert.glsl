// The triangles of a surface, corner by corner, from the same textures that rays are traced through. A triangle with a
// corner that is not usable becomes a point, which covers nothing.
#include "camera.glsl"
#include "texel.glsl"

uniform sampler2D positions;
uniform usampler2D triangles;
uniform int surface;

flat out uint seenTriangle;

void main() {
  int local = gl_VertexID / 3, corner = gl_VertexID - 3 * local;
  ivec4 place = surfaceOffsets[surface];
  int triangle = place.y + local;
  seenTriangle = uint(triangle + 1);
  uvec4 ids = texelFetch(triangles, texelCoord(2 * triangle), 0);
  uint own = corner == 0 ? ids.x : corner == 1 ? ids.y : ids.z;
  vec4 p = texelFetch(positions, texelCoord(place.z + int(own)), 0);
  bool usable = true;
  if ((surfaceSize[surface].y & wholeMesh) == 0) {
    for (int i = 0; i < 3; ++i) {
      uint id = i == 0 ? ids.x : i == 1 ? ids.y : ids.z;
      usable = usable && texelFetch(positions, texelCoord(place.z + int(id)), 0).w > 0.5;
    }
  }
  if (!usable) {
    gl_Position = vec4(0.0, 0.0, -2.0, 1.0);
    return;
  }
  vec3 point = surfaceCentre[surface].xyz + p.xyz;
  vec4 clip = clipPosition(point);
  float near = depthRange.x, far = depthRange.y, depth = viewDepth(point);
  float z = (2.0 * depth - far - near) / (far - near);                                   // parallel rays
  if (!parallelRays()) z = ((far + near) * depth - 2.0 * far * near) / (far - near);  // over w, which is depth
  gl_Position = vec4(clip.xy, z, clip.w);
}
