# Runs the example's use case with the installed program: the link handles every frame, at strength 0 it leaves the picture
# as it is, at strength 1 it does not.
function(report_of variable)
  execute_process(COMMAND ${program} --frames 3 --set view.size_px=[220,270] --report - ${ARGN}
    OUTPUT_VARIABLE report ERROR_VARIABLE log RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${program} ${ARGN}: exit status ${status}\n${log}")
  endif()
  set(${variable} ${report} PARENT_SCOPE)
endfunction()

report_of(plain --usecase 2dsv_2dsp)
report_of(unchanged --usecase ${use_case} --plugin ${plugin} --set edge.strength=0)
report_of(edges --usecase ${use_case} --plugin ${plugin} --set edge.strength=1)

string(JSON processed GET ${edges} links edge processed)
if(NOT processed EQUAL 3)
  message(FATAL_ERROR "the link processed ${processed} frames instead of 3")
endif()
foreach(run plain unchanged edges)
  string(JSON ${run}_sha256 GET ${${run}} output sha256)
endforeach()
if(NOT unchanged_sha256 STREQUAL plain_sha256)
  message(FATAL_ERROR "at strength 0 the picture differs from that of the chain without the link")
endif()
if(edges_sha256 STREQUAL plain_sha256)
  message(FATAL_ERROR "at strength 1 the picture is that of the chain without the link")
endif()
