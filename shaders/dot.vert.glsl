// The vertices of the sculpture that are not mapped, as dots in the colour of their status. Six vertices an instance.
#include "camera.glsl"
#include "texel.glsl"

uniform sampler2D positions;
uniform int first;     // vertex that is drawn
uniform float radius;  // pixels

flat out vec3 middle;  // in pixels; z: depth
flat out vec3 ink;

void main() {
  vec4 p = texelFetch(positions, texelCoord(surfaceOffsets[sculptureSurface].z + first + gl_InstanceID), 0);
  vec3 point = surfaceCentre[sculptureSurface].xyz + p.xyz;
  float z = viewDepth(point);
  int status = int(0.5 - p.w);  // PathStatus
  ink = status == missesMirror ? missesMirrorInk : status == inFrontOfMirror ? inFrontOfMirrorInk
      : status == grazing ? grazingInk : hitsMirrorAgainInk;
  middle = vec3(0.0);
  gl_Position = vec4(0.0, 0.0, -2.0, 1.0);
  if (p.w > 0.5 || !(z > 0.0)) return;
  vec4 clip = clipPosition(point);
  middle = vec3((0.5 * clip.xy / clip.w + 0.5) * vec2(right.w, up.w), z);
  bool atRight = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
  bool above = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
  vec2 place = middle.xy + (radius + 1.0) * vec2(atRight ? 1.0 : -1.0, above ? 1.0 : -1.0);
  gl_Position = vec4(2.0 * place / vec2(right.w, up.w) - 1.0, 0.0, 1.0);
}
