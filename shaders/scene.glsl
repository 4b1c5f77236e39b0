// What is the same for every pixel of a pass. src/viewport/scene_block.h has the same fields in the same order.
// Places are relative to the middle of the scene, so that float has digits to spare wherever the scene is.

const int surfaceCount = 3;  // 0 sculpture, 1 original, 2 model of the RT camera
const int lightLimit = 16;

const int inMirror = 1;      // flags of a surface: the mirror shows it,
const int castsShadow = 2;   // it takes light from what is seen directly,
const int castsInMirror = 4; // and from what is seen in the mirror,
const int hasWires = 8;      // its triangles' edges are drawn
const int wholeMesh = 16;    // every vertex is usable

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
  vec4 groundMaterial[2];  // as materials[]

  vec4 mirror;         // xyz: corner, lower end or centre; w: radius
  vec4 mirrorAxis;     // xyz: normal or axis; w: length of the axis, or longest edge
  vec4 mirrorEdges[4]; // plane: xyz inward, w: inward . q on the edge
  vec4 mirrorTint;     // rgb: colour times reflectance

  vec4 surfaceCentre[surfaceCount];  // xyz; w: radius
  vec4 surfaceLow[surfaceCount];     // its box
  vec4 surfaceHigh[surfaceCount];
  vec4 materials[2 * surfaceCount];     // rgb colour, ambient; diffuse, specular, shininess, -
  vec4 lightPosition[lightLimit];       // xyz
  vec4 lightColor[lightLimit];       // rgb times intensity

  vec4 screenCorner;  // of the RT camera's pixel grid: xyz upper left; w: opacity, 0: not drawn
  vec4 screenRight;   // xyz to the right corner; w: columns
  vec4 screenDown;    // xyz to the lower corner; w: rows

  ivec4 counts;  // x: lights, y: reflections in a row, z: kind of mirror (0: none), w: 1 when there is a ground
  ivec4 options; // x: 1 with shadows, y: 1 with light markers, z: look of the original (0 hidden, 1 solid, 2 ghost)
  ivec4 surfaceOffsets[surfaceCount];  // where its nodes, triangles, vertices and normals begin
  ivec4 surfaceSize[surfaceCount];   // x: triangles, y: flags, z: root, as intersectSurfaces() keeps nodes
};
