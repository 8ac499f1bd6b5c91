# Fails unless PROGRAM ARGUMENTS prints exactly what FILE holds.
execute_process(COMMAND "${PROGRAM}" ${ARGUMENTS} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ "${FILE}" kept)
if(NOT printed STREQUAL kept)
  message(FATAL_ERROR "${FILE} is not what ${PROGRAM} prints; write it again")
endif()
