// What is the same for every pixel of a pass. src/viewport/scene_block.h has the same fields in the same order.
// Places are relative to the middle of the scene, so that float has digits to spare wherever the scene is.
// Constants that are found nowhere here come from src/viewport/shader_constants.inl.

layout(std140) uniform Scene {
  vec4 eye;        // xyz
  vec4 right;      // xyz; w: width of the picture in pixels
  vec4 up;         // xyz; w: height
  vec4 forward;    // xyz; w: 1 for parallel rays
  vec4 lens;       // x: size of a pixel at distance 1 (parallel rays: everywhere); yz: shift of the sample in pixels
  vec4 depthRange; // x, y: near and far of meshes; z, w: see lineDepth() of camera.glsl

  vec4 sceneSize;           // x: radius of the scene, y: how far rays are lifted off a surface, z: radius of light markers
  vec4 backgroundTop;    // rgb; w: 1 when nothing is behind the things (transparent)
  vec4 backgroundBottom;
  vec4 ground;           // x: height, y: between the lines of the grid, zw: the grid's origin
  vec4 groundLook[2];    // as materials[]

  vec4 mirrorShape[shapeVectors];  // as its file of shapes/ says
  vec4 mirrorClip[mostClips];      // planes that cut it off: kept is xyz . point >= w, in its sizes
  vec4 mirrorTint;                    // rgb: colour times reflectance

  vec4 surfaceCentre[surfaceCount];  // xyz; w: radius
  vec4 surfaceLow[surfaceCount];     // its box
  vec4 surfaceHigh[surfaceCount];
  vec4 materials[2 * meshCount];        // rgb colour, ambient; diffuse, specular, shininess, -
  vec4 lightPosition[lightLimit];       // xyz
  vec4 lightColor[lightLimit];       // rgb times intensity

  vec4 screenCorner;  // of the RT camera's pixel grid: xyz upper left; w: opacity, 0: not drawn
  vec4 screenRight;   // xyz to the right corner; w: columns
  vec4 screenDown;    // xyz to the lower corner; w: rows

  ivec4 counts;   // x: lights, y: reflections in a row, w: 1 when there is a ground
  ivec4 options;  // x: 1 with shadows, y: 1 with light markers, z: planes that cut the mirror off
  ivec4 surfaceOffsets[surfaceCount];  // where its nodes, triangles, vertices and normals begin
  ivec4 surfaceSize[surfaceCount];     // x: triangles, y: flags, z: root, as intersectSurfaces() keeps nodes
};
