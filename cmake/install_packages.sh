#!/bin/sh
# Installs what the project is built from, on Debian 12 or Ubuntu 24.04, as root or with sudo. Does nothing where all of it
# is there already.
set -eu

packages="
  build-essential cmake ninja-build ccache
  libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev libopencv-videoio-dev libopencv-highgui-dev
  libopencv-calib3d-dev libopencv-contrib-dev
  libeigen3-dev libhwy-dev libboost-dev libspdlog-dev libexpected-dev nlohmann-json3-dev libcli11-dev libssl-dev libyaml-cpp-dev
  libtinyobjloader-dev libtinygltf-dev
  pkg-config libepoxy-dev libegl-dev libgles-dev libegl1 libgles2 libegl-mesa0 libgl1-mesa-dri
  catch2 libbenchmark-dev
"

missing=""
for package in $packages; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=""
[ "$(id -u)" -eq 0 ] || as_root="sudo"
echo "installing:$missing"
$as_root apt-get update -q
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
