# find_package(subdivlab 0.1 REQUIRED) gives
#   subdivlab::schemes      masks, schemes, evaluation
#   subdivlab::analysis     questions about schemes; schemes with it
#   subdivlab::optimize     objectives and solvers; analysis with it
#   subdivlab::experiments  claims, reports, files of polygons and meshes; optimize with it
# whose headers are included as in the source tree: "analysis/hoelder.h".
include("${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake")
if(DEFINED subdivlab_FOUND AND NOT subdivlab_FOUND)
  return()
endif()
include("${CMAKE_CURRENT_LIST_DIR}/subdivlab-targets.cmake")

foreach(subdivlab_component IN LISTS subdivlab_FIND_COMPONENTS)
  if(TARGET subdivlab::${subdivlab_component})
    set(subdivlab_${subdivlab_component}_FOUND TRUE)
  elseif(subdivlab_FIND_REQUIRED_${subdivlab_component})
    set(subdivlab_FOUND FALSE)
    set(subdivlab_NOT_FOUND_MESSAGE
        "subdivlab has no component ${subdivlab_component}; it has schemes, analysis, optimize and experiments")
  endif()
endforeach()
