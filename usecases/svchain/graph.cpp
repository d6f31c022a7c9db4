#include <algorithm>
#include <iostream>

#include "usecases/svchain/commands.h"
#include "usecases/svchain/exit_status.h"
#include "usecases/svchain/say_faults.h"

namespace svchain::program {

int graph(const GraphOptions& options) {
  static const std::vector<std::string> kFormats = {"dot", "svg", "json"};
  Faults faults;
  if (std::find(kFormats.begin(), kFormats.end(), options.format) == kFormats.end()) {
    faults.push_back({"--format",
                      {},
                      {},
                      "expected " + spoken_list(kFormats) + ", got \"" + options.format + "\"" +
                          did_you_mean(options.format, kFormats)});
  }
  const auto planned = plan_use_case(options.use_case);
  if (!planned) append(faults, planned.error());
  if (!faults.empty()) return say(faults);

  const Plan& plan = planned->plan;
  const std::string text = options.format == "svg"    ? graph_svg(plan)
                           : options.format == "json" ? graph_json(plan)
                                                      : graph_dot(plan);
  std::cout << text;
  if (!text.ends_with('\n')) std::cout << '\n';
  return kDone;
}

}  // namespace svchain::program
