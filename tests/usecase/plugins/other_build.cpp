// A plug-in that another version was built for.
#undef SVCHAIN_VERSION
#define SVCHAIN_VERSION "99.0.0"
#include "tests/usecase/plugins/brighten.cpp"
