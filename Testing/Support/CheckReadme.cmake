# The C++ of README.md is the marked region of the example that CTest runs, line by line.
#   cmake -DREADME=README.md -DEXAMPLE=Examples/Cxx/MassPropertiesPipeline.cxx -P CheckReadme.cmake
file(READ "${README}" readme)
file(READ "${EXAMPLE}" example)
if (NOT example MATCHES "// \\[twenty lines\\]\n(.*)\n  // \\[twenty lines\\]")
  message(FATAL_ERROR "${EXAMPLE} has no region between two lines '// [twenty lines]'.")
endif ()
string(REGEX REPLACE "(^|\n)  " "\\1" region "${CMAKE_MATCH_1}")
string(FIND "${readme}" "```cpp\n${region}\n```" found)
if (found EQUAL -1)
  message(FATAL_ERROR "The C++ in ${README} is not the region of ${EXAMPLE}:\n${region}")
endif ()
