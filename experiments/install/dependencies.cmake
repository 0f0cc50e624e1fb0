# What subdivlab's libraries stand on, for its own build and, installed beside subdivlab-config.cmake, for every project
# that finds the package.

# In the package a missing library makes the package not found; in subdivlab's own build it ends the configuration.
macro(subdivlab_find)
  if(DEFINED CMAKE_FIND_PACKAGE_NAME)
    include(CMakeFindDependencyMacro)
    find_dependency(${ARGN})
  else()
    find_package(${ARGN} REQUIRED)
  endif()
endmacro()

# A library without CMake configuration as the target subdivlab::NAME: subdivlab_import(NAME HEADER PACKAGE [libraries...]).
macro(subdivlab_import name header package)
  if(NOT TARGET subdivlab::${name})
    find_path(subdivlab_${name}_INCLUDE_DIR "${header}")
    find_library(subdivlab_${name}_LIBRARY "${name}")
    mark_as_advanced(subdivlab_${name}_INCLUDE_DIR subdivlab_${name}_LIBRARY)
    if(subdivlab_${name}_INCLUDE_DIR AND subdivlab_${name}_LIBRARY)
      add_library(subdivlab::${name} UNKNOWN IMPORTED)
      set_target_properties(subdivlab::${name} PROPERTIES
        IMPORTED_LOCATION "${subdivlab_${name}_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${subdivlab_${name}_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${ARGN}")
    else()
      set(subdivlab_missing "<${header}> or lib${name} not found: install ${package}")
      if(NOT DEFINED CMAKE_FIND_PACKAGE_NAME)
        message(FATAL_ERROR "${subdivlab_missing} (experiments/setup does)")
      endif()
      set(${CMAKE_FIND_PACKAGE_NAME}_FOUND FALSE)
      set(${CMAKE_FIND_PACKAGE_NAME}_NOT_FOUND_MESSAGE "${subdivlab_missing}")
      return()
    endif()
  endif()
endmacro()

subdivlab_find(Boost 1.74)
subdivlab_find(Ceres 2.1)
subdivlab_find(Eigen3 3.4 NO_MODULE)
subdivlab_find(fmt)
subdivlab_find(hwy)
subdivlab_find(NLopt)
subdivlab_find(Threads)

subdivlab_import(gmp gmp.h libgmp-dev)
subdivlab_import(mpfr mpfr.h libmpfr-dev subdivlab::gmp)
subdivlab_import(flint flint/flint.h libflint-dev subdivlab::mpfr subdivlab::gmp)
subdivlab_import(flint-arb arb.h libflint-arb-dev subdivlab::flint)              # <arb.h>
subdivlab_import(calcium calcium/qqbar.h libcalcium-dev subdivlab::flint-arb)    # <calcium/qqbar.h>
subdivlab_import(cddgmp cddlib/cdd.h libcdd-dev subdivlab::gmp)                  # <cddlib/setoper.h>, <cddlib/cdd.h>
set_property(TARGET subdivlab::cddgmp PROPERTY
  INTERFACE_COMPILE_DEFINITIONS GMPRATIONAL)                                     # exact rationals in place of doubles
