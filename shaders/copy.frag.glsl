// A texture as it is, pixel by pixel; blending makes it part of a mean.

uniform sampler2D source;
out vec4 color;

void main() {
  color = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
}
