// How much of the pixel is ink: by the distance to the line, to its dashes or dots, and to the arrow head.
#include "camera.glsl"

uniform sampler2D depth;  // lineDepth() of what is seen
uniform float pixelScale;

flat in vec4 ends;
flat in vec2 depths;
flat in vec4 ink;
flat in vec4 form;
out vec4 color;  // times alpha

const float shineThrough = 0.18;  // of a line that something is before

// Dashes begin where the line does, so they do not crawl when its end moves.
float lineDistance(vec2 p, float size) {
  int style = int(form.y + 0.5);
  float gap = style == lineSolid ? 0.0 : style == lineDashed ? 6.0 * pixelScale + 2.0 * form.x : 4.6 * form.x;
  float on = style == lineSolid ? size : style == lineDashed ? 8.0 * pixelScale : 0.0;
  float start = gap > 0.0 ? floor((p.x + 0.5 * gap) / (on + gap)) * (on + gap) : 0.0;
  start = clamp(start, 0.0, size);
  return length(p - vec2(clamp(p.x, start, min(start + on, size)), 0.0));
}

// Inside is > 0.
float arrowDepth(vec2 p, float size) {
  float arrow = form.z, halfBase = 0.36 * arrow;
  vec2 q = vec2(p.x - 0.5 * (size - arrow), abs(p.y));
  float side = (halfBase * (1.0 - q.x / arrow) - q.y) * arrow / length(vec2(arrow, halfBase));
  return min(side, q.x);
}

void main() {
  vec2 way = ends.zw - ends.xy, fromStart = gl_FragCoord.xy - ends.xy;
  float size = length(way);
  vec2 along = size > 1e-4 ? way / size : vec2(1.0, 0.0);
  vec2 p = vec2(dot(fromStart, along), dot(fromStart, vec2(-along.y, along.x)));
  float coverage = clamp(form.x + 0.5 - lineDistance(p, size), 0.0, 1.0);
  if (form.z > 0.0) coverage = max(coverage, clamp(arrowDepth(p, size) + 0.5, 0.0, 1.0));

  float fraction = clamp(p.x / max(size, 1e-4), 0.0, 1.0);
  float z = parallelRays() ? mix(depths.x, depths.y, fraction) : 1.0 / mix(1.0 / depths.x, 1.0 / depths.y, fraction);
  bool hidden = lineDepth(0.9995 * z) > texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x;
  float alpha = ink.a * coverage * (hidden && form.w < 0.5 ? shineThrough : 1.0);
  color = vec4(ink.rgb * alpha, alpha);
}
