// Long arrays in 2D textures, 2048 texels a row (TexelArrays of src/gl/texture.h).

ivec2 texelCoord(int i) {
  return ivec2(i & 2047, i >> 11);
}
