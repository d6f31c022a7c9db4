#!/bin/sh
# From a bare machine to a picture: installs what is needed, builds the program and lets it look at its simulated car park.
#
#   sh cmake/bootstrap.sh        leaves out/top_view.png and out/top_view.mp4
set -eu
cd "$(dirname "$0")/.."

sh cmake/install_packages.sh
cmake --preset release
cmake --build --preset release --target svchain
mkdir -p out
for picture in out/top_view.png out/top_view.mp4; do
  build/release/bin/svchain --usecase 2dsv_2dsp --frames 60 --output "$picture"
done

echo
echo "Top view:  $(pwd)/out/top_view.png"
echo "Video:     $(pwd)/out/top_view.mp4"
