# What `cmake --install` leaves: the program and what it reads, and a package for links from outside (find_package(svchain),
# target svchain::framework; examples/edge_link shows how).
include(CMakePackageConfigHelpers)

install(TARGETS svchain RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY usecases DESTINATION ${CMAKE_INSTALL_DATADIR}/svchain FILES_MATCHING
  PATTERN "*.json" PATTERN "svchain*" EXCLUDE)
install(DIRECTORY configs DESTINATION ${CMAKE_INSTALL_DATADIR}/svchain)

install(TARGETS svchain_ipc svchain_json svchain_framework EXPORT svchain ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ipc framework DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/svchain FILES_MATCHING PATTERN "*.h"
  REGEX "/usecase/(entries|graph.*|palette|place|plan_steps)\\.h$|/fault/(fault_places|random_faults)\\.h$|/chain/(runtime|link_configuration)\\.h$" EXCLUDE)  # internal
install(DIRECTORY algorithms/json DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/svchain/algorithms FILES_MATCHING PATTERN "*.h")

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/svchain)
install(EXPORT svchain NAMESPACE svchain:: FILE svchainTargets.cmake DESTINATION ${package_folder})
configure_package_config_file(cmake/svchainConfig.cmake.in ${PROJECT_BINARY_DIR}/svchainConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/svchainConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/svchainConfig.cmake ${PROJECT_BINARY_DIR}/svchainConfigVersion.cmake
  DESTINATION ${package_folder})
