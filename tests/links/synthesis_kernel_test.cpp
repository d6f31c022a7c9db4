// Which kernel the link synthesis runs on.

#include "algorithms/synthesis/kernel.h"
#include "framework/testing/harness.h"
#include "links/synthesis.h"
#include "tests/catch.h"

using namespace svchain;
using namespace svchain::testing;
using Catch::Matchers::Contains;

namespace {

Faults configure(LinkHarness& harness, const std::string& kernel) {
  harness.parameter("kernel", kernel);
  harness.setting("view", "size_px", {80, 80});
  harness.input("frames", PortFormat(4, Format::bgr8(64, 48)));
  harness.input("lut", {Format::table("geometric_lut", 1000)});
  return harness.configure();
}

std::string kernel_in_report(LinkHarness& harness) {
  nlohmann::json report;
  harness.link().report(report);
  return report["synthesis"]["kernel"];
}

}  // namespace

TEST_CASE("synthesis runs on the kernel it is told to, and the report says which") {
  for (const synthesis::Kernel kernel : synthesis::runnable_kernels()) {
    LinkHarness harness(make_synthesis());
    CHECK(configure(harness, synthesis::name_of(kernel)).empty());
    CHECK(kernel_in_report(harness) == synthesis::name_of(kernel));
  }
}

TEST_CASE("left to itself synthesis takes the fastest kernel that the processor runs") {
  LinkHarness harness(make_synthesis());
  CHECK(configure(harness, "auto").empty());
  CHECK(kernel_in_report(harness) == synthesis::name_of(synthesis::best_kernel()));
}

TEST_CASE("a kernel that the processor lacks is a fault of the parameter, which says what there is") {
  using synthesis::Kernel;
  const Kernel lacking = synthesis::can_run(Kernel::kNeon) ? Kernel::kAvx2 : Kernel::kNeon;
  LinkHarness harness(make_synthesis());
  const Faults faults = configure(harness, synthesis::name_of(lacking));
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0].text(),
             Contains("kernel") && Contains("this processor does not run") && Contains("only portable"));
}
