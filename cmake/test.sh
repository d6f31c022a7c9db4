#!/bin/sh
# Builds everything and runs all tests.
#
#   sh cmake/test.sh [PRESET [CTEST OPTION...]]      release unless told otherwise; asan, tsan, debug
set -eu
cd "$(dirname "$0")/.."
preset=${1:-release}
[ $# -eq 0 ] || shift

sh cmake/install_packages.sh
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)" "$@"
