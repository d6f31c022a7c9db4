#include "tests/usecase/fake_links.h"

namespace svchain::testing {

namespace {

PortDescription port(std::string name, std::vector<std::string> types, int count) {
  PortDescription port;
  port.name = std::move(name);
  port.types = std::move(types);
  port.count = count;
  return port;
}

PortDescription state(PortDescription port) {
  port.intake = Intake::kState;
  return port;
}

PortDescription optional(PortDescription port) {
  port.optional = true;
  return port;
}

PortDescription forwarding(std::string name, std::vector<std::string> inputs, int count) {
  PortDescription out = port(std::move(name), {}, count);
  out.forwards = std::move(inputs);
  return out;
}

LinkDescription described(std::string type, std::vector<PortDescription> inputs,
                          std::vector<PortDescription> outputs,
                          std::vector<ParameterDescription> parameters = {}) {
  LinkDescription d;
  d.type = std::move(type);
  d.help = "what " + d.type + " does";
  d.inputs = std::move(inputs);
  d.outputs = std::move(outputs);
  d.parameters = std::move(parameters);
  return d;
}

std::vector<LinkDescription> descriptions() {
  std::vector<PortDescription> cameras, sets;
  for (const char* name : {"front", "right", "rear", "left"}) {
    cameras.push_back(port(name, {"bgr8", "nv12"}, 1));
    sets.push_back(port(name, {}, 1));
  }
  std::vector<LinkDescription> all;
  all.push_back(described("capture", {}, cameras, {path("file", "where from")}));
  all.push_back(described("sync", sets, {forwarding("frames", {"front", "right", "rear", "left"}, 4)},
                          {number("delta_ms", 10, {0, 1000}, "ms", "how far apart")}));
  all.push_back(described(
      "dup", {port("in", {}, 0)},
      {forwarding("out0", {"in"}, 0), forwarding("out1", {"in"}, 0), forwarding("out2", {"in"}, 0)}));
  all.push_back(
      described("geometric_alignment", {port("frames", {"bgr8"}, 4)}, {port("lut", {"geometric_lut"}, 1)}));
  all.push_back(
      described("synthesis",
                {port("frames", {"bgr8"}, 4), state(port("lut", {"geometric_lut"}, 1)),
                 optional(port("tone_mapping", {"tone_mapping"}, 1))},
                {port("view", {"bgr8"}, 1), port("statistics", {"overlap_statistics"}, 1)},
                {choice("kernel", "automatic", {"automatic", "portable", "avx2"}, "which one"),
                 integer("threads", 1, {1, 16}, "", "how many"), boolean("falloff", false, "corrects it")}));
  all.push_back(described("photometric_alignment", {port("statistics", {"overlap_statistics"}, 1)},
                          {port("tone_mapping", {"tone_mapping"}, 1)}));
  all.push_back(described("display", {port("frames", {"bgr8"}, 1)}, {}));
  all.back().delivers = true;
  all.push_back(described("null", {port("in", {}, 0)}, {}));
  all.push_back(described("gain", {port("in", {"bgr8"}, 1)}, {port("out", {"bgr8"}, 1)}));
  all.push_back(
      described("join", {port("a", {}, 0), optional(port("b", {}, 0))}, {port("out", {"bgr8"}, 1)}));
  return all;
}

}  // namespace

Catalogue fake_catalogue() {
  Catalogue catalogue;
  for (const LinkDescription& d : descriptions()) {
    catalogue.add([d] { return std::make_unique<FakeLink>(d); });
  }
  ParameterDescription size;
  size.name = "size_px";
  size.kind = Kind::kNumbers;
  size.count = 2;
  size.fallback = {880, 1080};
  size.range = {16, 8192};
  size.unit = "px";
  ParameterDescription scale = number("metres_per_px", 0, {0.0001, 1}, "m", "worked out when not given");
  scale.fallback = nullptr;
  catalogue.add(SettingDescription{"view", "the composite", {size, scale}});
  catalogue.add(SettingDescription{"rig", "vehicle and cameras", {path("value", "a rig file")}});
  catalogue.add(SettingDescription{"output", "where to", {text("value", "none", "a file")}});
  return catalogue;
}

}  // namespace svchain::testing
