#include "usecases/svchain_accuracy/agreement.h"
#include "usecases/svchain_accuracy/experiments.h"
#include "usecases/svchain_accuracy/real_sets.h"
#include "usecases/svchain_accuracy/real_tables.h"

namespace svchain::accuracy {

Section real_garage(const std::filesystem::path& data) {
  const std::string title = "A real car in a garage, the lens from its maker's table";
  const auto input = read_garage(data);
  if (!input) return absent(title, input.error());
  const HeldOutResult result = hold_out_in_turn(*input);
  return {
      title,
      "Set `real_garage_lens_table`: a car with four 1280x720 fisheyes among boards that nobody measured "
      "the places of (`configs/rigs/garage.json`, `configs/charts/garage.json`). Halves of the corners as "
      "above. " +
          how_it_ended(result),
      {between_cameras(result, {1.4, 1.4, 1.4, 1.4})}};
}

}  // namespace svchain::accuracy
