// One triangle that covers the picture, at a depth.

uniform float place;  // 0 nearest, 1 farthest

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 2.0 * place - 1.0, 1.0);
}
