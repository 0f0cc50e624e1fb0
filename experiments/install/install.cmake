# cmake --install build --prefix PREFIX: libraries, headers, the program with its data and pages, and the CMake package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(subdivlab_headers "${CMAKE_INSTALL_INCLUDEDIR}/subdivlab")
set(subdivlab_package "${CMAKE_INSTALL_LIBDIR}/cmake/subdivlab")
set(subdivlab_data "${CMAKE_INSTALL_DATADIR}/subdivlab/data")

# Users get the folder at which includes start, C++20, and arithmetic that is not contracted: error bounds are proved
# for it. Warnings and their consequences are the project's own.
foreach(layer schemes analysis optimize experiments)
  get_target_property(type subdiv_${layer} TYPE)
  set(scope PUBLIC)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  endif()
  target_include_directories(subdiv_${layer} ${scope} "$<INSTALL_INTERFACE:${subdivlab_headers}>")
  target_compile_features(subdiv_${layer} ${scope} cxx_std_20)
  target_compile_options(subdiv_${layer} ${scope} "$<INSTALL_INTERFACE:-ffp-contract=off>")
  set_target_properties(subdiv_${layer} PROPERTIES EXPORT_NAME ${layer})
  add_library(subdivlab::${layer} ALIAS subdiv_${layer})
  install(TARGETS subdiv_${layer} EXPORT subdivlab ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endforeach()

# Headers, but those of the program's own verbs.
file(GLOB_RECURSE headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS
     "${PROJECT_SOURCE_DIR}/schemes/*.h" "${PROJECT_SOURCE_DIR}/analysis/*.h"
     "${PROJECT_SOURCE_DIR}/optimize/*.h" "${PROJECT_SOURCE_DIR}/experiments/*.h")
list(FILTER headers EXCLUDE REGEX "^experiments/cli/|^experiments/example/")
foreach(header IN LISTS headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES "${header}" DESTINATION "${subdivlab_headers}/${folder}")
endforeach()

# The program looks for its data relative to itself, so that no folder of this machine is left in it; in the build tree
# a link stands where it looks.
file(RELATIVE_PATH data_from_program "/${CMAKE_INSTALL_BINDIR}" "/${subdivlab_data}")
set_source_files_properties("${PROJECT_SOURCE_DIR}/experiments/data.cpp" PROPERTIES
  COMPILE_DEFINITIONS "SUBDIVLAB_DATA_FROM_PROGRAM=\"${data_from_program}\"")
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/share/subdivlab")
file(CREATE_LINK "${PROJECT_SOURCE_DIR}/experiments/data" "${PROJECT_BINARY_DIR}/share/subdivlab/data" SYMBOLIC)
if(TARGET subdivlab)
  install(TARGETS subdivlab RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/experiments/data/" DESTINATION "${subdivlab_data}")

set(docs "${PROJECT_SOURCE_DIR}/experiments/docs")
install(FILES "${docs}/subdivlab.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" OPTIONAL)
install(FILES "${docs}/completion.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
        RENAME subdivlab OPTIONAL)
install(FILES "${docs}/completion.zsh" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions"
        RENAME _subdivlab OPTIONAL)
install(FILES "${docs}/completion.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d"
        RENAME subdivlab.fish OPTIONAL)
install(FILES "${docs}/tutorial.md" DESTINATION "${CMAKE_INSTALL_DOCDIR}" OPTIONAL)
file(GLOB schemas CONFIGURE_DEPENDS "${docs}/*.schema.json")
install(FILES ${schemas} DESTINATION "${CMAKE_INSTALL_DATADIR}/subdivlab/schemas")

write_basic_package_version_file("${PROJECT_BINARY_DIR}/subdivlab-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(EXPORT subdivlab NAMESPACE subdivlab:: FILE subdivlab-targets.cmake DESTINATION "${subdivlab_package}")
install(FILES "${PROJECT_SOURCE_DIR}/experiments/install/subdivlab-config.cmake"
              "${PROJECT_SOURCE_DIR}/experiments/install/dependencies.cmake"
              "${PROJECT_BINARY_DIR}/subdivlab-config-version.cmake"
        DESTINATION "${subdivlab_package}")
