#include "framework/link/plugin.h"

#include <cstdio>
#include <dlfcn.h>

namespace svchain {

namespace {

using EntryFunction = const plugin::Entry* (*)();

/// The loader's message, without the path that it starts with.
std::string loader_message(const std::filesystem::path& path) {
  const char* said = dlerror();
  std::string message = said ? said : "unknown error";
  const std::string prefix = path.string() + ": ";
  return message.compare(0, prefix.size(), prefix) == 0 ? message.substr(prefix.size()) : message;
}

std::string described(const char* build, uint64_t layout) {
  char hex[17];
  std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(layout));
  return "\"" + std::string(build) + ", layout " + hex + "\"";
}

bool same_build(const plugin::Entry& entry) {
  return std::string(entry.build) == SVCHAIN_BUILD && entry.layout == plugin::kLayout;
}

}  // namespace

Result<PluginHandle> load_plugin(const std::filesystem::path& path, Catalogue& catalogue) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return fail(path.string(), "there is no such file, expected a plug-in (a shared library)");
  }
  const std::filesystem::path absolute = std::filesystem::absolute(path);
  std::shared_ptr<void> library(dlopen(absolute.c_str(), RTLD_NOW | RTLD_LOCAL), [](void* handle) {
    if (handle) dlclose(handle);
  });
  if (!library)
    return fail(path.string(), "cannot be loaded as a shared library: " + loader_message(absolute));

  const auto entry_of = reinterpret_cast<EntryFunction>(dlsym(library.get(), "svchain_plugin"));
  if (!entry_of) return fail(path.string(), "is no plug-in: none of its sources says SVCHAIN_PLUGIN(Class)");
  const plugin::Entry& entry = *entry_of();
  if (!same_build(entry)) {
    return fail(path.string(), "is from another build: it was built with " +
                                   described(entry.build, entry.layout) + ", this program with " +
                                   described(SVCHAIN_BUILD, plugin::kLayout));
  }
  const std::string type = std::unique_ptr<Link>(entry.make())->describe().type;
  const auto make = [library, create = entry.make] { return std::unique_ptr<Link>(create()); };
  if (!catalogue.add(make)) return fail(path.string(), "its link type \"" + type + "\" is taken already");
  return PluginHandle{path, type, library};
}

}  // namespace svchain
