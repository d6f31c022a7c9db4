# Everything from outside, found once.
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs videoio highgui calib3d aruco)
find_package(hwy REQUIRED)  # Highway: libhwy-dev
find_package(Boost REQUIRED)  # headers only: Asio
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tl-expected REQUIRED)
find_package(CLI11 REQUIRED)
find_package(yaml-cpp REQUIRED)
if(NOT TARGET yaml-cpp::yaml-cpp)  # before 0.8 the target had no namespace
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)
endif()
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(tinyobjloader REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)  # OpenGL ES and EGL: libepoxy-dev
