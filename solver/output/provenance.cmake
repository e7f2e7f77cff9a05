# Writes provenance.cpp; run by every build, and without effect when the text has not changed.
# The commit is the last one that touched the solver: commits of results or text leave the binary as it is.
set(paths solver CMakeLists.txt)
set(DLD_COMMIT "unknown")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} log -1 --format=%H -- ${paths} WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed AND commit)
    execute_process(COMMAND ${GIT} status --porcelain -- ${paths} WORKING_DIRECTORY ${SOURCE_DIR}
      OUTPUT_VARIABLE changes ERROR_QUIET)
    set(DLD_COMMIT ${commit})
    if(changes)
      string(APPEND DLD_COMMIT "-dirty")
    endif()
  endif()
endif()
if(DLD_OPENMP)
  set(DLD_OPENMP "yes")
else()
  set(DLD_OPENMP "no")
endif()
configure_file(${SOURCE_DIR}/solver/output/provenance.cpp.in ${OUTPUT} @ONLY)
