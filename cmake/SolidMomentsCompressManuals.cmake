# CPack runs this before it packs: Debian wants manual pages compressed, without a time in them.
file(GLOB pages "${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/man/man1/*.1")
if (pages)
  execute_process(COMMAND gzip -9n ${pages} RESULT_VARIABLE status)
  if (NOT status EQUAL 0)
    message(FATAL_ERROR "gzip ${pages}: ${status}")
  endif ()
endif ()
