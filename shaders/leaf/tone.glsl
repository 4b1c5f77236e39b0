// From linear light to what a display wants, as src/raytrace/image.cpp. Leaf functions (box.glsl).

float shoulder(float x) {
  float rest = 1.0f - shoulderStart;
  return x <= shoulderStart ? x : shoulderStart + rest * (1.0f - exp(-(x - shoulderStart) / rest));
}

float toDisplay(float linear) {
  if (!(linear > 0.0f)) return 0.0f;
  float x = shoulder(linear);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}
