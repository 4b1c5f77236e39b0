// Where the selected mesh is.
flat in uint seenTriangle;
out vec4 mask;

void main() {
  mask = vec4(1.0);
}
