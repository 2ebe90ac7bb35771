# solidmoments_accept_python_modules(<package>), to be called before find_package(<package>), which is
# ParaView or VTK.
#
# Debian 13's ParaView says that its Python modules are files `NAME.so`, but they are
# `NAME.cpython-313-<machine>.so`, and find_package stops when it checks that all files exist. Nothing here
# links them. This leaves out the check of those modules that exist under such a longer name, in the caller's
# scope: CMake skips it for a target whose framework is a folder.
function(solidmoments_accept_python_modules package)
  set(folders "${${package}_DIR}")
  if (NOT folders)
    # No package has this version: the call only lists those that are there.
    find_package(${package} 9999 EXACT QUIET)
    set(folders)
    foreach (config IN LISTS ${package}_CONSIDERED_CONFIGS)
      get_filename_component(config "${config}" DIRECTORY)
      list(APPEND folders "${config}")
    endforeach ()
  endif ()
  foreach (folder IN LISTS folders)
    file(GLOB exports "${folder}/*Python*-targets-*.cmake" "${folder}/vtk/*Python*-targets-*.cmake")
    string(REGEX REPLACE "/lib/.*" "" prefix "${folder}")
    foreach (export IN LISTS exports)
      file(STRINGS "${export}" lines REGEX "_cmake_import_check_files_for_")
      foreach (line IN LISTS lines)
        if (line MATCHES "_cmake_import_check_files_for_([^ ]+) \"[^/]*/([^\"]+)\\.so\"")
          set(target "${CMAKE_MATCH_1}")
          set(file "${prefix}/${CMAKE_MATCH_2}")
          file(GLOB longer "${file}.*.so")
          if (longer AND NOT EXISTS "${file}.so")
            set("_cmake_import_check_xcframework_for_${target}" "${folder}" PARENT_SCOPE)
          endif ()
        endif ()
      endforeach ()
    endforeach ()
  endforeach ()
endfunction ()
