# Compiler settings and output folders that every target of this tree shares.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(BUILD_SHARED_LIBS ON CACHE BOOL "Build shared libraries")
if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH "$ORIGIN:$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
set(SOLIDMOMENTS_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/SolidMoments")

# Several sources of a target are compiled as one, since headers and templates take more than half of the
# time. A file with macros of its own is left out (SKIP_UNITY_BUILD_INCLUSION); names in anonymous namespaces
# are unique in their module.
option(SOLIDMOMENTS_UNITY_BUILD "Compile several sources together: half the time for the whole tree, more for one changed file" ON)
mark_as_advanced(SOLIDMOMENTS_UNITY_BUILD)
set(CMAKE_UNITY_BUILD ${SOLIDMOMENTS_UNITY_BUILD})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

# A library that no symbol is needed of is not linked: programs load no OpenGL for headers of its modules.
add_link_options($<$<PLATFORM_ID:Linux>:LINKER:--as-needed>)

# Results are compared bit for bit between runs and backends: no contraction into fused operations.
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)

# Warnings for our own sources; generated wrapping code is VTK's. In a file of several sources GCC takes types
# of anonymous namespaces for those of a header.
function(solidmoments_warnings target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage> $<$<BOOL:${SOLIDMOMENTS_WARNINGS_AS_ERRORS}>:-Werror>>)
endfunction ()

# A module that uses headers of VTK's OpenGL classes, and links no OpenGL: VTK's registration of these
# classes, which every module that names VTK::RenderingOpenGL2 gets, is taken out.
function(solidmoments_without_opengl target)
  get_target_property(definitions ${target} COMPILE_DEFINITIONS)
  list(FILTER definitions EXCLUDE REGEX "^vtkRenderingCore_AUTOINIT")
  set_target_properties(${target} PROPERTIES COMPILE_DEFINITIONS "${definitions}")
endfunction ()
