// Which triangle is seen: 1 + its index in `triangles`; 0 is none. Everything else follows from that.
flat in uint seenTriangle;
out uint id;

void main() {
  id = seenTriangle;
}
