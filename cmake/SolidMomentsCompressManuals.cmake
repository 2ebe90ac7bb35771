# CPack runs this before it makes a package: Debian requires compressed manual pages without a time stamp.
file(GLOB pages "${CPACK_TEMPORARY_DIRECTORY}/*/usr/share/man/man1/*.1")
if (pages)
  execute_process(COMMAND gzip -9n ${pages} RESULT_VARIABLE status)
  if (NOT status EQUAL 0)
    message(FATAL_ERROR "gzip ${pages}: ${status}")
  endif ()
endif ()
