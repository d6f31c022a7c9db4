#include "framework/usecase/schema.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/usecase/entries.h"
#include "framework/usecase/soc.h"

namespace svchain {

namespace {

using Json = nlohmann::ordered_json;

const char* const kNamePattern = "^[a-z][a-z0-9_]*$";
const char* const kEndPattern = "^[ \\t]*[a-z][a-z0-9_]*\\.[a-z][a-z0-9_]*[ \\t]*$";
const char* const kEdgePattern =
    "^[ \\t]*[a-z][a-z0-9_]*\\.[a-z][a-z0-9_]*[ \\t]*->[ \\t]*[a-z][a-z0-9_]*\\.[a-z][a-z0-9_]*[ \\t]*$";

Json bounded(const char* type, const json::Range& range) {
  Json schema = {{"type", type}};
  if (std::isfinite(range.minimum)) schema["minimum"] = range.minimum;
  if (std::isfinite(range.maximum)) schema["maximum"] = range.maximum;
  return schema;
}

Json kind_of(const ParameterDescription& d) {
  switch (d.kind) {
    case Kind::kBoolean:
      return {{"type", "boolean"}};
    case Kind::kInteger:
      return bounded("integer", d.range);
    case Kind::kNumber:
      return bounded("number", d.range);
    case Kind::kString:
      return {{"type", "string"}};
    case Kind::kChoice:
      return {{"enum", d.choices}};
    case Kind::kNumbers:
      return {{"type", "array"},
              {"items", bounded("number", d.range)},
              {"minItems", d.count},
              {"maxItems", d.count}};
  }
  return {};
}

Json parameter(const ParameterDescription& d) {
  Json schema = kind_of(d);
  std::string help = d.help;
  if (!d.unit.empty()) help += (help.empty() ? "in " : ", in ") + d.unit;
  if (!help.empty()) schema["description"] = help;
  if (!d.fallback.is_null()) schema["default"] = d.fallback;
  return schema;
}

Json closed_object(Json properties) {
  return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json parameters(const std::vector<ParameterDescription>& descriptions) {
  Json properties = Json::object();
  for (const auto& d : descriptions) properties[d.name] = parameter(d);
  return closed_object(std::move(properties));
}

Json setting(const SettingDescription& setting) {
  Json schema = setting.is_plain() ? parameter(setting.parameters.front()) : parameters(setting.parameters);
  if (!setting.help.empty()) schema["description"] = setting.help;
  return schema;
}

/// Any link, and for each type what its params may be.
Json link(const Catalogue& catalogue) {
  Json schema = closed_object(
      {{"type", {{"enum", catalogue.link_types()}}},
       {"core", {{"type", "string"}, {"description", "core of the SoC, or a role such as host"}}},
       {"params", {{"type", "object"}}},
       {"on_error",
        {{"enum", kOnErrorNames},
         {"default", kOnErrorNames.front()},
         {"description", "a frame that fails stops the chain, or is dropped"}}}});
  schema["required"] = {"type", "core"};
  schema["allOf"] = Json::array();
  for (const std::string& type : catalogue.link_types()) {
    const LinkDescription description = catalogue.make(type)->describe();
    Json params = parameters(description.parameters);
    if (!description.help.empty()) params["description"] = description.help;
    schema["allOf"].push_back({{"if", {{"properties", {{"type", {{"const", type}}}}}}},
                               {"then", {{"properties", {{"params", std::move(params)}}}}}});
  }
  return schema;
}

Json edge() {
  const EdgeEntry fallback;
  const Json end = {{"type", "string"}, {"pattern", kEndPattern}};
  Json object = closed_object(
      {{"from", end},
       {"to", end},
       {"depth",
        {{"type", "integer"},
         {"minimum", 1},
         {"maximum", kDeepestEdge},
         {"default", fallback.depth},
         {"description", "frames that may wait here"}}},
       {"policy", {{"enum", kPolicyNames}, {"default", kPolicyNames.front()}}},
       {"feedback",
        {{"type", "boolean"}, {"default", false}, {"description", "the edge that closes a cycle"}}}});
  object["required"] = {"from", "to"};
  return {{"oneOf", {{{"type", "string"}, {"pattern", kEdgePattern}}, std::move(object)}}};
}

}  // namespace

std::string use_case_schema(const Catalogue& catalogue) {
  Json properties = {
      {"$schema", {{"type", "string"}}},
      {"name", {{"type", "string"}}},
      {"title", {{"type", "string"}}},
      {"soc", {{"type", "string"}, {"description", "name of a SoC, see svchain list socs"}}},
      {"cpus",
       {{"type", "object"},
        {"description",
         "by core: how many CPUs its links may share their work among, instead "
         "of what the SoC file says"},
        {"additionalProperties", {{"type", "integer"}, {"minimum", 1}, {"maximum", kMostCpus}}}}},
      {"plugins", {{"type", "array"}, {"items", {{"type", "string"}}}}}};
  for (const auto& description : catalogue.settings()) properties[description.name] = setting(description);
  properties["links"] = {{"type", "object"},
                         {"propertyNames", {{"pattern", kNamePattern}}},
                         {"additionalProperties", {{"$ref", "#/$defs/link"}}},
                         {"minProperties", 1}};
  properties["edges"] = {{"type", "array"}, {"items", {{"$ref", "#/$defs/edge"}}}};

  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "svchain use case"}};
  schema.update(closed_object(std::move(properties)));
  schema["required"] = {"name", "links"};
  schema["$defs"] = {{"link", link(catalogue)}, {"edge", edge()}};
  return schema.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace svchain
