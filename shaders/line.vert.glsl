// A line of src/viewport/line.h as a rectangle on the screen, large enough for its rounded ends and its arrow head.
// Six vertices an instance.
#include "camera.glsl"
#include "texel.glsl"

uniform sampler2D lines;   // from, width; to, style with lineArrow, lineInFront; display colour, alpha
uniform int first;         // that is drawn
uniform float pixelScale;  // pixels of this picture for one of a line's width

flat out vec4 ends;    // both in pixels
flat out vec2 depths;  // of both
flat out vec4 ink;
flat out vec4 form;    // half width, style, length of the arrow head, 1 when in front

vec2 pixelOf(vec3 point) {
  vec4 clip = clipPosition(point);
  return (0.5 * clip.xy / clip.w + 0.5) * vec2(right.w, up.w);
}

void main() {
  int texel = 3 * (first + gl_InstanceID);
  vec4 a = texelFetch(lines, texelCoord(texel), 0);
  vec4 b = texelFetch(lines, texelCoord(texel + 1), 0);
  ink = texelFetch(lines, texelCoord(texel + 2), 0);
  int kind = int(b.w + 0.5);
  float halfWidth = 0.5 * a.w * pixelScale;

  // What lies behind the eye is cut off.
  vec3 from = a.xyz, to = b.xyz;
  float nearest = 1e-3 * sceneSize.x;
  float z0 = viewDepth(from), z1 = viewDepth(to);
  gl_Position = vec4(0.0, 0.0, -2.0, 1.0);
  ends = vec4(0.0);
  depths = vec2(1.0);
  form = vec4(0.0);
  if (z0 < nearest && z1 < nearest) return;
  if (z0 < nearest) from = mix(to, from, (z1 - nearest) / (z1 - z0));
  if (z1 < nearest) to = mix(from, to, (z0 - nearest) / (z0 - z1));
  depths = max(vec2(z0, z1), vec2(nearest));

  vec2 p = pixelOf(from), q = pixelOf(to);
  float size = length(q - p);
  vec2 along = size > 1e-4 ? (q - p) / size : vec2(1.0, 0.0), across = vec2(-along.y, along.x);
  // Thin lines stay a pixel wide and get fainter instead, or they would break up into dots.
  float drawn = max(halfWidth, 0.5);
  ink.a *= halfWidth / drawn;
  float arrow = 9.0 * halfWidth;
  bool hasArrow = (kind & lineArrow) != 0 && size > 2.5 * arrow;
  ends = vec4(p, q);
  form = vec4(drawn, float(kind & lineStyleMask), hasArrow ? arrow : 0.0, (kind & lineInFront) != 0 ? 1.0 : 0.0);

  float reach = (hasArrow ? 0.4 * arrow : drawn) + 1.0;
  bool atEnd = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
  bool above = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5;
  vec2 place = (atEnd ? q + reach * along : p - reach * along) + (above ? reach : -reach) * across;
  gl_Position = vec4(2.0 * place / vec2(right.w, up.w) - 1.0, 0.0, 1.0);
}
