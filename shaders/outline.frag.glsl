// A line around the selected thing, outside of it: pixels that are not in the mask and near to it.

uniform sampler2D mask;  // smooth
uniform float width;     // pixels

out vec4 color;

const int taps = 16;
const float fullTurn = 6.2831853;

void main() {
  vec2 pixel = 1.0 / vec2(textureSize(mask, 0));
  float nearby = 0.0;
  for (int i = 0; i < taps; ++i) {
    float angle = fullTurn * float(i) / float(taps);
    vec2 around = width * vec2(cos(angle), sin(angle));
    nearby = max(nearby, texture(mask, (gl_FragCoord.xy + around) * pixel).r);
    nearby = max(nearby, texture(mask, (gl_FragCoord.xy + 0.5 * around) * pixel).r);
  }
  float alpha = nearby * (1.0 - texelFetch(mask, ivec2(gl_FragCoord.xy), 0).r);
  color = vec4(selectedInk * alpha, alpha);
}
