#pragma once
// Links from outside: a shared library with one link class and, in one of its sources, SVCHAIN_PLUGIN(Class).
// It is built against the installed package (target svchain::framework); one that was built by another
// compiler, standard or version is refused by name instead of crashing later.
//
// Ownership: the catalogue's factory keeps the library loaded, so links that it made must go before the
// catalogue does. One thread.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "framework/link/call.h"
#include "framework/link/catalogue.h"

#ifndef SVCHAIN_VERSION
#error "SVCHAIN_VERSION is not defined: link to the target svchain::framework"
#endif

#define SVCHAIN_TEXT_OF(x) #x
#define SVCHAIN_TEXT(x) SVCHAIN_TEXT_OF(x)

#if defined(__clang__)
#define SVCHAIN_COMPILER "clang " __clang_version__
#elif defined(__GNUC__)
#define SVCHAIN_COMPILER "gcc " __VERSION__
#else
#define SVCHAIN_COMPILER "an unknown compiler"
#endif

#ifdef _GLIBCXX_DEBUG
#define SVCHAIN_CHECKED_LIBRARY ", checked standard library"
#else
#define SVCHAIN_CHECKED_LIBRARY ""
#endif

/// What a library was built with. A macro, so that it tells of the library that it is written in.
#define SVCHAIN_BUILD \
  "svchain " SVCHAIN_VERSION ", " SVCHAIN_COMPILER ", C++ " SVCHAIN_TEXT(__cplusplus) SVCHAIN_CHECKED_LIBRARY

namespace svchain {

namespace plugin {

/// Raised when a virtual function of Link, Call or Configuration is added, removed or moved.
constexpr uint64_t kInterface = 1;

template <class... Types>
constexpr uint64_t sizes_hash() {
  uint64_t hash = 14695981039346656037u ^ kInterface;  // FNV-1a
  ((hash = (hash ^ (sizeof(Types) * 64 + alignof(Types))) * 1099511628211u), ...);
  return hash;
}

/// Differs where the types that cross the border are laid out differently.
constexpr uint64_t kLayout =
    sizes_hash<Link, LinkDescription, PortDescription, ParameterDescription, Parameters, Configuration, Pace,
               Call, Frame, Draft, Format, ipc::Message, Fault, nlohmann::json, std::string, std::vector<int>,
               LinkFactory>();

/// What the entry of a plug-in returns. Its own layout never changes.
struct Entry {
  const char* build;
  uint64_t layout;
  Link* (*make)();
};

}  // namespace plugin

struct PluginHandle {
  std::filesystem::path path;
  std::string type;               // of the link it adds
  std::shared_ptr<void> library;  // loaded as long as somebody has it
};

/// Loads a library and adds its link. Faults name the file: it is missing, no shared library, no plug-in,
/// from another build (both are named), or its link type is taken.
Result<PluginHandle> load_plugin(const std::filesystem::path& path, Catalogue& catalogue);

}  // namespace svchain

#define SVCHAIN_PLUGIN(Class)                                                                        \
  extern "C" __attribute__((visibility("default"))) const svchain::plugin::Entry* svchain_plugin() { \
    static constexpr svchain::plugin::Entry kEntry{SVCHAIN_BUILD, svchain::plugin::kLayout,          \
                                                   []() -> svchain::Link* { return new Class; }};    \
    return &kEntry;                                                                                  \
  }
