# How every target of the project is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

set(SVCHAIN_SANITIZE "" CACHE STRING "Sanitizers for everything, as in -fsanitize=: address,undefined or thread")
if(SVCHAIN_SANITIZE)
  add_compile_options(-fsanitize=${SVCHAIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # Two of the undefined ones would take a third of the time that compiling takes. The address sanitizer finds null
  # pointers by itself, and the processors at hand load from any address.
  add_compile_options(-fno-sanitize=null,alignment)
  add_link_options(-fsanitize=${SVCHAIN_SANITIZE})
endif()

# svchain_library(NAME SOURCES... [DEPENDS ...] [PRIVATE ...]): one floor, or one room of a floor.
function(svchain_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  add_library(svchain_${name} STATIC ${ARG_SOURCES})
  add_library(svchain::${name} ALIAS svchain_${name})
  set_target_properties(svchain_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(svchain_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/svchain>)
  target_compile_features(svchain_${name} PUBLIC cxx_std_20)
  target_compile_options(svchain_${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # false alarms of g++ 12 on std::string
  target_link_libraries(svchain_${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE})
endfunction()
