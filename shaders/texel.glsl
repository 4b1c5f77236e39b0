// Long arrays in 2D textures, row by row (TexelArrays of src/gl/texture.h).

ivec2 texelCoord(int i) {
  return ivec2(i & ((1 << texelRowBits) - 1), i >> texelRowBits);
}
