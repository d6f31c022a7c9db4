#pragma once
// The sections of docs/accuracy.md. What a section needs and does not find it says in the section.

#include <filesystem>
#include <vector>

#include "usecases/svchain_accuracy/simulated_set.h"
#include "usecases/svchain_page/document.h"

namespace svchain::accuracy {

using page::figure;
using page::markdown;
using page::met;
using page::Section;
using page::Table;

/// The sets that have been measured so far.
Section simulated_rigs(const std::vector<SetResult>& results);

/// `data` holds the folders of the sets.
Section real_carpet(const std::filesystem::path& data);
Section real_garage(const std::filesystem::path& data);
Section features(const std::filesystem::path& data);
Section photometric(const std::filesystem::path& data);
Section rendered(const std::filesystem::path& data);
Section stage_times(const std::filesystem::path& data);

}  // namespace svchain::accuracy
