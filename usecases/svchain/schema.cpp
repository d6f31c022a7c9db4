#include "framework/usecase/schema.h"

#include <algorithm>
#include <iostream>

#include "algorithms/json/document.h"
#include "links/builtin_links.h"
#include "links/configs_folder.h"
#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"

namespace svchain::program {

int schema(const std::string& kind) {
  static const std::vector<std::string> kKinds = {"usecase",     "rig",        "charts", "corners",
                                                  "calibration", "comparison", "soc",    "costs",
                                                  "scene",       "path",       "faults", "report"};
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end()) {
    return say({{"schema",
                 {},
                 {},
                 "unknown kind \"" + kind + "\"" + did_you_mean(kind, kKinds) +
                     " (known: " + spoken_list(kKinds) + ")"}});
  }
  if (kind == "usecase") {
    Catalogue catalogue;
    add_builtin_links(catalogue);
    std::cout << use_case_schema(catalogue);
    return kDone;
  }
  const auto text = json::read_text(configs_folder() / "schemas" / (kind + ".schema.json"));
  if (!text) return say(text.error());
  std::cout << *text;
  return kDone;
}

}  // namespace svchain::program
