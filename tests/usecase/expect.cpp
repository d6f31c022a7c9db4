#include "tests/usecase/expect.h"

#include <algorithm>

#include "tests/catch.h"
#include "tests/usecase/fake_links.h"

namespace svchain::testing {

const std::string kTwoDsps = R"({"name":"2dsv_2dsp","soc":"tda2x","view":{"size_px":[880,1080]},
 "links":{"capture":{"type":"capture","core":"IPU1"},
  "sync":{"type":"sync","core":"IPU1","params":{"delta_ms":10}},
  "dup":{"type":"dup","core":"IPU1"},
  "geometric_alignment":{"type":"geometric_alignment","core":"DSP1"},
  "synthesis":{"type":"synthesis","core":"DSP2"},
  "photometric_alignment":{"type":"photometric_alignment","core":"DSP1"},
  "display":{"type":"display","core":"host"}},
 "edges":["capture.front -> sync.front","capture.right -> sync.right","capture.rear -> sync.rear","capture.left -> sync.left",
  "sync.frames -> dup.in","dup.out0 -> geometric_alignment.frames","dup.out1 -> synthesis.frames",
  "geometric_alignment.lut -> synthesis.lut","synthesis.statistics -> photometric_alignment.statistics",
  {"from":"photometric_alignment.tone_mapping","to":"synthesis.tone_mapping","feedback":true},
  {"from":"synthesis.view","to":"display.frames","depth":3,"policy":"block"}]})";

void check_fault(const Faults& faults, const std::string& place, const std::vector<std::string>& words) {
  std::string all, wanted = place;
  for (const Fault& fault : faults) all += fault.text() + "\n";
  for (const std::string& word : words) wanted += " ... " + word;
  INFO("expected: " << wanted << "\nfound:\n" << all);
  const bool found = std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
    return (place.empty() || fault.text().compare(0, place.size() + 2, place + ": ") == 0) &&
           std::all_of(words.begin(), words.end(), [&](const std::string& word) {
             return fault.message.find(word) != std::string::npos;
           });
  });
  CHECK(found);
}

std::string text_of(const std::vector<std::string>& links, const std::vector<std::string>& edges) {
  std::string text = R"({"name": "t", "soc": "tda2x", "links": {)";
  for (size_t i = 0; i < links.size(); ++i) text += (i > 0 ? ",\n" : "\n") + links[i];
  text += "},\n\"edges\": [";
  for (size_t i = 0; i < edges.size(); ++i) text += (i > 0 ? ",\n" : "\n") + edges[i];
  return text + "]}\n";
}

Soc small_soc() {
  Soc soc;
  soc.name = "tda2x";
  soc.title = "TDA2x";
  soc.cores = {{"A15", "A15", 1000, {}, 2},
               {"IPU1", "M4", 200, {}, 2},
               {"DSP1", "C66x", 600, {}},
               {"DSP2", "C66x", 600, {}}};
  soc.roles = {{"host", "A15"}};
  return soc;
}

Result<Plan> plan_of(const std::string& text) {
  const Catalogue catalogue = fake_catalogue();
  auto use_case = parse_use_case(text, "t.json", catalogue);
  if (!use_case) {
    for (const Fault& fault : use_case.error()) UNSCOPED_INFO(fault.text());
  }
  REQUIRE(use_case);
  return make_plan(std::move(*use_case), small_soc(), catalogue);
}

Faults plan_faults(const std::string& text) {
  const auto plan = plan_of(text);
  REQUIRE_FALSE(plan);
  return plan.error();
}

}  // namespace svchain::testing
