// A shared library that knows nothing of links.
extern "C" int answer() {
  return 42;
}
