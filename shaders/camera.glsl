// Pixels to rays and points to pixels, as ViewProjection of src/edit/view_pose.h.
#include "scene.glsl"

struct Ray {
  vec3 origin;
  vec3 direction;  // of length 1
};

bool parallelRays() {
  return forward.w > 0.5;
}

// Through the sample of this pixel; gl_FragCoord counts from the lower left.
Ray pixelRay(vec2 pixel) {
  vec2 fromMiddle = lens.x * (pixel + lens.yz - 0.5 * vec2(right.w, up.w));
  vec3 across = fromMiddle.x * right.xyz + fromMiddle.y * up.xyz;
  if (parallelRays()) return Ray(eye.xyz + across, forward.xyz);
  return Ray(eye.xyz, normalize(forward.xyz + across));
}

float viewDepth(vec3 point) {
  return dot(point - eye.xyz, forward.xyz);
}

// The width of a pixel at the end of a way of this length.
float footprintAt(float travelled) {
  return parallelRays() ? lens.x : lens.x * travelled;
}

// Clip coordinates whose depth is 0; w is the depth in perspective.
vec4 clipPosition(vec3 point) {
  vec3 v = point - eye.xyz;
  vec2 p = vec2(dot(v, right.xyz), dot(v, up.xyz)) / (0.5 * lens.x * vec2(right.w, up.w));
  float w = parallelRays() ? 1.0 : dot(v, forward.xyz);
  vec2 shift = 2.0 * lens.yz / vec2(right.w, up.w);
  return vec4(p - shift * w, 0.0, w);
}

// The depth that things drawn as lines and dots are compared by: logarithmic, so that it is equally exact near and
// far and nothing has to be known of the scene. 0 at the eye.
float lineDepth(float depth) {
  return clamp(log2(1.0 + max(depth, 0.0) * depthRange.z) * depthRange.w, 0.0, 1.0);
}
